// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

/// \file
/// Users' texts and numbers as other programs' formats want them.

namespace sspql::detail {

/// The length of the well-formed UTF-8 character at the beginning of the text; 0 if there is none.
inline std::size_t utf8_length(std::string_view text) noexcept {
    const auto byte = [text](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const unsigned first = byte(0);
    if (text.empty()) return 0;
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4) return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return 0;
    }
    const bool overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
    const bool surrogate = first == 0xED && byte(1) >= 0xA0;
    return overlong || surrogate || (first == 0xF4 && byte(1) >= 0x90) ? 0 : length;
}

/// The text with what is no UTF-8, and control characters but line ends, replaced by '?'.
inline std::string printable(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const auto first = static_cast<unsigned char>(text.front());
        const bool control = (first < 0x20 && first != '\n') || first == 0x7F;
        if (length == 0 || control) {
            out += '?';
        } else {
            out.append(text.substr(0, length));
        }
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return out;
}

/// A string of the DOT language that shows this text: quotes and backslashes escaped, `&` begins no entity.
inline std::string dot_quoted(std::string_view text) {
    std::string out = "\"";
    for (const char c : printable(text)) {
        switch (c) {
            case '"': out += "\\\""; break;
            case '\\': out += "\\\\"; break;
            case '\n': out += "\\n"; break;
            case '&': out += "&amp;"; break;
            default: out += c;
        }
    }
    return out + '"';
}

/// A field of a CSV file (RFC 4180): quoted where it must be.
inline std::string csv_quoted(std::string_view text) {
    const std::string clean = printable(text);
    if (clean.find_first_of(",\"\n") == std::string::npos) return clean;
    std::string out = "\"";
    for (const char c : clean) {
        if (c == '"') out += '"';
        out += c;
    }
    return out + '"';
}

/// The shortest digits that give the same double again, in every locale; nothing for what is not finite.
inline std::string exact_text(double value) {
    if (!std::isfinite(value)) return {};
    std::array<char, 40> text;
    const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), result.ptr};
}

/// The number with so many digits after its point, in every locale.
inline std::string fixed_text(double value, int digits) {
    std::array<char, 400> text;
    const auto result = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, digits);
    return {text.data(), result.ptr};
}

}  // namespace sspql::detail
