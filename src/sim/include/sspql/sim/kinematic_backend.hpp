// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <sspql/core/errors.hpp>
#include <sspql/sim/backend.hpp>
#include <sspql/sim/geometry.hpp>
#include <sspql/sim/guard.hpp>
#include <sspql/sim/pose.hpp>
#include <sspql/sim/pusher_params.hpp>

namespace sspql::sim {

/// PusherBackend without physics: the robot goes where it is told until something stops it, the box never moves. Some
/// hundred times faster than Box2dBackend and close enough to learn on: the learners need 1.1 to 1.3 times the steps,
/// in the same order.
///
/// A translation runs along the straight line of the mean heading, h + drift / 2 (the chord of the arc a drifting robot
/// drives). The line is walked by safe leaps: as far as the body's gap allows, never less than 5 mm (2 mm with the
/// guard off), so a stop is found within that distance of where it is due; a touch never becomes an overlap.
///
/// A move is O(leaps), some 3 to 30, and allocates only while paths are recorded. Copyable; one object per thread.
class KinematicBackend {
public:
    /// Copies the numbers; reset() says where things are. \throws std::invalid_argument for parameters out of range.
    explicit KinematicBackend(const PusherParams& params = {})
        : params_(detail::checked(params)), guard_(params_), square_(square_at(box_, params_.box_side_m)) {}

    /// Puts robot and box there.
    /// \throws std::invalid_argument unless all is finite, robot and box lie inside the arena and do not overlap.
    void reset(const Pose& robot, const Pose& box, const Point& goal) {
        detail::require_start(params_, robot, box, goal);
        robot_ = robot;
        robot_.heading_rad = wrap_angle(robot.heading_rad);
        box_ = box;
        box_.heading_rad = wrap_angle(box.heading_rad);
        square_ = square_at(box_, params_.box_side_m);
        goal_ = goal;
        path_.clear();
        record();
    }

    /// Drives, turning evenly by `drift_rad` meanwhile. \throws std::invalid_argument unless both are finite.
    Move translate(double distance_m, double drift_rad) {
        require_finite("distance_m", distance_m);
        require_finite("drift_rad", drift_rad);
        const double wanted = std::fabs(distance_m);
        if (wanted == 0.0) return {};
        const bool forward = distance_m > 0.0;
        const Direction heading = direction(robot_.heading_rad + 0.5 * drift_rad);
        const Direction travel = forward ? heading : reversed(heading);
        const Point start = position(robot_);
        const double allowed =
            params_.fence ? distance_inside_fence(start, travel, wanted, square_.centre, params_.fence_radius_m)
                          : wanted;
        Stop stop = allowed < wanted ? Stop::fence : Stop::done;
        double gone = 0.0;
        double gap = gap_at(start);
        while (true) {
            if (params_.guard && gap <= params_.guard_clearance_m &&
                guard_.reading_m(position(robot_), heading, forward, square_) <= params_.guard_clearance_m) {
                stop = Stop::guard;
                break;
            }
            if (gone >= allowed) break;
            const double leap =
                params_.guard ? std::max(gap - params_.guard_clearance_m, guarded_leap_m) : std::max(gap, free_leap_m);
            const double next = std::min(gone + leap, allowed);
            const Point there = ahead(start, travel, next);
            const double next_gap = gap_at(there);
            if (next_gap < 0.0 && next_gap < gap) {
                stop = Stop::contact;
                break;
            }
            gone = next;
            gap = next_gap;
            robot_.x_m = there.x_m;
            robot_.y_m = there.y_m;
        }
        robot_.heading_rad = wrap_angle(robot_.heading_rad + drift_rad * (gone / wanted));
        record();
        return {forward ? gone : -gone, stop};
    }

    /// A turn on the spot; nothing stops a circle. A rectangle ends where a corner touches, walked by safe leaps of at
    /// least 2 mm of its reach. \throws std::invalid_argument unless the angle is finite.
    Move rotate(double angle_rad) {
        require_finite("angle_rad", angle_rad);
        Move move{angle_rad, Stop::done};
        if (params_.body.shape != BodyShape::circle) move = free_turn(angle_rad);
        robot_.heading_rad = wrap_angle(robot_.heading_rad + move.amount);
        record();
        return move;
    }

    /// Where the robot is, arena frame, heading in (-pi, pi].
    [[nodiscard]] const Pose& robot() const noexcept { return robot_; }
    /// Where the box is, as given to reset, the heading in (-pi, pi].
    [[nodiscard]] const Pose& box() const noexcept { return box_; }
    /// Where the box is to go, as given to reset.
    [[nodiscard]] const Point& goal() const noexcept { return goal_; }
    /// As given, but for the guard's switch.
    [[nodiscard]] const PusherParams& params() const noexcept { return params_; }

    /// Switches the guard on or off from the next move on: pushing means touching.
    void set_guard(bool on) noexcept { params_.guard = on; }

    /// Whether `path` grows: from now on, by the pose after every move.
    void set_path_recording(bool on) {
        recording_ = on;
        path_.clear();
        record();
    }

    /// The recorded poses, the first one from reset (or from the switching on).
    [[nodiscard]] const std::vector<Pose>& path() const noexcept { return path_; }

private:
    static constexpr double guarded_leap_m = 0.005;
    static constexpr double free_leap_m = 0.002;

    [[nodiscard]] double gap_at(const Point& p) const noexcept { return gap_at({p.x_m, p.y_m, robot_.heading_rad}); }

    [[nodiscard]] double gap_at(const Pose& pose) const noexcept {
        return std::min(box_gap_m(params_.body, pose, square_),
                        wall_gap_m(params_.body, pose, params_.arena_half_side_m));
    }

    /// How much of a turn a rectangle can make.
    [[nodiscard]] Move free_turn(double angle_rad) const noexcept {
        const double wanted = std::fabs(angle_rad);
        const double side = angle_rad < 0.0 ? -1.0 : 1.0;
        double gone = 0.0;
        double gap = gap_at(robot_);
        while (gone < wanted) {
            const double next = std::min(gone + std::max(gap, free_leap_m) / reach_m(params_.body), wanted);
            const double next_gap = gap_at({robot_.x_m, robot_.y_m, robot_.heading_rad + side * next});
            if (next_gap < 0.0 && next_gap < gap) return {side * gone, Stop::contact};
            gone = next;
            gap = next_gap;
        }
        return {angle_rad, Stop::done};
    }

    void record() {
        if (recording_) path_.push_back(robot_);
    }

    PusherParams params_;
    Guard guard_;
    Pose robot_{-1.0, 0.0, 0.0};
    Pose box_{};
    Square square_;
    Point goal_{1.3, 0.0};
    bool recording_ = false;
    std::vector<Pose> path_;
};

static_assert(is_pusher_backend_v<KinematicBackend>);

}  // namespace sspql::sim
