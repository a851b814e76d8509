// SPDX-License-Identifier: MIT
#include "report/chart_layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sspql::report {

namespace {

Axis x_axis(const LineChart& chart, int wanted) {
    double first = std::numeric_limits<double>::infinity();
    double last = -first;
    for (const Series& series : chart.series) {
        if (series.mean.empty()) continue;
        first = std::min(first, x_of(series, 0));
        last = std::max(last, x_of(series, series.mean.size() - 1));
    }
    return first <= last ? whole_axis(first, last, wanted) : whole_axis(0.0, 1.0, 1);
}

Axis y_axis(const LineChart& chart, int wanted) {
    const ValueRange range = chart.y_range ? *chart.y_range : value_range(chart);
    return chart.logarithmic ? log_axis(range.low, range.high) : linear_axis(range.low, range.high, wanted);
}

/// Entries from left to right, wrapping, below `top`. Returns where the last row ends.
double place_legend(const LineChart& chart, double top, ChartLayout& layout) {
    if (!chart.legend) return top;
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        layout.legend.push_back({chart.series[i].name, ink_of(chart, i), 0.0, 0.0});
    }
    if (chart.reference) layout.legend.push_back({chart.reference->label, Ink::text, 0.0, 0.0});
    if (layout.legend.empty()) return top;
    const double row_height = 1.6 * chart.text_size;
    double x = layout.left;
    double bottom = top + row_height;
    for (LegendEntry& entry : layout.legend) {
        const double width = legend_sample + legend_gap + text_width(entry.text, chart.text_size);
        if (x > layout.left && x + width > layout.right) {
            x = layout.left;
            bottom += row_height;
        }
        entry.x = x;
        entry.baseline = bottom - 0.5 * chart.text_size;
        x += width + chart.text_size;
    }
    return bottom;
}

}  // namespace

double x_of(const Series& series, std::size_t i) {
    return i < series.x.size() ? series.x[i] : static_cast<double>(i + 1);
}

double spread_of(const Series& series, std::size_t i) {
    return i < series.spread.size() && std::isfinite(series.spread[i]) ? series.spread[i] : 0.0;
}

Ink ink_of(const LineChart& chart, std::size_t i) {
    return chart.series[i].ink == Ink::none ? series_ink(i) : chart.series[i].ink;
}

bool is_drawn(double value, bool logarithmic) { return std::isfinite(value) && (!logarithmic || value > 0.0); }

ChartLayout layout_of(const LineChart& chart) {
    const double size = chart.text_size;
    ChartLayout layout;
    layout.y = y_axis(chart, chart.height < 300.0 ? 4 : 6);
    double widest = 0.0;
    for (const double tick : layout.y.ticks) widest = std::max(widest, text_width(tick_text(tick), size));
    layout.left = widest + size * (chart.y_label.empty() ? 1.0 : 2.2);
    // As many ticks as there is room for; the last label is centred on the axis's end.
    const double label = std::max(text_width("00", size), text_width(tick_text(x_axis(chart, 1).high), size));
    layout.right = chart.width - std::max(size, 0.5 * label + 2.0);
    layout.x = x_axis(chart, std::clamp(static_cast<int>((layout.right - layout.left) / (2.6 * label)), 2, 10));
    const double title_height = chart.title.empty() ? 0.0 : 1.7 * size;
    layout.top = place_legend(chart, title_height, layout) + 0.8 * size;
    layout.bottom = chart.height - size * (chart.x_label.empty() ? 1.9 : 3.2);
    return layout;
}

ValueRange value_range(const LineChart& chart) {
    const bool logarithmic = chart.logarithmic;
    ValueRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    const auto include = [&](double value) {
        if (!is_drawn(value, logarithmic)) return;
        range.low = std::min(range.low, value);
        range.high = std::max(range.high, value);
    };
    for (const Series& series : chart.series) {
        for (std::size_t i = 0; i < series.mean.size(); ++i) {
            if (!is_drawn(series.mean[i], logarithmic)) continue;
            include(series.mean[i]);
            include(series.mean[i] + spread_of(series, i));
            // On a log scale a band that nearly reaches 0 would squeeze everything else into the top.
            if (!logarithmic) include(series.mean[i] - spread_of(series, i));
        }
    }
    if (chart.reference) include(chart.reference->value);
    if (!(range.low <= range.high)) return {logarithmic ? 1.0 : 0.0, logarithmic ? 10.0 : 1.0};
    if (logarithmic) return range;
    // A band below 0 around means that are not (steps) is cut at 0.
    bool negative = false;
    for (const Series& series : chart.series) {
        for (const double value : series.mean) negative = negative || value < 0.0;
    }
    if (!negative && !(chart.reference && chart.reference->value < 0.0)) range.low = 0.0;
    range.high = std::max(range.high, 0.0);
    return range;
}

std::vector<LineChart> small_multiples(const LineChart& chart, double width, double height) {
    std::vector<LineChart> charts;
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        LineChart one = chart;
        one.title = chart.series[i].name;
        one.series = {chart.series[i]};
        one.series.front().ink = ink_of(chart, i);
        one.y_range = chart.y_range ? *chart.y_range : value_range(chart);
        one.legend = false;
        one.width = width;
        one.height = height;
        charts.push_back(one);
    }
    return charts;
}

}  // namespace sspql::report
