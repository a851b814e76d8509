// SPDX-License-Identifier: MIT
#include "report/line_chart.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "report/chart_layout.hpp"
#include "report/numbers.hpp"

namespace sspql::report {

namespace {

constexpr double line_width = 2.2;
constexpr std::size_t markers_per_line = 10;

/// From the ninth series on the colours repeat, dashed.
const char* dash_of(std::size_t position) { return position < series_inks ? "" : "9 4"; }

/// Draws one chart.
class ChartPainter {
public:
    explicit ChartPainter(const LineChart& chart)
        : chart_(chart),
          layout_(layout_of(chart)),
          size_(chart.text_size),
          svg_(chart.width, chart.height, label_of(chart)) {}

    Svg paint() {
        paint_axes();
        if (is_empty()) {
            svg_.text({0.5 * (layout_.left + layout_.right), 0.5 * (layout_.top + layout_.bottom)}, "no data",
                      {Ink::faint, size_, Anchor::middle});
        }
        for (std::size_t i = 0; i < chart_.series.size(); ++i) paint_bands(chart_.series[i], ink_of(chart_, i));
        if (chart_.reference && is_drawn(chart_.reference->value, layout_.y.logarithmic)) {
            const double y = y_at(chart_.reference->value);
            svg_.line({layout_.left, y}, {layout_.right, y}, {Ink::none, Ink::text, 1.5, 1.0, "7 4"});
        }
        for (std::size_t i = 0; i < chart_.series.size(); ++i) paint_line(chart_.series[i], i);
        paint_texts();
        return std::move(svg_);
    }

private:
    static std::string label_of(const LineChart& chart) {
        std::string label = chart.title.empty() ? "Chart" : chart.title;
        label += ": " + chart.y_label + " over " + chart.x_label;
        for (std::size_t i = 0; i < chart.series.size(); ++i) label += (i == 0 ? "; " : ", ") + chart.series[i].name;
        return label;
    }

    [[nodiscard]] bool is_empty() const {
        for (const Series& series : chart_.series) {
            for (const double value : series.mean) {
                if (is_drawn(value, layout_.y.logarithmic)) return false;
            }
        }
        return true;
    }

    [[nodiscard]] double x_at(double value) const {
        return layout_.left + (layout_.right - layout_.left) * layout_.x.fraction(value);
    }
    [[nodiscard]] double y_at(double value) const {
        return layout_.bottom - (layout_.bottom - layout_.top) * layout_.y.fraction(value);
    }
    [[nodiscard]] Point at(const Series& series, std::size_t i, double value) const {
        return {x_at(x_of(series, i)), y_at(value)};
    }

    void paint_axes() {
        for (const double tick : layout_.y.ticks) {
            const double y = y_at(tick);
            svg_.line({layout_.left, y}, {layout_.right, y}, {Ink::none, Ink::grid});
            svg_.text({layout_.left - 0.5 * size_, y + 0.35 * size_}, tick_text(tick),
                      {Ink::faint, size_, Anchor::end});
        }
        for (const double tick : layout_.x.ticks) {
            const double x = x_at(tick);
            svg_.line({x, layout_.bottom}, {x, layout_.bottom + 0.35 * size_}, {Ink::none, Ink::axis});
            svg_.text({x, layout_.bottom + 1.45 * size_}, tick_text(tick), {Ink::faint, size_, Anchor::middle});
        }
        svg_.line({layout_.left, layout_.bottom}, {layout_.right, layout_.bottom}, {Ink::none, Ink::axis, 1.2});
    }

    void paint_texts() {
        const double middle = 0.5 * (layout_.left + layout_.right);
        if (!chart_.title.empty())
            svg_.text({layout_.left, 1.15 * size_}, chart_.title, {Ink::text, size_ * 1.08, Anchor::start, true});
        svg_.text({middle, chart_.height - 0.45 * size_}, chart_.x_label, {Ink::text, size_, Anchor::middle});
        const Point beside{1.05 * size_, 0.5 * (layout_.top + layout_.bottom)};
        svg_.text(beside, chart_.y_label, {Ink::text, size_, Anchor::middle, false, -90.0});
        for (std::size_t i = 0; i < layout_.legend.size(); ++i) {
            const LegendEntry& entry = layout_.legend[i];
            const double y = entry.baseline;
            const double line_y = y - 0.35 * size_;
            const bool is_reference = i >= chart_.series.size();
            svg_.line({entry.x, line_y}, {entry.x + legend_sample, line_y},
                      {Ink::none, entry.ink, is_reference ? 1.5 : line_width, 1.0, is_reference ? "7 4" : dash_of(i)});
            if (!is_reference) paint_marker({entry.x + 0.5 * legend_sample, line_y}, i, entry.ink, {});
            svg_.text({entry.x + legend_sample + legend_gap, y}, entry.text, {Ink::text, size_});
        }
    }

    /// A band per unbroken stretch of points.
    void paint_bands(const Series& series, Ink ink) {
        std::vector<Point> upper;
        std::vector<Point> lower;
        bool visible = false;
        for (std::size_t i = 0; i <= series.mean.size(); ++i) {
            if (i < series.mean.size() && is_drawn(series.mean[i], layout_.y.logarithmic)) {
                const double spread = spread_of(series, i);
                visible = visible || spread > 0.0;
                upper.push_back(at(series, i, series.mean[i] + spread));
                lower.push_back(at(series, i, series.mean[i] - spread));
                continue;
            }
            if (visible && upper.size() > 1) {
                upper.insert(upper.end(), lower.rbegin(), lower.rend());
                svg_.polygon(upper, {ink, Ink::none, 1.0, 0.18});
            } else if (visible) {
                svg_.line(upper.front(), lower.front(), {Ink::none, ink, 1.5, 0.5});
            }
            upper.clear();
            lower.clear();
            visible = false;
        }
    }

    void paint_line(const Series& series, std::size_t position) {
        const Ink ink = ink_of(chart_, position);
        svg_.begin_group("series", series.name);
        std::vector<Point> stretch;
        for (std::size_t i = 0; i <= series.mean.size(); ++i) {
            if (i < series.mean.size() && is_drawn(series.mean[i], layout_.y.logarithmic)) {
                stretch.push_back(at(series, i, series.mean[i]));
                continue;
            }
            if (stretch.size() > 1) svg_.polyline(stretch, {Ink::none, ink, line_width, 1.0, dash_of(position)});
            if (stretch.size() == 1) svg_.circle(stretch.front(), 1.6 * line_width, {ink});
            stretch.clear();
        }
        // Lines are told apart by their markers too; those of neighbours stand at different places.
        const std::size_t every = std::max<std::size_t>(1, series.mean.size() / markers_per_line);
        for (std::size_t i = position % every; i < series.mean.size(); i += every) {
            if (!is_drawn(series.mean[i], layout_.y.logarithmic)) continue;
            const std::string tip = series.name + ", " + chart_.x_label + " " + tick_text(x_of(series, i)) + ": " +
                                    short_text(series.mean[i], 1) + " " + chart_.y_label;
            paint_marker(at(series, i, series.mean[i]), position, ink, tip);
        }
        svg_.end_group();
    }

    /// Disc, square, diamond, triangle in turn.
    void paint_marker(Point p, std::size_t position, Ink ink, const std::string& tip) {
        const double r = 1.9 * line_width;
        const Style style{ink, Ink::paper, 1.2};
        if (!tip.empty()) svg_.begin_group("", tip);
        switch (position % 4) {
            case 0: svg_.circle(p, r, style); break;
            case 1: svg_.rect({p.x - 0.9 * r, p.y - 0.9 * r}, 1.8 * r, 1.8 * r, style); break;
            case 2:
                svg_.polygon({{p.x, p.y - 1.3 * r}, {p.x + 1.3 * r, p.y}, {p.x, p.y + 1.3 * r}, {p.x - 1.3 * r, p.y}},
                             style);
                break;
            default:
                svg_.polygon({{p.x, p.y - 1.2 * r}, {p.x + 1.15 * r, p.y + 0.9 * r}, {p.x - 1.15 * r, p.y + 0.9 * r}},
                             style);
        }
        if (!tip.empty()) svg_.end_group();
    }

    const LineChart& chart_;
    ChartLayout layout_;
    double size_;
    Svg svg_;
};

}  // namespace

Svg line_chart(const LineChart& chart) { return ChartPainter(chart).paint(); }

}  // namespace sspql::report
