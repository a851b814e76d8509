// SPDX-License-Identifier: MIT
#include "report/axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "report/numbers.hpp"

namespace sspql::report {

namespace {

/// The least of 1, 2, 5 times a power of ten that is >= raw (> 0).
double nice_step(double raw) {
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= raw * (1.0 - 1e-9)) return factor * power;
    }
    return 10.0 * power;
}

/// Multiples of `step` from `from` to `to`, counted in whole multiples so that no rounding error adds up.
std::vector<double> multiples(double step, double from, double to) {
    std::vector<double> ticks;
    const double last = std::floor(to / step + 1e-9);
    for (double k = std::ceil(from / step - 1e-9); k <= last; k += 1.0) ticks.push_back(k * step + 0.0);
    return ticks;
}

}  // namespace

double Axis::fraction(double value) const {
    if (std::isnan(value)) return value;
    const double inside = std::clamp(value, low, high);
    if (logarithmic) return std::log(inside / low) / std::log(high / low);
    return (inside - low) / (high - low);
}

Axis linear_axis(double low, double high, int wanted) {
    Axis axis;
    if (!std::isfinite(low) || !std::isfinite(high)) {
        low = 0.0;
        high = 1.0;
    }
    if (!(low < high)) {
        const double margin = low == 0.0 ? 0.5 : 0.5 * std::fabs(low);
        high = low + margin;
        low -= margin;
    }
    const double step = nice_step((high - low) / wanted);
    axis.low = std::floor(low / step + 1e-9) * step;
    axis.high = std::ceil(high / step - 1e-9) * step;
    axis.ticks = multiples(step, axis.low, axis.high);
    return axis;
}

Axis whole_axis(double first, double last, int wanted) {
    Axis axis;
    axis.low = first;
    axis.high = last;
    if (!(last > first)) {
        axis.low = first - 0.5;
        axis.high = first + 0.5;
    }
    const double step = std::max(1.0, nice_step((axis.high - axis.low) / wanted));
    axis.ticks = multiples(step, axis.low, axis.high);
    // The first value gets its tick: "1" before 5, 10, 15.
    if (axis.ticks.empty() || axis.ticks.front() - first > 0.45 * step) axis.ticks.insert(axis.ticks.begin(), first);
    return axis;
}

Axis log_axis(double low, double high) {
    if (!(std::isfinite(low) && low > 0.0)) low = 1.0;
    if (!(std::isfinite(high) && high >= low)) high = low;
    std::vector<double> candidates;
    const double lowest = std::floor(std::log10(low));
    const double highest = std::ceil(std::log10(high)) + 1.0;
    const bool decades_only = std::log10(high / low) > 3.5;
    for (double exponent = lowest; exponent <= highest; exponent += 1.0) {
        for (const double factor : {1.0, 2.0, 5.0}) {
            if (factor == 1.0 || !decades_only) candidates.push_back(factor * std::pow(10.0, exponent));
        }
    }
    std::size_t from = 0;
    while (from + 1 < candidates.size() && candidates[from + 1] <= low * (1.0 + 1e-9)) ++from;
    std::size_t to = from + 1;
    while (to + 1 < candidates.size() && candidates[to] < high * (1.0 - 1e-9)) ++to;

    Axis axis;
    axis.logarithmic = true;
    axis.low = candidates[from];
    axis.high = candidates[to];
    axis.ticks.assign(candidates.begin() + static_cast<std::ptrdiff_t>(from),
                      candidates.begin() + static_cast<std::ptrdiff_t>(to) + 1);
    return axis;
}

std::string tick_text(double value) {
    const double size = std::fabs(value);
    if (size == 0.0 || (size >= 1e-4 && size < 1e6)) return short_text(value, 6);
    const double exponent = std::floor(std::log10(size) + 1e-9);
    return short_text(value / std::pow(10.0, exponent), 3) + "e" + short_text(exponent, 0);
}

}  // namespace sspql::report
