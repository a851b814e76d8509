// SPDX-License-Identifier: MIT
#include "report/sensitivity_picture.hpp"

#include <algorithm>
#include <cmath>

#include <sspql/core/errors.hpp>

#include "report/numbers.hpp"

namespace sspql::report {

namespace {

constexpr std::size_t columns = 4;
constexpr double panel_width = 226.0;
constexpr double panel_height = 196.0;
constexpr double top = 34.0;   // for the legend
constexpr double side = 30.0;  // for the numbers of the axis
constexpr double text = 12.0;
constexpr double least = 0.5;

/// Draws one panel.
class PanelPainter {
public:
    PanelPainter(Svg& svg, const SensitivityPanel& panel, std::size_t position, double most)
        : svg_(svg),
          panel_(panel),
          most_(most),
          left_(side + panel_width * static_cast<double>(position % columns)),
          right_(left_ + panel_width - side),
          top_(top + panel_height * static_cast<double>(position / columns) + 24.0),
          bottom_(top_ + panel_height - 62.0) {}

    void paint() {
        const double band = step();
        svg_.rect({x_at(panel_.standard) - 0.5 * band, top_}, band, bottom_ - top_, {Ink::grid, Ink::none, 1.0, 0.6});
        for (double tick = least; tick <= most_ * 1.001; tick *= 2.0) {
            const double y = y_at(tick);
            const bool one = tick == 1.0;
            svg_.line({left_, y}, {right_, y}, {Ink::none, one ? Ink::axis : Ink::grid, 1.0, 1.0, one ? "4 3" : ""});
            svg_.text({left_ - 5.0, y + 0.35 * text}, short_text(tick, 2), {Ink::faint, text, Anchor::end});
        }
        for (std::size_t i = 0; i < panel_.values.size(); ++i) {
            const bool standard = i == panel_.standard;
            svg_.text({x_at(i), bottom_ + 1.3 * text}, panel_.values[i],
                      {standard ? Ink::text : Ink::faint, text, Anchor::middle, standard});
        }
        svg_.text({left_, top_ - 0.7 * text}, panel_.title, {Ink::text, text * 1.08, Anchor::start, true});
        for (std::size_t t = 0; t < panel_.tasks.size(); ++t) paint_task(t);
    }

private:
    [[nodiscard]] double step() const { return (right_ - left_) / static_cast<double>(panel_.values.size()); }
    [[nodiscard]] double x_at(std::size_t value) const { return left_ + (static_cast<double>(value) + 0.5) * step(); }
    [[nodiscard]] double y_at(double ratio) const {
        const double held = std::min(std::max(ratio, least), most_);
        return bottom_ - (bottom_ - top_) * std::log(held / least) / std::log(most_ / least);
    }

    void paint_task(std::size_t t) {
        const Ink ink = series_ink(t);
        const double shift = 2.5 * (static_cast<double>(t) - 0.5 * static_cast<double>(panel_.tasks.size() - 1));
        std::vector<Point> line;
        for (std::size_t i = 0; i < panel_.values.size(); ++i) {
            line.push_back({x_at(i) + shift, y_at(panel_.tasks[t][i].ratio)});
        }
        svg_.polyline(line, {Ink::none, ink, 1.6, 0.8});
        for (std::size_t i = 0; i < line.size(); ++i) {
            const Sensitivity& s = panel_.tasks[t][i];
            const double x = line[i].x;
            if (s.error > 0.0) {
                svg_.line({x, y_at(s.ratio - s.error)}, {x, y_at(s.ratio + s.error)}, {Ink::none, ink, 1.4});
            }
            svg_.circle(line[i], 3.4, {ink, Ink::paper, 1.0},
                        panel_.values[i] + ": " + short_text(s.ratio, 2) + " times");
            if (s.ratio < 1.05 * most_) continue;
            std::size_t beyond = 0;  // others there whose numbers stand above
            for (std::size_t u = 0; u < t; ++u) beyond += panel_.tasks[u][i].ratio >= 1.05 * most_ ? 1u : 0u;
            const bool last = i + 1 == line.size();
            svg_.text({x_at(i) + (last ? -9.0 : 9.0), top_ + text * (0.35 + 1.1 * static_cast<double>(beyond))},
                      short_text(s.ratio, 0), {ink, text, last ? Anchor::end : Anchor::start, true, 0.0, Ink::paper});
        }
    }

    Svg& svg_;
    const SensitivityPanel& panel_;
    double most_;
    double left_;
    double right_;
    double top_;
    double bottom_;
};

}  // namespace

Svg sensitivity_picture(const std::vector<SensitivityPanel>& panels, const std::vector<std::string>& tasks, double most,
                        const std::string& label) {
    for (const SensitivityPanel& panel : panels) {
        bool whole = panel.tasks.size() == tasks.size() && panel.standard < panel.values.size();
        for (const auto& ratios : panel.tasks) whole = whole && ratios.size() == panel.values.size();
        if (!whole) throw_invalid("panel", "have a ratio for each task and value", panel.title);
    }
    const std::size_t rows = (panels.size() + columns - 1) / columns;
    Svg svg(side + panel_width * static_cast<double>(columns), top + panel_height * static_cast<double>(rows), label);
    double x = side;
    for (std::size_t t = 0; t < tasks.size(); ++t) {
        svg.line({x, 15.0}, {x + 24.0, 15.0}, {Ink::none, series_ink(t), 1.6});
        svg.circle({x + 12.0, 15.0}, 3.4, {series_ink(t), Ink::paper, 1.0});
        svg.text({x + 31.0, 15.0 + 0.35 * text}, tasks[t], {Ink::text, text});
        x += 31.0 + text_width(tasks[t], text) + 22.0;
    }
    for (std::size_t i = 0; i < panels.size(); ++i) PanelPainter(svg, panels[i], i, most).paint();
    return svg;
}

}  // namespace sspql::report
