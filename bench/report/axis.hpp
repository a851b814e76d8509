// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace sspql::report {

/// One axis of a chart: the values it spans, where it has ticks, and where a value lies on it.
struct Axis {
    double low = 0.0;  ///< < high
    double high = 1.0;
    bool logarithmic = false;   ///< then low > 0
    std::vector<double> ticks;  ///< ascending, within [low, high]

    /// 0 at `low`, 1 at `high`; values beyond the ends are drawn at the ends. NaN stays NaN.
    [[nodiscard]] double fraction(double value) const;
};

/// Spans [low, high], widened to multiples of a step of 1, 2 or 5 times a power of ten, with about `wanted` ticks.
/// Equal or non-finite ends give an axis all the same.
[[nodiscard]] Axis linear_axis(double low, double high, int wanted);

/// Spans the whole numbers first to last exactly, with about `wanted` ticks on whole numbers.
[[nodiscard]] Axis whole_axis(double first, double last, int wanted);

/// Spans [low, high], widened to ticks at 1, 2 and 5 times powers of ten (powers of ten alone when they are many).
/// Ends that are not positive and finite give an axis all the same.
[[nodiscard]] Axis log_axis(double low, double high);

/// 0.5, 40, 1500, 2e6.
[[nodiscard]] std::string tick_text(double value);

}  // namespace sspql::report
