// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <sspql/sim/pose.hpp>

/// \file
/// What the pusher's world asks of geometry: rays and gaps against a square box at any angle and against the walls of
/// the square arena, and how far one may go before leaving a circle. Pure functions of values, O(1), no allocation,
/// safe from any thread. Metres and radians; all arguments must be finite (unchecked).

namespace sspql::sim {

/// The distance along a ray that hits nothing.
inline constexpr double no_hit = std::numeric_limits<double>::infinity();

/// A square at any angle: the box. `axis` is the direction of its own +x.
struct Square {
    Point centre{};             ///< in the arena's frame
    Direction axis{};           ///< where its own +x points
    double half_side_m = 0.15;  ///< half the length of a side
};

/// The square of this side centred on a pose and turned by its heading.
[[nodiscard]] inline Square square_at(const Pose& pose, double side_m) noexcept {
    return {position(pose), direction(pose.heading_rad), side_m / 2.0};
}

/// The point in the square's own frame: origin in its centre, axes along its sides.
[[nodiscard]] constexpr Point in_frame_of(const Square& square, const Point& p) noexcept {
    const double x = p.x_m - square.centre.x_m;
    const double y = p.y_m - square.centre.y_m;
    return {x * square.axis.x + y * square.axis.y, y * square.axis.x - x * square.axis.y};
}

/// Distance from `from` along `way` to the first point of the square: 0 from inside or from its edge, `no_hit` if the
/// ray misses it. A ray along a side touches it.
[[nodiscard]] inline double ray_to_square(const Point& from, const Direction& way, const Square& square) noexcept {
    const Point p = in_frame_of(square, from);
    const Direction d{way.x * square.axis.x + way.y * square.axis.y, way.y * square.axis.x - way.x * square.axis.y};
    const double h = square.half_side_m;
    double enter = 0.0;
    double leave = no_hit;
    const double starts[2] = {p.x_m, p.y_m};
    const double slopes[2] = {d.x, d.y};
    for (int axis = 0; axis < 2; ++axis) {
        if (slopes[axis] == 0.0) {
            if (std::fabs(starts[axis]) > h) return no_hit;
            continue;
        }
        const double a = (-h - starts[axis]) / slopes[axis];
        const double b = (h - starts[axis]) / slopes[axis];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave ? enter : no_hit;
}

/// Distance from `from` along `way` to the walls of the arena [-half_side_m, half_side_m]^2, seen from inside; 0 on
/// or beyond the wall one looks at.
[[nodiscard]] inline double ray_to_walls(const Point& from, const Direction& way, double half_side_m) noexcept {
    double nearest = no_hit;
    if (way.x != 0.0) nearest = std::min(nearest, ((way.x > 0.0 ? half_side_m : -half_side_m) - from.x_m) / way.x);
    if (way.y != 0.0) nearest = std::min(nearest, ((way.y > 0.0 ? half_side_m : -half_side_m) - from.y_m) / way.y);
    return std::max(nearest, 0.0);
}

/// The gap between a circle and a square: > 0 apart, 0 touching, < 0 by how far the circle reaches in (if its centre
/// is inside the square: minus the radius and the way to the nearest side).
[[nodiscard]] inline double circle_square_gap(const Point& centre, double radius_m, const Square& square) noexcept {
    const Point p = in_frame_of(square, centre);
    const double x = std::fabs(p.x_m) - square.half_side_m;
    const double y = std::fabs(p.y_m) - square.half_side_m;
    if (x <= 0.0 && y <= 0.0) return std::max(x, y) - radius_m;
    const double out_x = std::max(x, 0.0);
    const double out_y = std::max(y, 0.0);
    return std::sqrt(out_x * out_x + out_y * out_y) - radius_m;
}

/// The gap between a circle and the nearest wall of the arena, seen from inside; < 0 if it reaches through.
[[nodiscard]] inline double circle_wall_gap(const Point& centre, double radius_m, double half_side_m) noexcept {
    return half_side_m - std::max(std::fabs(centre.x_m), std::fabs(centre.y_m)) - radius_m;
}

/// How far (0 to `wanted_m`) one may go from `from` along `way` with the fence of `radius_m` around `centre`: no step
/// may lead farther out while outside or on the fence. From inside: up to the fence. From outside: not at all when that
/// leads away, else through the fence to its far side, or to the point nearest to the centre if the line misses the
/// fence.
[[nodiscard]] inline double distance_inside_fence(const Point& from, const Direction& way, double wanted_m,
                                                  const Point& centre, double radius_m) noexcept {
    const double x = from.x_m - centre.x_m;
    const double y = from.y_m - centre.y_m;
    const double closest = -(x * way.x + y * way.y);  // along the way, where the centre is nearest
    const double miss = x * way.y - y * way.x;        // the line's distance from the centre
    const double half_chord_squared = radius_m * radius_m - miss * miss;
    const double most = half_chord_squared > 0.0 ? closest + std::sqrt(half_chord_squared) : closest;
    return std::clamp(most, 0.0, wanted_m);
}

}  // namespace sspql::sim
