// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "report/svg.hpp"

namespace sspql::report {

/// One line of a chart. NaN leaves a gap.
struct Series {
    std::string name{};
    std::vector<double> mean{};
    std::vector<double> spread{};  ///< the band is mean +- spread; empty (or NaN, or 0) for none
    std::vector<double> x{};       ///< ascending whole numbers; empty: 1, 2, 3, ...
    Ink ink = Ink::none;           ///< none: by position among the series
};

/// A horizontal line to compare with, such as the best value possible; it stands in the legend.
struct ReferenceLine {
    std::string label;
    double value = 0.0;
};

struct ValueRange {
    double low = 0.0;
    double high = 1.0;
};

/// What `line_chart` draws. The x axis counts (episodes, steps); the y axis starts at 0 unless values are negative or
/// the scale is logarithmic.
struct LineChart {
    std::string title{};  ///< inside the picture; empty for none
    std::string x_label{};
    std::string y_label{};
    std::vector<Series> series{};
    std::optional<ReferenceLine> reference{};
    std::optional<ValueRange> y_range{};  ///< none: the values'; give all charts of a row the same
    bool logarithmic = false;             ///< y; values <= 0 are then left out
    bool legend = true;
    double width = 640.0;  ///< in units of the picture, as are the next two
    double height = 380.0;
    double text_size = 14.0;
};

/// What the y axis has to show: means, bands and reference; 0 included on a linear scale. Nothing to show: [0, 1].
[[nodiscard]] ValueRange value_range(const LineChart& chart);

/// Draws the chart. No series, empty series and single points are fine.
[[nodiscard]] Svg line_chart(const LineChart& chart);

/// One chart for each series, named by it, in its colour of the joint chart, on the same axes, without legend: to be
/// drawn in a row with the given size.
[[nodiscard]] std::vector<LineChart> small_multiples(const LineChart& chart, double width, double height);

}  // namespace sspql::report
