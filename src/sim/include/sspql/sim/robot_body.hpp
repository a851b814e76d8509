// SPDX-License-Identifier: MIT
#pragma once

#include <sspql/core/errors.hpp>
#include <sspql/sim/geometry.hpp>
#include <sspql/sim/pose.hpp>

namespace sspql::sim {

/// The robot's outline: a circle around its pose. Backends and the guard ask only the functions below, so that another
/// shape is a change to this header (and to the one place where the Box2D backend makes its fixture).
struct RobotBody {
    double radius_m = 0.20;

    /// \throws std::invalid_argument unless the radius is finite and > 0.
    void validate() const { require_positive("robot radius_m", radius_m); }
};

/// Distance from the robot's centre to its outline, where a sonar at this bearing (robot frame) sits.
[[nodiscard]] constexpr double outline_m(const RobotBody& body, double /*bearing_rad*/) noexcept {
    return body.radius_m;
}

/// The gap between the robot at `pose` and the box; < 0 when they overlap.
[[nodiscard]] inline double box_gap_m(const RobotBody& body, const Pose& pose, const Square& box) noexcept {
    return circle_square_gap(position(pose), body.radius_m, box);
}

/// The gap between the robot at `pose` and the nearest wall of the arena; < 0 when it reaches through.
[[nodiscard]] inline double wall_gap_m(const RobotBody& body, const Pose& pose, double arena_half_side_m) noexcept {
    return circle_wall_gap(position(pose), body.radius_m, arena_half_side_m);
}

}  // namespace sspql::sim
