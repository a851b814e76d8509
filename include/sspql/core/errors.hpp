// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>

/// \file
/// Checks for values that come from outside. Each throws std::invalid_argument whose text names the parameter, the
/// requirement and the offending value ("gamma must lie in [0, 1], got 1.5"), before anything was changed.

namespace sspql {

namespace detail {

/// A number as a person would type it: shortest of %g and the digits needed to see what is wrong with it.
template <class T>
[[nodiscard]] std::string to_text(const T& value) {
    std::ostringstream out;
    out.precision(10);
    out << value;
    return out.str();
}

}  // namespace detail

/// Throws std::invalid_argument("NAME must REQUIREMENT, got VALUE").
template <class T>
[[noreturn]] void throw_invalid(const std::string& name, const std::string& requirement, const T& value) {
    throw std::invalid_argument(name + " must " + requirement + ", got " + detail::to_text(value));
}

/// `value` itself if it is neither NaN nor infinite.
inline double require_finite(const char* name, double value) {
    if (!std::isfinite(value)) throw_invalid(name, "be finite", value);
    return value;
}

/// `value` itself if it lies in the closed interval [least, most].
inline double require_in(const char* name, double value, double least, double most) {
    if (!(value >= least && value <= most)) {
        throw_invalid(name, "lie in [" + detail::to_text(least) + ", " + detail::to_text(most) + "]", value);
    }
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
