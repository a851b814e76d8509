// SPDX-License-Identifier: MIT
#include "report/belief_picture.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "report/numbers.hpp"

namespace sspql::report {

namespace {

constexpr double width = 720.0;
constexpr double margin = 4.0;
constexpr double gap = 18.0;
constexpr double head = 42.0;  // of a panel, for its two lines
constexpr double text_size = 13.0;
constexpr double legend_row = 26.0;
constexpr double symbol_side = 24.0;
constexpr Ink hope = Ink::series1;
constexpr Ink alarm = Ink::series0;

/// How an arrow to the right points the way of a move.
Point turned(Point p, GridMove move) {
    switch (move) {
        case GridMove::up: return {p.y, -p.x};
        case GridMove::down: return {-p.y, p.x};
        case GridMove::left: return {-p.x, -p.y};
        case GridMove::right: break;
    }
    return p;
}

Point placed(Point centre, double side, Point part, GridMove move) {
    const Point p = turned(part, move);
    return {centre.x + side * p.x, centre.y + side * p.y};
}

void draw_arrow(Svg& svg, Point centre, double side, GridMove move, Ink ink) {
    std::vector<Point> points;
    for (const Point& part : {Point{-0.26, -0.045}, Point{0.02, -0.045}, Point{0.02, -0.17}, Point{0.28, 0.0},
                              Point{0.02, 0.17}, Point{0.02, 0.045}, Point{-0.26, 0.045}}) {
        points.push_back(placed(centre, side, part, move));
    }
    svg.polygon(points, {ink});
}

void draw_untried(Svg& svg, Point centre, double side, GridMove move) {
    svg.circle(placed(centre, side, {0.39, 0.0}, move), 0.09 * side, {hope});
}

void draw_alarm(Svg& svg, Point centre, double side, GridMove move) {
    const std::vector<Point> bolt{placed(centre, side, {0.50, -0.48}, move), placed(centre, side, {0.38, -0.20}, move),
                                  placed(centre, side, {0.58, 0.04}, move), placed(centre, side, {0.38, 0.24}, move),
                                  placed(centre, side, {0.50, 0.48}, move)};
    svg.polyline(bolt, {Ink::none, Ink::paper, 0.24 * side});
    svg.polyline(bolt, {Ink::none, alarm, 0.13 * side});
}

void draw_robot(Svg& svg, Point centre, double side) {
    svg.circle(centre, 0.42 * side, {Ink::none, Ink::series6, 0.09 * side});
}

void draw_kind(Svg& svg, Point centre, double side, GridCellKind kind) {
    const Point corner{centre.x - 0.5 * side, centre.y - 0.5 * side};
    if (kind == GridCellKind::wall) svg.rect(corner, side, side, {Ink::wall});
    if (kind != GridCellKind::goal) return;
    svg.rect(corner, side, side, {Ink::goal});
    svg.text({centre.x, centre.y + 0.21 * side}, "G", {Ink::text, 0.58 * side, Anchor::middle, true});
}

/// 1 at the goal, 0.06 where it is believed farthest.
double strength(double steps, double most) { return 1.0 - 0.94 * std::clamp(steps / most, 0.0, 1.0); }

class BeliefPainter {
public:
    BeliefPainter(const std::vector<BeliefPanel>& panels, std::size_t rows, std::size_t columns, std::size_t across)
        : panels_(panels), rows_(rows), columns_(columns), across_(std::min(across, panels.size())) {
        const auto n = static_cast<double>(across_);
        panel_width_ = (width - 2.0 * margin - gap * (n - 1.0)) / n;
        side_ = panel_width_ / static_cast<double>(columns);
        panel_height_ = head + side_ * static_cast<double>(rows);
        for (const BeliefPanel& panel : panels) {
            for (const BeliefCell& cell : panel.cells) {
                if (cell.steps && std::isfinite(*cell.steps)) most_ = std::max(most_, *cell.steps);
                for (const bool alarmed : cell.alarmed) alarms_ = alarms_ || alarmed;
            }
        }
    }

    Svg paint(const std::string& label) {
        const auto lines = static_cast<double>((panels_.size() + across_ - 1) / across_);
        const double top = margin + lines * panel_height_ + (lines - 1.0) * gap + 8.0;
        Svg svg(width, top + 2.0 * legend_row + margin, label);
        for (std::size_t i = 0; i < panels_.size(); ++i) {
            paint_panel(svg, panels_[i],
                        {margin + static_cast<double>(i % across_) * (panel_width_ + gap),
                         margin + static_cast<double>(i / across_) * (panel_height_ + gap)});
        }
        paint_legend(svg, top);
        return svg;
    }

private:
    [[nodiscard]] Point centre(Point corner, std::size_t cell) const {
        return {corner.x + side_ * (static_cast<double>(cell % columns_) + 0.5),
                corner.y + side_ * (static_cast<double>(cell / columns_) + 0.5)};
    }

    void paint_panel(Svg& svg, const BeliefPanel& panel, Point corner) const {
        svg.text({corner.x, corner.y + 14.0}, panel.title, {Ink::text, text_size + 1.0, Anchor::start, true});
        svg.text({corner.x, corner.y + 31.0}, panel.subtitle, {Ink::faint, text_size - 1.0});
        corner.y += head;
        const double height = side_ * static_cast<double>(rows_);
        svg.rect(corner, panel_width_, height, {Ink::floor});
        for (std::size_t i = 0; i < panel.cells.size(); ++i) paint_ground(svg, panel.cells[i], centre(corner, i));
        const Style thin{Ink::none, Ink::axis, 0.7, 0.4};
        for (std::size_t i = 1; i < columns_; ++i) {
            const double x = corner.x + side_ * static_cast<double>(i);
            svg.line({x, corner.y}, {x, corner.y + height}, thin);
        }
        for (std::size_t i = 1; i < rows_; ++i) {
            const double y = corner.y + side_ * static_cast<double>(i);
            svg.line({corner.x, y}, {corner.x + panel_width_, y}, thin);
        }
        svg.rect(corner, panel_width_, height, {Ink::none, Ink::wall, 2.0}, 1.0);
        std::vector<Point> way;
        for (const std::size_t cell : panel.way) way.push_back(centre(corner, cell));
        if (way.size() > 1) svg.polyline(way, {Ink::none, Ink::series4, 0.17 * side_, 0.75});
        for (std::size_t i = 0; i < panel.cells.size(); ++i) paint_marks(svg, panel.cells[i], centre(corner, i));
        for (std::size_t i = 0; i < panel.cells.size(); ++i) {
            for (std::size_t m = 0; m < 4; ++m) {
                if (panel.cells[i].alarmed[m]) draw_alarm(svg, centre(corner, i), side_, static_cast<GridMove>(m));
            }
        }
        if (panel.robot) draw_robot(svg, centre(corner, *panel.robot), side_);
    }

    void paint_ground(Svg& svg, const BeliefCell& cell, Point at) const {
        draw_kind(svg, at, side_, cell.kind);
        if (cell.kind == GridCellKind::wall || cell.kind == GridCellKind::goal || !cell.steps) return;
        svg.rect({at.x - 0.5 * side_, at.y - 0.5 * side_}, side_, side_,
                 {Ink::value, Ink::none, 1.0, strength(*cell.steps, most_)});
    }

    void paint_marks(Svg& svg, const BeliefCell& cell, Point at) const {
        if (cell.kind == GridCellKind::wall || cell.kind == GridCellKind::goal || !cell.steps) return;
        for (std::size_t m = 0; m < 4; ++m) {
            if (cell.untried[m]) draw_untried(svg, at, side_, static_cast<GridMove>(m));
        }
        if (!cell.next) return;
        const bool hoped = cell.untried[static_cast<std::size_t>(*cell.next)];
        draw_arrow(svg, at, side_, *cell.next, hoped ? hope : Ink::text);
    }

    void paint_scale(Svg& svg, double top) const {
        constexpr double bar = 90.0;
        constexpr int steps = 18;
        const std::string name = "steps to the goal, as it believes:  0";
        const double baseline = top + 0.5 * legend_row + 0.35 * text_size;
        svg.text({margin, baseline}, name, {Ink::text, text_size});
        const Point corner{margin + text_width(name, text_size), top + 0.5 * legend_row - 7.0};
        for (int i = 0; i < steps; ++i) {
            svg.rect({corner.x + bar * i / steps, corner.y}, bar / steps, 14.0,
                     {Ink::value, Ink::none, 1.0, strength(i / (steps - 1.0), 1.0)});
        }
        svg.rect(corner, bar, 14.0, {Ink::none, Ink::axis, 0.8});
        svg.text({corner.x + bar + 6.0, baseline}, short_text(most_, 0), {Ink::text, text_size});
        symbol(svg, {corner.x + bar + 48.0, top}, "goal",
               [](Svg& s, Point at) { draw_kind(s, at, 0.8 * symbol_side, GridCellKind::goal); });
        symbol(svg, {corner.x + bar + 128.0, top}, "wall",
               [](Svg& s, Point at) { draw_kind(s, at, 0.8 * symbol_side, GridCellKind::wall); });
        symbol(svg, {corner.x + bar + 208.0, top}, "robot",
               [](Svg& s, Point at) { draw_robot(s, at, 0.8 * symbol_side); });
    }

    template <class Draw>
    static void symbol(Svg& svg, Point corner, const std::string& text, const Draw& draw) {
        const double middle = corner.y + 0.5 * legend_row;
        draw(svg, Point{corner.x + 0.5 * symbol_side, middle});
        svg.text({corner.x + symbol_side + 5.0, middle + 0.35 * text_size}, text, {Ink::text, text_size});
    }

    void paint_legend(Svg& svg, double top) const {
        paint_scale(svg, top);
        std::vector<std::pair<std::string, std::function<void(Svg&, Point)>>> symbols{
            {"what it would do", [](Svg& s, Point p) { draw_arrow(s, p, symbol_side, GridMove::right, Ink::text); }},
            {"... as a try", [](Svg& s, Point p) { draw_arrow(s, p, symbol_side, GridMove::right, hope); }},
            {"never tried", [](Svg& s, Point p) { draw_untried(s, p, symbol_side, GridMove::right); }},
        };
        if (alarms_) {
            symbols.emplace_back("alarm: changed", [](Svg& s, Point p) {
                draw_alarm(s, {p.x, p.y + 0.4 * symbol_side}, symbol_side, GridMove::up);
            });
        }
        double x = margin;
        for (const auto& [text, draw] : symbols) {
            symbol(svg, {x, top + legend_row}, text, draw);
            x += symbol_side + 5.0 + text_width(text, text_size) + 18.0;
        }
        const Style way{Ink::none, Ink::series4, 4.0, 0.75};
        symbol(svg, {x, top + legend_row}, "the way it came", [&](Svg& s, Point p) {
            s.polyline({{p.x - 10.0, p.y}, {p.x + 10.0, p.y}}, way);
        });
    }

    const std::vector<BeliefPanel>& panels_;
    std::size_t rows_;
    std::size_t columns_;
    std::size_t across_;
    double panel_width_ = 0.0;
    double panel_height_ = 0.0;
    double side_ = 0.0;
    double most_ = 1.0;
    bool alarms_ = false;
};

void check(const std::vector<BeliefPanel>& panels, std::size_t rows, std::size_t columns, std::size_t across) {
    if (panels.empty() || across == 0) throw std::invalid_argument("belief_picture: no panels");
    for (const BeliefPanel& panel : panels) {
        const std::size_t cells = panel.cells.size();
        const auto outside = [cells](std::size_t cell) { return cell >= cells; };
        if (cells == 0 || columns == 0 || cells % columns != 0 || cells / columns != rows) {
            throw std::invalid_argument("belief_picture: " + std::to_string(rows) + " rows of " +
                                        std::to_string(columns) + " columns are not " + std::to_string(cells) +
                                        " cells");
        }
        if ((panel.robot && outside(*panel.robot)) || std::any_of(panel.way.begin(), panel.way.end(), outside)) {
            throw std::invalid_argument("belief_picture: the robot is outside the map");
        }
    }
}

}  // namespace

Svg belief_picture(const std::vector<BeliefPanel>& panels, std::size_t rows, std::size_t columns, std::size_t across,
                   const std::string& label) {
    check(panels, rows, columns, across);
    return BeliefPainter(panels, rows, columns, across).paint(label);
}

}  // namespace sspql::report
