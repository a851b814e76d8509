// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include <sspql/core/version.hpp>

/// \file
/// What writer and reader of checkpoints agree upon; docs/checkpoint-format.md describes it byte by byte.

namespace sspql::detail {

/// Not text (first byte), and damaged by whoever changes line ends or cuts at control-Z, as PNG's.
inline constexpr std::array<unsigned char, 8> checkpoint_magic{0xF3, 'S', 'S', 'P', 'Q', '\r', '\n', 0x1A};

/// Raised when what follows the header changes its meaning; this library writes it, and reads it and all before.
inline constexpr std::uint32_t checkpoint_format = 1;

inline constexpr std::uint32_t library_version =
    SSPQL_VERSION_MAJOR * 1000000 + SSPQL_VERSION_MINOR * 1000 + SSPQL_VERSION_PATCH;

inline constexpr std::size_t section_name_size = 16;  // padded with zeros
inline constexpr std::size_t largest_chunk = std::size_t{1} << 16;
inline constexpr const char* last_section = "end";

using SectionName = std::array<char, section_name_size>;

/// \throws std::invalid_argument for a name that is empty or has more than 15 characters.
inline SectionName section_name(const std::string& name) {
    if (name.empty() || name.size() >= section_name_size) {
        throw std::invalid_argument("name of a section must have 1 to 15 characters, got '" + name + "'");
    }
    SectionName padded{};
    for (std::size_t i = 0; i < name.size(); ++i) padded[i] = name[i];
    return padded;
}

inline std::array<unsigned char, 4> little_endian(std::uint32_t value) noexcept {
    return {static_cast<unsigned char>(value), static_cast<unsigned char>(value >> 8),
            static_cast<unsigned char>(value >> 16), static_cast<unsigned char>(value >> 24)};
}

inline std::uint32_t from_little_endian(const unsigned char* bytes) noexcept {
    return std::uint32_t{bytes[0]} | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 |
           std::uint32_t{bytes[3]} << 24;
}

inline std::string version_text(std::uint32_t version) {
    return std::to_string(version / 1000000) + "." + std::to_string(version / 1000 % 1000) + "." +
           std::to_string(version % 1000);
}

}  // namespace sspql::detail
