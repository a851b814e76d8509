// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>

/// \file
/// Checks for values that come from outside. Each throws std::invalid_argument whose text names the parameter, the
/// requirement and the offending value ("gamma must lie in [0, 1], got 1.5"), before anything was changed.

namespace sspql {

namespace detail {

/// A number as a person would type it, to 10 digits unless told otherwise; the same in every locale.
template <class T>
[[nodiscard]] std::string to_text(const T& value, int digits = 10) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(digits);
    out << value;
    return out.str();
}

/// The digits needed to see what is wrong with it: all of them where 10 would show another number ("got 1").
template <class T>
[[nodiscard]] std::string offending_text(const T& value) {
    std::string text = to_text(value);
    if constexpr (std::is_floating_point_v<T>) {
        std::istringstream in(text);
        in.imbue(std::locale::classic());
        T read{};
        if (std::isfinite(value) && !(in >> read && read == value)) {
            text = to_text(value, std::numeric_limits<T>::max_digits10);
        }
    }
    return text;
}

}  // namespace detail

/// Throws std::invalid_argument("NAME must REQUIREMENT, got VALUE").
template <class T>
[[noreturn]] void throw_invalid(const std::string& name, const std::string& requirement, const T& value) {
    throw std::invalid_argument(name + " must " + requirement + ", got " + detail::offending_text(value));
}

namespace detail {

[[noreturn]] inline void throw_outside(const char* name, double value, double least, double most) {
    throw_invalid(name, "lie in [" + to_text(least) + ", " + to_text(most) + "]", value);
}

}  // namespace detail

/// `value` itself if it is neither NaN nor infinite.
inline double require_finite(const char* name, double value) {
    if (!std::isfinite(value)) throw_invalid(name, "be finite", value);
    return value;
}

/// `value` itself if it lies in the closed interval [least, most].
inline double require_in(const char* name, double value, double least, double most) {
    if (!(value >= least && value <= most)) detail::throw_outside(name, value, least, most);
    return value;
}

/// `value` itself if it is finite and > 0.
inline double require_positive(const char* name, double value) {
    if (!(std::isfinite(value) && value > 0.0)) throw_invalid(name, "be finite and > 0", value);
    return value;
}

/// `value` itself if it is finite and >= 0.
inline double require_not_negative(const std::string& name, double value) {
    if (!(std::isfinite(value) && value >= 0.0)) throw_invalid(name, "be finite and >= 0", value);
    return value;
}

}  // namespace sspql
