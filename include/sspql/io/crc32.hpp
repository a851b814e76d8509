// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace sspql::detail {

/// Remainders of all bytes, each followed by 0 to 7 zero bytes.
using CrcTables = std::array<std::array<std::uint32_t, 256>, 8>;

constexpr CrcTables make_crc_tables() noexcept {
    CrcTables tables{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t remainder = byte;
        for (int bit = 0; bit < 8; ++bit) remainder = (remainder >> 1) ^ ((remainder & 1u) != 0 ? 0xEDB88320u : 0u);
        tables[0][byte] = remainder;
    }
    for (std::size_t k = 1; k < 8; ++k) {
        for (std::size_t byte = 0; byte < 256; ++byte) {
            const std::uint32_t before = tables[k - 1][byte];
            tables[k][byte] = (before >> 8) ^ tables[0][before & 0xFFu];
        }
    }
    return tables;
}

inline constexpr CrcTables crc_tables = make_crc_tables();

/// The checksum of zlib, PNG and Ethernet (CRC-32, reflected polynomial EDB88320), eight bytes at a time: it must not
/// be slower than the disk. Notices every change of up to 32 neighbouring bits.
class Crc32 {
public:
    void add(const void* data, std::size_t size) noexcept {
        const auto* byte = static_cast<const unsigned char*>(data);
        std::uint32_t crc = crc_;
        for (; size >= 8; size -= 8, byte += 8) {
            crc ^= word(byte);
            const std::uint32_t high = word(byte + 4);
            crc = crc_tables[7][crc & 0xFFu] ^ crc_tables[6][(crc >> 8) & 0xFFu] ^ crc_tables[5][(crc >> 16) & 0xFFu] ^
                  crc_tables[4][crc >> 24] ^ crc_tables[3][high & 0xFFu] ^ crc_tables[2][(high >> 8) & 0xFFu] ^
                  crc_tables[1][(high >> 16) & 0xFFu] ^ crc_tables[0][high >> 24];
        }
        for (; size > 0; --size, ++byte) crc = (crc >> 8) ^ crc_tables[0][(crc ^ *byte) & 0xFFu];
        crc_ = crc;
    }

    [[nodiscard]] std::uint32_t value() const noexcept { return ~crc_; }

private:
    static std::uint32_t word(const unsigned char* byte) noexcept {
        return std::uint32_t{byte[0]} | std::uint32_t{byte[1]} << 8 | std::uint32_t{byte[2]} << 16 |
               std::uint32_t{byte[3]} << 24;
    }

    std::uint32_t crc_ = 0xFFFFFFFFu;
};

}  // namespace sspql::detail
