// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/axis.hpp"
#include "report/line_chart.hpp"

/// \file
/// Where the parts of a line chart stand, before anything is drawn.

namespace sspql::report {

/// The i-th point's x, its band's half width (0 for none), the series' colour, and whether a value can be shown at all.
[[nodiscard]] double x_of(const Series& series, std::size_t i);
[[nodiscard]] double spread_of(const Series& series, std::size_t i);
[[nodiscard]] Ink ink_of(const LineChart& chart, std::size_t series);
[[nodiscard]] bool is_drawn(double value, bool logarithmic);

/// A sample of `legend_sample` units, a gap, the text.
struct LegendEntry {
    std::string text;
    Ink ink = Ink::none;
    double x = 0.0;
    double baseline = 0.0;
};

inline constexpr double legend_sample = 26.0;
inline constexpr double legend_gap = 8.0;

/// Axes, legend and the rectangle between the axes, in the picture's units.
struct ChartLayout {
    Axis x;
    Axis y;
    std::vector<LegendEntry> legend;  ///< series in order, then the reference line; empty if not wanted
    double left = 0.0;
    double right = 0.0;
    double top = 0.0;
    double bottom = 0.0;
};

[[nodiscard]] ChartLayout layout_of(const LineChart& chart);

}  // namespace sspql::report
