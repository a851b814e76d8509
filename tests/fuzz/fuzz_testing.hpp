// SPDX-License-Identifier: MIT
#pragma once

#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>

/// \file
/// What the fuzzed functions LLVMFuzzerTestOneInput share: findings that end the process, as a fuzzer expects.

namespace sspql::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

inline void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "does not hold: %s\n", what);
    std::abort();
}

/// The error says "NAME:LINE:COLUMN: ", both numbers from 1, and something after it, in printable characters.
inline void require_place(const std::exception& error, const std::string& name) {
    std::string_view text = error.what();
    bool good = text.substr(0, name.size() + 1) == name + ":";
    text.remove_prefix(good ? name.size() + 1 : 0);
    for (int i = 0; i < 2 && good; ++i) {
        const std::size_t digits = text.find_first_not_of("0123456789");
        good = digits != 0 && digits != std::string_view::npos && text[digits] == ':' && text.front() != '0';
        if (good) text.remove_prefix(digits + 1);
    }
    good = good && text.size() > 2 && text.front() == ' ';
    for (const char c : text) good = good && std::isprint(static_cast<unsigned char>(c)) != 0;
    if (good) return;
    std::fprintf(stderr, "no place, or no text: %s\n", error.what());
    std::abort();
}

}  // namespace sspql::fuzz
