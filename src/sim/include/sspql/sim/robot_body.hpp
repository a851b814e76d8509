// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <sspql/core/errors.hpp>
#include <sspql/sim/geometry.hpp>
#include <sspql/sim/pose.hpp>
#include <sspql/sim/rectangle.hpp>

namespace sspql::sim {

/// The outline of a robot: round, as in the learning study, or a rectangle, whose flat front pushes a box straight.
enum class BodyShape { circle, rectangle };

/// The robot's outline, centred on its pose. Backends, guard and sensors ask only the functions below.
struct RobotBody {
    double radius_m = 0.20;               ///< of the circle
    BodyShape shape = BodyShape::circle;  ///< which of the two
    double length_m = 0.40;               ///< of the rectangle, along the heading
    double width_m = 0.344;               ///< of the rectangle

    /// Checks every length. \throws std::invalid_argument unless the lengths are finite and > 0.
    void validate() const {
        require_positive("robot radius_m", radius_m);
        require_positive("robot length_m", length_m);
        require_positive("robot width_m", width_m);
    }
};

/// The outline of a rectangular robot at a pose.
[[nodiscard]] inline Rectangle outline_at(const RobotBody& body, const Pose& pose) noexcept {
    return {position(pose), direction(pose.heading_rad), body.length_m / 2.0, body.width_m / 2.0};
}

/// Distance from the robot's centre to its outline, where a sonar at this bearing (robot frame) sits.
[[nodiscard]] inline double outline_m(const RobotBody& body, double bearing_rad) noexcept {
    if (body.shape == BodyShape::circle) return body.radius_m;
    const Direction way = direction(bearing_rad);
    const double ends = way.x == 0.0 ? no_hit : body.length_m / 2.0 / std::fabs(way.x);
    const double sides = way.y == 0.0 ? no_hit : body.width_m / 2.0 / std::fabs(way.y);
    return std::min(ends, sides);
}

/// Distance from the robot's centre to the farthest point of its outline.
[[nodiscard]] inline double reach_m(const RobotBody& body) noexcept {
    if (body.shape == BodyShape::circle) return body.radius_m;
    return 0.5 * std::sqrt(body.length_m * body.length_m + body.width_m * body.width_m);
}

/// The gap between the robot at `pose` and the box; < 0 when they overlap.
[[nodiscard]] inline double box_gap_m(const RobotBody& body, const Pose& pose, const Square& box) noexcept {
    if (body.shape == BodyShape::circle) return circle_square_gap(position(pose), body.radius_m, box);
    return rectangle_gap(outline_at(body, pose), rectangle_of(box));
}

/// The gap between the robot at `pose` and the nearest wall of the arena; < 0 when it reaches through.
[[nodiscard]] inline double wall_gap_m(const RobotBody& body, const Pose& pose, double arena_half_side_m) noexcept {
    if (body.shape == BodyShape::circle) return circle_wall_gap(position(pose), body.radius_m, arena_half_side_m);
    return rectangle_wall_gap(outline_at(body, pose), arena_half_side_m);
}

}  // namespace sspql::sim
