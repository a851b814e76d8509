// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <sspql/sim/geometry.hpp>
#include <sspql/sim/pose.hpp>

/// \file
/// A rectangle at any angle, the outline of a robot with a flat front: its gaps to the box and to the walls. Pure
/// functions of values, O(1), no allocation, safe from any thread. Metres; all arguments must be finite (unchecked).

namespace sspql::sim {

/// A rectangle centred on a pose, its length along the heading.
struct Rectangle {
    Point centre{};               ///< in the arena's frame
    Direction axis{};             ///< where its length points
    double half_length_m = 0.20;  ///< along the axis
    double half_width_m = 0.172;  ///< across it
};

/// The square as a rectangle.
[[nodiscard]] constexpr Rectangle rectangle_of(const Square& square) noexcept {
    return {square.centre, square.axis, square.half_side_m, square.half_side_m};
}

/// The point in the rectangle's own frame: origin in its centre, +x along its length.
[[nodiscard]] constexpr Point in_frame_of(const Rectangle& r, const Point& p) noexcept {
    const double x = p.x_m - r.centre.x_m;
    const double y = p.y_m - r.centre.y_m;
    return {x * r.axis.x + y * r.axis.y, y * r.axis.x - x * r.axis.y};
}

/// Front left, rear left, rear right, front right.
[[nodiscard]] constexpr std::array<Point, 4> corners_of(const Rectangle& r) noexcept {
    const Point front = ahead(r.centre, r.axis, r.half_length_m);
    const Point rear = ahead(r.centre, r.axis, -r.half_length_m);
    const Direction left{-r.axis.y, r.axis.x};
    return {ahead(front, left, r.half_width_m), ahead(rear, left, r.half_width_m), ahead(rear, left, -r.half_width_m),
            ahead(front, left, -r.half_width_m)};
}

/// Half of the rectangle's extent along a direction, seen from its centre.
[[nodiscard]] inline double half_extent_m(const Rectangle& r, const Direction& way) noexcept {
    const double along = r.axis.x * way.x + r.axis.y * way.y;
    const double across = r.axis.x * way.y - r.axis.y * way.x;
    return r.half_length_m * std::fabs(along) + r.half_width_m * std::fabs(across);
}

namespace detail {

/// The largest gap between the projections of a and b on the two axes of a; < 0 if they overlap on both.
[[nodiscard]] inline double axis_gap(const Rectangle& a, const Rectangle& b) noexcept {
    const Point apart = in_frame_of(a, b.centre);
    const Direction side{-a.axis.y, a.axis.x};
    return std::max(std::fabs(apart.x_m) - a.half_length_m - half_extent_m(b, a.axis),
                    std::fabs(apart.y_m) - a.half_width_m - half_extent_m(b, side));
}

/// The least distance of b's corners from a.
[[nodiscard]] inline double corner_gap(const Rectangle& a, const Rectangle& b) noexcept {
    double least = no_hit;
    for (const Point& corner : corners_of(b)) {
        const Point p = in_frame_of(a, corner);
        const double x = std::max(std::fabs(p.x_m) - a.half_length_m, 0.0);
        const double y = std::max(std::fabs(p.y_m) - a.half_width_m, 0.0);
        least = std::min(least, std::sqrt(x * x + y * y));
    }
    return least;
}

}  // namespace detail

/// The gap between two rectangles: > 0 apart, 0 touching, < 0 by how far one must move to part them (separating axes).
[[nodiscard]] inline double rectangle_gap(const Rectangle& a, const Rectangle& b) noexcept {
    const double overlap = std::max(detail::axis_gap(a, b), detail::axis_gap(b, a));
    if (overlap <= 0.0) return overlap;
    return std::min(detail::corner_gap(a, b), detail::corner_gap(b, a));  // convex: a corner is nearest
}

/// The gap between the rectangle and the nearest wall of the arena, seen from inside; < 0 if it reaches through.
[[nodiscard]] inline double rectangle_wall_gap(const Rectangle& r, double half_side_m) noexcept {
    const double x = std::fabs(r.centre.x_m) + half_extent_m(r, {1.0, 0.0});
    const double y = std::fabs(r.centre.y_m) + half_extent_m(r, {0.0, 1.0});
    return half_side_m - std::max(x, y);
}

}  // namespace sspql::sim
