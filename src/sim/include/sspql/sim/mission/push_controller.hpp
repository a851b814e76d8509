// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <sspql/sim/belief.hpp>
#include <sspql/sim/box_frame.hpp>
#include <sspql/sim/mission/mission_types.hpp>
#include <sspql/sim/pose.hpp>
#include <sspql/sim/pusher_params.hpp>
#include <sspql/sim/pusher_spaces.hpp>

namespace sspql::sim {

/// What the push wants: another command, or it is over.
struct PushStep {
    bool over = false;                   ///< whether the push has ended
    Outcome outcome = Outcome::success;  ///< if over
    PusherCommand command{};             ///< if not
};

/// 'push', predetermined. With the lateral offset y and the heading error h of the robot in the box frame (0 = on the
/// line from box to goal, looking along it):
///
///     run-up           backwards while the way to the box is shorter than 4 |y|, up to four times 0.2 m
///     before contact   onto the line: heading wish -atan2(y, 0.3), at most 0.9 rad
///     in contact       only hold the heading on the goal: wish 0. A lateral term there turns the box away.
///
/// What lacks to the wish (at most 0.6 rad) is turned on the spot if it exceeds 0.25 rad, else on a curve of 0.06 m.
/// Within half a metre of the goal the direction from box to goal says little; the last good one is kept.
///
/// Over: the box's centre is believed at the goal's, or past it; off axis if the box's bearing exceeds 35 degrees in
/// contact (near the goal that is no harm); stuck after 25 commands without 5 mm of progress. No chance, no allocation,
/// O(1) per call. A value; one object per thread.
class PushController {
public:
    /// The controller for this robot and this box. Precondition: valid parameters.
    explicit PushController(const PusherParams& params = {})
        : touch_m_(outline_m(params.body, 0.0) + params.box_side_m / 2.0) {}

    /// A push begins. Precondition: the belief is complete.
    void begin(const Belief& belief) noexcept {
        idle_ = 0;
        running_up_ = true;
        run_ups_ = 0;
        best_rest_m_ = no_hit;
        const PusherObservation seen = belief.observation();
        course_rad_ = std::atan2(seen.goal.y_m - seen.box.y_m, seen.goal.x_m - seen.box.x_m);
    }

    /// Precondition: the belief is complete, and begin was called.
    [[nodiscard]] PushStep next(const Belief& belief) noexcept {
        const PusherObservation seen = belief.observation();
        const Point box = position(seen.box);
        const double rest = distance_m(box, seen.goal);
        if (rest > course_kept_m) course_rad_ = std::atan2(seen.goal.y_m - box.y_m, seen.goal.x_m - box.x_m);
        const Direction course = direction(course_rad_);
        const double along = (seen.goal.x_m - box.x_m) * course.x + (seen.goal.y_m - box.y_m) * course.y;
        if (rest < arrived_m) return finished(Outcome::success);
        if (along < 0.02) return finished(rest < missed_m ? Outcome::success : Outcome::push_past_goal);

        const double x = (seen.robot.x_m - box.x_m) * course.x + (seen.robot.y_m - box.y_m) * course.y;
        const double y = (seen.robot.y_m - box.y_m) * course.x - (seen.robot.x_m - box.x_m) * course.y;
        const bool contact = -x - touch_m_ <= contact_gap_m;
        if (contact && std::fabs(bearing_rad(seen.robot, box)) > from_degrees(35.0)) {
            return finished(rest < missed_m ? Outcome::success : Outcome::push_off_axis);
        }
        if (needs_run_up(x, y)) return {false, Outcome::success, {Motion::translate, -0.2}};
        const double measure = contact ? rest : rest + 10.0 - x;  // before contact: progress is coming nearer
        if (measure < best_rest_m_ - 0.005) {
            best_rest_m_ = measure;
            idle_ = 0;
        } else if (++idle_ > 25) {
            return finished(Outcome::push_stuck);
        }
        const double wish = contact ? 0.0 : std::clamp(-std::atan2(y, look_m), -0.9, 0.9);
        const double steer = std::clamp(wish - wrap_angle(seen.robot.heading_rad - course_rad_), -0.6, 0.6);
        if (std::fabs(steer) > 0.25) return {false, Outcome::success, {Motion::rotate, steer}};
        return {false, Outcome::success, {Motion::translate, 0.06, steer}};
    }

    static constexpr double arrived_m = 0.06;      ///< the box's centre is as good as at the goal's
    static constexpr double missed_m = 0.20;       ///< over, and farther from the goal's centre: a miss
    static constexpr double contact_gap_m = 0.10;  ///< nearer counts as contact
    static constexpr double course_kept_m = 0.50;  ///< nearer to the goal the course stays

private:
    static constexpr int most_run_ups = 4;
    static constexpr double look_m = 0.30;         // the point of the line that is steered for lies this far ahead
    static constexpr double run_per_offset = 4.0;  // way to the box needed for each metre beside the line

    /// Backwards first, if the way to the box is too short to come onto the line.
    [[nodiscard]] bool needs_run_up(double x, double y) noexcept {
        const double run = -x - touch_m_;
        running_up_ =
            running_up_ && run_ups_ < most_run_ups && std::fabs(y) > 0.04 && run < run_per_offset * std::fabs(y);
        run_ups_ += running_up_ ? 1 : 0;
        return running_up_;
    }

    [[nodiscard]] static PushStep finished(Outcome outcome) noexcept { return {true, outcome, {}}; }

    double touch_m_;  // distance of the centres when front and box touch squarely
    double course_rad_ = 0.0;
    double best_rest_m_ = no_hit;
    int idle_ = 0;  // commands without progress
    bool running_up_ = false;
    int run_ups_ = 0;
};

}  // namespace sspql::sim
