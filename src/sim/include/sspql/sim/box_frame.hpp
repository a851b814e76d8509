// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <string>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/sim/pose.hpp>
#include <sspql/spaces/state_policy.hpp>

/// \file
/// The box frame (eq. 10) and its coding into 36 x 12 = 432 states (Fig. 7). Pure functions, O(1), no allocation but in
/// `describe_box_state`; safe from any thread.

namespace sspql::sim {

/// The robot in the frame whose origin is the box and whose +x axis points from the box to the goal (eq. 10): position
/// in metres, heading in (-pi, pi], 0 = looking the way the box has to go.
///
/// p' = R(-phi) (p_robot - p_box), heading' = heading - phi, phi = atan2(y_goal - y_box, x_goal - x_box).
/// The inputs may be in any common frame; sspql uses the arena's.
///
/// Deviation: the print sets dx = -x_box and then *subtracts* dx from the goal, which adds the box's place instead of
/// taking it off, and it places the robot (the origin of the paper's camera frame) at (-dx, -dy) = +p_box: the mirror
/// point of where it is. Its arctan of a quotient also loses the quadrant, and theta' = dtheta drops the robot's
/// heading because the paper's frame is the robot's own.
///
/// \throws std::invalid_argument if a number is not finite, or box and goal are at the same place (no direction).
[[nodiscard]] inline Pose to_box_frame(const Pose& robot, const Point& box, const Point& goal) {
    if (!is_finite(robot)) {
        require_finite("robot x_m", robot.x_m);
        require_finite("robot y_m", robot.y_m);
        require_finite("robot heading_rad", robot.heading_rad);
    }
    const double goal_x = goal.x_m - box.x_m;
    const double goal_y = goal.y_m - box.y_m;
    const double reach = std::sqrt(goal_x * goal_x + goal_y * goal_y);
    if (!std::isfinite(reach)) {
        require_finite("box x_m", box.x_m);
        require_finite("box y_m", box.y_m);
        require_finite("goal x_m", goal.x_m);
        require_finite("goal y_m", goal.y_m);
        throw_invalid("distance from box to goal", "be finite", reach);
    }
    if (reach == 0.0) throw_invalid("distance from box to goal", "be > 0 (it gives the frame its direction)", reach);
    const double cosine = goal_x / reach;
    const double sine = goal_y / reach;
    const double x = robot.x_m - box.x_m;
    const double y = robot.y_m - box.y_m;
    return {x * cosine + y * sine, y * cosine - x * sine, wrap_angle(robot.heading_rad - std::atan2(goal_y, goal_x))};
}

inline constexpr std::size_t box_sectors = 12;    ///< of 30 degrees, sector 0 centred on the way to the goal
inline constexpr std::size_t box_rings = 3;       ///< r < 0.7 m, 0.7 m <= r < 1.0 m, 1.0 m <= r
inline constexpr std::size_t heading_bins = 12;   ///< of 30 degrees, bin 0 centred on the way to the goal
inline constexpr std::size_t push_sector = 6;     ///< sector A of Fig. 7: behind the box, seen from the goal
inline constexpr double inner_ring_edge_m = 0.7;  ///< between rings 0 and 1
inline constexpr double outer_ring_edge_m = 1.0;  ///< between rings 1 and 2
inline constexpr std::size_t box_states = box_rings * box_sectors * heading_bins;  ///< cells of Fig. 7: 432

/// One cell of Fig. 7.
struct BoxCell {
    std::size_t ring = 0;         ///< 0 to 2, from the box outward
    std::size_t sector = 0;       ///< 0 to 11
    std::size_t heading_bin = 0;  ///< 0 to 11
};

/// round(angle / 30 degrees) mod 12. Bin k is [30 k - 15, 30 k + 15) degrees. Precondition: the angle is finite.
[[nodiscard]] inline std::size_t thirty_degree_bin(double angle_rad) noexcept {
    const double turns = angle_rad / (2.0 * pi);
    const double bin = std::floor((turns - std::floor(turns)) * 12.0 + 0.5);  // 0 to 12
    return bin >= 12.0 ? 0 : static_cast<std::size_t>(bin);
}

/// The ring of a distance from the box (an edge belongs to the ring outside it, as in PolarGrid).
[[nodiscard]] constexpr std::size_t ring_of(double radius_m) noexcept {
    return radius_m < inner_ring_edge_m ? 0 : radius_m < outer_ring_edge_m ? 1 : 2;
}

/// The cell of a pose in the box frame. A robot on the box's centre counts as sector 0.
/// Precondition: the pose is finite (to_box_frame's always is).
[[nodiscard]] inline BoxCell box_cell(const Pose& in_box_frame) noexcept {
    return {ring_of(distance_m({}, position(in_box_frame))),
            thirty_degree_bin(std::atan2(in_box_frame.y_m, in_box_frame.x_m)),
            thirty_degree_bin(in_box_frame.heading_rad)};
}

/// Whether a pose in the box frame lies in sector A, in any ring, with any heading: the goal of 'approach'.
[[nodiscard]] inline bool in_push_sector(const Pose& in_box_frame) noexcept {
    return thirty_degree_bin(std::atan2(in_box_frame.y_m, in_box_frame.x_m)) == push_sector;
}

/// (ring * 12 + sector) * 12 + heading bin: the id ProductState<PolarGrid, headings> gives too. Precondition: the
/// members lie in their ranges.
[[nodiscard]] constexpr StateId box_state(const BoxCell& cell) noexcept {
    return state_id((cell.ring * box_sectors + cell.sector) * heading_bins + cell.heading_bin);
}

/// The state's cell, the inverse of `box_state`. \throws std::invalid_argument for an id of 432 or more.
[[nodiscard]] inline BoxCell box_cell(StateId s) {
    const std::size_t id = index(sspql::detail::require_state_of(s, box_states));
    const std::size_t place = id / heading_bins;
    return {place / box_sectors, place % box_sectors, id % heading_bins};
}

/// "0.7 m <= r < 1 m, sector 180 deg (A), heading 30 deg", angles in the box frame.
/// \throws std::invalid_argument for an id of 432 or more.
[[nodiscard]] inline std::string describe_box_state(StateId s) {
    static constexpr const char* ring_texts[box_rings] = {"r < 0.7 m", "0.7 m <= r < 1 m", "r >= 1 m"};
    const BoxCell cell = box_cell(s);
    return std::string(ring_texts[cell.ring]) + ", sector " + std::to_string(cell.sector * 30) + " deg" +
           (cell.sector == push_sector ? " (A)" : "") + ", heading " + std::to_string(cell.heading_bin * 30) + " deg";
}

}  // namespace sspql::sim
