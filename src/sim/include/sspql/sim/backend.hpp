// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <type_traits>
#include <utility>

#include <sspql/core/concepts.hpp>
#include <sspql/core/errors.hpp>
#include <sspql/sim/geometry.hpp>
#include <sspql/sim/pose.hpp>
#include <sspql/sim/pusher_params.hpp>
#include <sspql/sim/robot_body.hpp>

/// \file
/// PusherBackend (concept): a world with a robot, a box and walls in which one moves at a time.
///
///     explicit Backend(const PusherParams&)                 checks and copies the numbers
///     void reset(Pose robot, Pose box, Point goal)          a world at rest; nothing of the past remains
///     Move translate(double distance_m, double drift_rad)   drives forward (> 0) or backwards (< 0); meanwhile the
///                                                           heading turns evenly, by drift_rad over the full distance
///     Move rotate(double angle_rad)                         turns on the spot, > 0 to the left
///     Pose robot() const, Pose box() const                  arena frame, headings in (-pi, pi]
///     Point goal() const                                    as given to reset; no body
///     void set_guard(bool)                                  the collision guard of translations, see PusherParams
///     void set_path_recording(bool), path() const           the robot's poses since reset, for pictures; off at first
///
/// A move ends early where the guard, the fence, a contact or a stall stops it: that is an outcome, no error. Same
/// parameters, poses and moves give the same bits, however long the object has been in use. Backends hold everything by
/// value or unique_ptr: movable, no globals, one per thread. Ours: KinematicBackend, Box2dBackend.

namespace sspql::sim {

/// Why a move ended.
enum class Stop {
    done,     ///< the whole way
    guard,    ///< a sonar read no more than the guard's clearance
    fence,    ///< on the keep-in circle around the box
    contact,  ///< the body touches the box or a wall (kinematic backend)
    stall     ///< the drive could not get on (Box2D backend)
};

/// What a move did: the metres or radians it went, with the sign of what was asked, and why it ended.
struct Move {
    double amount = 0.0;     ///< metres or radians, with the sign of what was asked
    Stop stop = Stop::done;  ///< why it ended
};

namespace detail {

/// The parameters themselves, if `validate` accepts them.
inline const PusherParams& checked(const PusherParams& params) {
    params.validate();
    return params;
}

template <class B>
using BackendExpressions =
    std::void_t<decltype(B(std::declval<const PusherParams&>())),
                decltype(std::declval<B&>().reset(Pose{}, Pose{}, Point{})),
                decltype(Move{std::declval<B&>().translate(0.0, 0.0)}), decltype(Move{std::declval<B&>().rotate(0.0)}),
                decltype(Pose{std::declval<const B&>().robot()}), decltype(Pose{std::declval<const B&>().box()}),
                decltype(Point{std::declval<const B&>().goal()})>;

/// \throws std::invalid_argument unless the poses are finite, robot and box inside the arena and apart.
inline void require_start(const PusherParams& params, const Pose& robot, const Pose& box, const Point& goal) {
    if (!is_finite(robot)) throw_invalid("robot pose", "be finite, x_m", robot.x_m);
    if (!is_finite(box)) throw_invalid("box pose", "be finite, x_m", box.x_m);
    if (!is_finite(goal)) throw_invalid("goal", "be finite, x_m", goal.x_m);
    const Square square = square_at(box, params.box_side_m);
    const double reach = square.half_side_m * (std::fabs(square.axis.x) + std::fabs(square.axis.y));
    const double box_gap = circle_wall_gap(square.centre, reach, params.arena_half_side_m);
    if (box_gap < 0.0) throw_invalid("box pose", "lie inside the arena, gap to the wall (m)", box_gap);
    const double wall_gap = wall_gap_m(params.body, robot, params.arena_half_side_m);
    if (wall_gap < 0.0) throw_invalid("robot pose", "lie inside the arena, gap to the wall (m)", wall_gap);
    const double gap = box_gap_m(params.body, robot, square);
    if (gap < 0.0) throw_invalid("robot pose", "not overlap the box, gap (m)", gap);
}

}  // namespace detail

/// Whether B has the concept's members (the guard's switch and the recording of paths are optional).
template <class B>
inline constexpr bool is_pusher_backend_v = sspql::detail::is_detected_v<detail::BackendExpressions, B>;

}  // namespace sspql::sim
