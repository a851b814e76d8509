// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <sspql/sim/geometry.hpp>
#include <sspql/sim/pose.hpp>
#include <sspql/sim/pusher_spaces.hpp>
#include <sspql/sim/sensors/sensor_suite.hpp>

namespace sspql::sim {

/// Where a thing is believed to be, in the odometry frame, and how sure that is.
struct Landmark {
    Point place{};             ///< in the odometry frame
    double variance_m2 = 0.0;  ///< of either coordinate
    int misses = 0;            ///< looks in a row that should have shown it and did not
};

/// What the robot makes of its sensors: its own pose by odometry, box and goal in the same frame, whose origin and axes
/// are the robot's pose at the start. Nothing is known then, except that there are a box of box_side_m, a goal and
/// walls somewhere.
///
/// A thing in view is corrected by a part g of the difference, g = P / (P + R): P its variance, which grows with the
/// odometry's errors, R the sighting's. The box's g is at least least_box_gain, because it may have been pushed, and
/// more when it is near. What should be in view and was not for most_misses looks in a row is forgotten.
///
/// O(1) per call, no allocation, no chance. A value; one object per thread.
class Belief {
public:
    /// `sensors` tell how far to trust what they say. \throws std::invalid_argument for parameters out of range.
    explicit Belief(const SensorParams& sensors = {}, double box_side_m = 0.30)
        : sensors_((sensors.validate(), sensors)), box_side_m_(require_positive("box_side_m", box_side_m)) {}

    /// The robot at the frame's origin, nothing known.
    void forget_all() noexcept {
        robot_ = {};
        box_.reset();
        goal_.reset();
    }

    /// The box is anywhere again.
    void forget_box() noexcept { box_.reset(); }
    /// The goal is anywhere again.
    void forget_goal() noexcept { goal_.reset(); }

    /// Takes the truth instead, in whatever frame it is given.
    void know(const Pose& robot, const Point& box, const Point& goal) noexcept {
        robot_ = robot;
        box_ = Landmark{box, 0.0, 0};
        goal_ = Landmark{goal, 0.0, 0};
    }

    /// After an action, by what the odometer says.
    void travelled(const Travel& travel) noexcept {
        robot_ = moved(robot_, travel);
        const double distance_error = sensors_.noise * sensors_.odometry_distance_noise * travel.distance_m;
        const double turn_error = sensors_.noise * sensors_.odometry_turn_noise * travel.turn_rad;
        for (std::optional<Landmark>* thing : {&box_, &goal_}) {
            if (!*thing) continue;
            const double swing = turn_error * distance_m(position(robot_), (*thing)->place);
            (*thing)->variance_m2 += distance_error * distance_error + swing * swing;
        }
    }

    /// Corrects what is in view and counts what is missing there.
    void look(const SensorReadings& readings, const RangeFinder& finder) {
        const bool box_expected = is_expected(box_);
        const bool goal_expected = is_expected(goal_) && !hides_goal();
        if (readings.view.box) {
            see_box(*readings.view.box, readings.ranges, finder);
        } else if (box_ && box_expected && ++box_->misses >= most_misses) {
            box_.reset();
        }
        if (readings.view.goal) {
            see_goal(*readings.view.goal);
        } else if (goal_ && goal_expected && ++goal_->misses >= most_misses) {
            goal_.reset();
        }
    }

    /// Where the robot believes to be, in the odometry frame.
    [[nodiscard]] const Pose& robot() const noexcept { return robot_; }
    /// The box, if known: its centre.
    [[nodiscard]] const std::optional<Landmark>& box() const noexcept { return box_; }
    /// The goal, if known: its centre.
    [[nodiscard]] const std::optional<Landmark>& goal() const noexcept { return goal_; }
    /// Whether box and goal are known, at different places.
    [[nodiscard]] bool is_complete() const noexcept { return box_ && goal_ && !(box_->place == goal_->place); }

    /// What the learnt sub-tasks and the push look at, in the odometry frame. Precondition: is_complete().
    [[nodiscard]] PusherObservation observation() const noexcept {
        return {robot_, {box_->place.x_m, box_->place.y_m, 0.0}, goal_->place};
    }

    static constexpr int most_misses = 3;            ///< looks in a row, then the thing is forgotten
    static constexpr double least_box_gain = 0.3;    ///< the least part of a difference by which the box is corrected
    static constexpr double touched_box_gain = 0.7;  ///< ... nearer than touched_m, where it may be moving
    static constexpr double touched_m = 0.55;        ///< metres from the robot's centre to the box's
    static constexpr double least_goal_gain = 0.05;  ///< the least part for the goal, which stays where it is
    static constexpr double surprising_m = 0.25;     ///< seen farther off than this and 4 deviations: it was moved

private:
    [[nodiscard]] static double squared(double x) noexcept { return x * x; }

    /// Its bearing lies well inside the camera's field, so that an error of the belief does not matter.
    [[nodiscard]] bool is_expected(const std::optional<Landmark>& thing) const noexcept {
        if (!thing) return false;
        const double range = distance_m(position(robot_), thing->place);
        if (range < 1e-6) return false;
        const double slack = 3.0 * std::sqrt(thing->variance_m2) / range + from_degrees(6.0);
        return std::fabs(bearing_rad(robot_, thing->place)) + slack < 0.5 * sensors_.camera_field_rad;
    }

    /// Whether the box may stand before the goal.
    [[nodiscard]] bool hides_goal() const noexcept {
        if (!box_ || !goal_) return false;
        const double to_goal = distance_m(position(robot_), goal_->place);
        const double to_box = distance_m(position(robot_), box_->place);
        if (to_goal <= to_box - box_side_m_) return false;
        const double apart =
            std::fabs(wrap_angle(bearing_rad(robot_, goal_->place) - bearing_rad(robot_, box_->place)));
        return apart < std::atan2(1.5 * box_side_m_, std::max(to_box - box_side_m_, 0.05));
    }

    /// The box's middle lies behind the side that is measured: by 0.56 of its length on average over its angles (half
    /// of it to 0.71), give or take 0.06.
    void see_box(const Sighting& seen, const RangeFinder::Readings& ranges, const RangeFinder& finder) {
        const double window = from_degrees(2.0);
        const double range = finder.nearest_m(ranges, seen.bearing_rad, window) + 0.561 * box_side_m_;
        const double range_error = sensors_.noise * sensors_.scan_noise_m;
        const double bearing_error = sensors_.noise * sensors_.bearing_noise_rad * range;
        const double variance = 0.5 * (squared(range_error) + squared(0.06 * box_side_m_) + squared(bearing_error));
        correct(box_, seen.bearing_rad, range, variance, range < touched_m ? touched_box_gain : least_box_gain);
    }

    void see_goal(const Sighting& seen) {
        const double errors = (seen.whole ? 1.0 : 2.0) * sensors_.noise;
        const double range_error = errors * sensors_.goal_range_noise * seen.range_m;
        const double bearing_error = errors * sensors_.bearing_noise_rad * seen.range_m;
        const double variance = 0.5 * (squared(range_error) + squared(bearing_error));
        correct(goal_, seen.bearing_rad, seen.range_m, variance, least_goal_gain);
    }

    void correct(std::optional<Landmark>& thing, double bearing_rad, double range_m, double variance_m2,
                 double least_gain) noexcept {
        const Point seen = ahead(position(robot_), direction(robot_.heading_rad + bearing_rad), range_m);
        if (!thing) {
            thing = Landmark{seen, variance_m2, 0};
            return;
        }
        const double off = distance_m(seen, thing->place);
        const double total = thing->variance_m2 + variance_m2;
        if (off > surprising_m && off * off > 32.0 * total) {  // 4 deviations of both coordinates: it was moved
            thing = Landmark{seen, variance_m2, 0};
            return;
        }
        const double gain = total > 0.0 ? std::max(thing->variance_m2 / total, least_gain) : 1.0;
        thing->place.x_m += gain * (seen.x_m - thing->place.x_m);
        thing->place.y_m += gain * (seen.y_m - thing->place.y_m);
        thing->variance_m2 = squared(1.0 - gain) * thing->variance_m2 + squared(gain) * variance_m2;
        thing->misses = 0;
    }

    SensorParams sensors_;
    double box_side_m_;
    Pose robot_{};
    std::optional<Landmark> box_{};
    std::optional<Landmark> goal_{};
};

}  // namespace sspql::sim
