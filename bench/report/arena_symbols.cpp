// SPDX-License-Identifier: MIT
#include "report/arena_symbols.hpp"

#include <cmath>

namespace sspql::report {

void draw_box(Svg& svg, Point centre, double side, double turn_rad) {
    const auto corner = [&](double x, double y) {
        const double c = std::cos(turn_rad);
        const double s = std::sin(turn_rad);
        return Point{centre.x + 0.5 * side * (x * c - y * s), centre.y - 0.5 * side * (x * s + y * c)};
    };
    svg.polygon({corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)}, {Ink::box, Ink::box_edge, 2.0});
    const double in = 0.68;
    svg.polygon({corner(-in, -in), corner(in, -in), corner(in, in), corner(-in, in)}, {Ink::none, Ink::box_edge, 1.2});
    svg.line(corner(-in, -in), corner(in, in), {Ink::none, Ink::box_edge, 1.2});
    svg.line(corner(-in, in), corner(in, -in), {Ink::none, Ink::box_edge, 1.2});
}

void draw_robot(Svg& svg, Point centre, double radius, double heading_rad, const Style& style) {
    const auto around = [&](double scale, double angle) {
        return Point{centre.x + scale * radius * std::cos(heading_rad + angle),
                     centre.y - scale * radius * std::sin(heading_rad + angle)};
    };
    svg.circle(centre, radius, style);
    svg.polygon({around(0.86, 0.0), around(0.55, 0.95), around(0.30, 0.0), around(0.55, -0.95)}, {style.stroke});
}

void draw_arrow(Svg& svg, Point from, Point tip, Ink ink) {
    const double length = std::hypot(tip.x - from.x, tip.y - from.y);
    if (length < 13.0) return;
    const double dx = (tip.x - from.x) / length;
    const double dy = (tip.y - from.y) / length;
    const Point back{tip.x - 13.0 * dx, tip.y - 13.0 * dy};
    svg.line(from, {tip.x - 8.0 * dx, tip.y - 8.0 * dy}, {Ink::none, ink, 2.5, 1.0, "7 5"});
    svg.polygon({tip, {back.x - 6.5 * dy, back.y + 6.5 * dx}, {back.x + 6.5 * dy, back.y - 6.5 * dx}}, {ink});
}

}  // namespace sspql::report
