// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <sspql/sim/geometry.hpp>
#include <sspql/sim/pose.hpp>
#include <sspql/sim/pusher_params.hpp>
#include <sspql/sim/robot_body.hpp>

/// \file
/// What sensors look at: the true world at one moment, the same whichever backend it came from. Values and pure
/// functions, O(1), no allocation, safe from any thread.

namespace sspql::sim {

/// Robot, box, goal and walls, in the arena's frame.
struct Scene {
    Pose robot{};                    ///< its centre and where it looks
    Square box{};                    ///< the box
    double box_heading_rad = 0.0;    ///< the direction of the box's sides, as an angle
    Point goal{};                    ///< its centre
    RobotBody body{};                ///< the robot's outline
    double arena_half_side_m = 2.5;  ///< half the length of a wall
};

/// The scene of a backend that stands still.
template <class Backend>
[[nodiscard]] Scene scene_of(const Backend& backend) {
    const PusherParams& p = backend.params();
    return {
        backend.robot(),    square_at(backend.box(), p.box_side_m), backend.box().heading_rad, backend.goal(), p.body,
        p.arena_half_side_m};
}

/// Distance from a point along a direction to what is hit first: the box or a wall.
[[nodiscard]] inline double ray_m(const Scene& scene, const Point& from, const Direction& way) noexcept {
    return std::min(ray_to_square(from, way, scene.box), ray_to_walls(from, way, scene.arena_half_side_m));
}

/// Whether neither the box nor a wall stands on the line between two points; touching an end hides nothing.
[[nodiscard]] inline bool is_clear_line(const Scene& scene, const Point& from, const Point& to) noexcept {
    const double length = distance_m(from, to);
    if (length == 0.0) return true;
    const Direction way{(to.x_m - from.x_m) / length, (to.y_m - from.y_m) / length};
    return ray_m(scene, from, way) >= length;
}

}  // namespace sspql::sim
