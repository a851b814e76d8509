// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sspql/io/crc32_folding.hpp>

namespace sspql::detail {

/// Remainders of all bytes, each followed by 0 to 15 zero bytes.
using CrcTables = std::array<std::array<std::uint32_t, 256>, 16>;

constexpr CrcTables make_crc_tables() noexcept {
    CrcTables tables{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t remainder = byte;
        for (int bit = 0; bit < 8; ++bit) remainder = (remainder >> 1) ^ ((remainder & 1u) != 0 ? crc_polynomial : 0u);
        tables[0][byte] = remainder;
    }
    for (std::size_t k = 1; k < 16; ++k) {
        for (std::size_t byte = 0; byte < 256; ++byte) {
            const std::uint32_t before = tables[k - 1][byte];
            tables[k][byte] = (before >> 8) ^ tables[0][before & 0xFFu];
        }
    }
    return tables;
}

inline constexpr CrcTables crc_tables = make_crc_tables();

/// The checksum of zlib, PNG and Ethernet (CRC-32, reflected polynomial EDB88320), 16 bytes at a time or, where the
/// processor can, 64: it must not be slower than the disk. Notices every change of up to 32 neighbouring bits.
class Crc32 {
public:
    void add(const void* data, std::size_t size) noexcept {
        const auto* byte = static_cast<const unsigned char*>(data);
#if SSPQL_HAS_CRC_FOLDING
        if (size >= 128 && can_fold_crc()) {
            const std::size_t blocks = size / 16;
            std::array<unsigned char, 16> folded;
            fold_crc(crc_, byte, blocks, folded.data());
            crc_ = 0;
            add_by_tables(folded.data(), folded.size());
            byte += 16 * blocks;
            size -= 16 * blocks;
        }
#endif
        add_by_tables(byte, size);
    }

    /// The same on any processor.
    void add_by_tables(const unsigned char* byte, std::size_t size) noexcept {
        std::uint32_t crc = crc_;
        for (; size >= 16; size -= 16, byte += 16) {
            crc = four(crc_tables.data() + 12, word(byte) ^ crc) ^ four(crc_tables.data() + 8, word(byte + 4)) ^
                  four(crc_tables.data() + 4, word(byte + 8)) ^ four(crc_tables.data(), word(byte + 12));
        }
        for (; size > 0; --size, ++byte) crc = (crc >> 8) ^ crc_tables[0][(crc ^ *byte) & 0xFFu];
        crc_ = crc;
    }

    [[nodiscard]] std::uint32_t value() const noexcept { return ~crc_; }

private:
    /// The remainder of four bytes, followed by as many as table[0] says.
    static std::uint32_t four(const std::array<std::uint32_t, 256>* table, std::uint32_t bytes) noexcept {
        return table[3][bytes & 0xFFu] ^ table[2][(bytes >> 8) & 0xFFu] ^ table[1][(bytes >> 16) & 0xFFu] ^
               table[0][bytes >> 24];
    }

    static std::uint32_t word(const unsigned char* byte) noexcept {
        return std::uint32_t{byte[0]} | std::uint32_t{byte[1]} << 8 | std::uint32_t{byte[2]} << 16 |
               std::uint32_t{byte[3]} << 24;
    }

    std::uint32_t crc_ = 0xFFFFFFFFu;
};

}  // namespace sspql::detail
