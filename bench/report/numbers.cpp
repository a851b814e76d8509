// SPDX-License-Identifier: MIT
#include "report/numbers.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace sspql::report {

std::string fixed_text(double value, int digits) {
    if (!std::isfinite(value)) return "n/a";
    std::array<char, 400> buffer{};  // the greatest double has 309 digits before the point
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, digits).ptr;
    std::string text(buffer.data(), end);
    if (text.front() == '-' && text.find_first_of("123456789") == std::string::npos) text.erase(0, 1);
    return text;
}

std::string short_text(double value, int most_digits) {
    std::string text = fixed_text(value, most_digits);
    if (text.find('.') == std::string::npos) return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

std::string exact_text(double value) {
    if (!std::isfinite(value)) return {};
    std::array<char, 40> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return std::string(buffer.data(), end);
}

}  // namespace sspql::report
