// SPDX-License-Identifier: MIT
#include "shards/shard.hpp"

#include <charconv>
#include <stdexcept>
#include <string_view>

namespace sspql::shards {

namespace {

/// 0 for what is no number of shards.
std::size_t number_of(std::string_view digits) {
    std::size_t number = 0;
    const char* end = digits.data() + digits.size();
    const auto result = std::from_chars(digits.data(), end, number);
    return result.ec == std::errc{} && result.ptr == end && number <= Shard::most ? number : 0;
}

}  // namespace

std::string text_of(const Shard& shard) { return std::to_string(shard.index + 1) + "/" + std::to_string(shard.count); }

Shard parse_shard(const std::string& text) {
    const std::size_t slash = text.find('/');
    if (slash != std::string::npos) {
        const std::size_t number = number_of(std::string_view(text).substr(0, slash));
        const std::size_t count = number_of(std::string_view(text).substr(slash + 1));
        if (number >= 1 && number <= count) return {number - 1, count};
    }
    throw std::invalid_argument("--shard must be i/n with i from 1 to n, and n at most " + std::to_string(Shard::most) +
                                ", got '" + text + "'");
}

}  // namespace sspql::shards
