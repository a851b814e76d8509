// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include <sspql/core/errors.hpp>
#include <sspql/core/random.hpp>
#include <sspql/sim/backend.hpp>
#include <sspql/sim/geometry.hpp>
#include <sspql/sim/pose.hpp>
#include <sspql/sim/pusher_params.hpp>

namespace sspql::sim {

/// Where robot, box and goal are when a mission begins, in the arena's frame.
struct MissionStart {
    Pose robot{};  ///< its centre and where it looks
    Pose box{};    ///< its centre and the direction of its sides
    Point goal{};  ///< where the box's centre is to go
};

/// How near to the walls and to each other things may be put.
struct StartRules {
    double box_wall_m = 0.9;         ///< least distance of the box's centre from a wall
    double goal_wall_m = 0.5;        ///< ... of the goal's
    double goal_box_m = 1.0;         ///< ... of the goal's from the box's
    double robot_clearance_m = 0.1;  ///< gap of the robot's outline to walls and box
    double push_place_m = 0.55;      ///< behind the box, where the robot must be able to stand and turn
};

namespace detail {

[[noreturn]] inline void refuse_place(const char* thing, const Point& p, const std::string& why) {
    using sspql::detail::to_text;
    throw std::invalid_argument(std::string("the ") + thing + " at (" + to_text(p.x_m) + ", " + to_text(p.y_m) + ") " +
                                why);
}

}  // namespace detail

/// Refuses a goal that no box can be pushed to.
/// \throws std::invalid_argument "the goal at (x, y) ..." if a box in its middle would reach into a wall.
inline void require_goal_place(const PusherParams& params, const Point& goal) {
    if (!is_finite(goal)) detail::refuse_place("goal", goal, "must be finite");
    if (circle_wall_gap(goal, params.box_side_m / 2.0, params.arena_half_side_m) < 0.0) {
        detail::refuse_place("goal", goal,
                             "is unreachable: the box would have to be in a wall (walls at +-" +
                                 sspql::detail::to_text(params.arena_half_side_m) + " m)");
    }
}

/// Refuses a place where no box can stand. \throws std::invalid_argument "the box at (x, y) ..." if it may reach into a wall.
inline void require_box_place(const PusherParams& params, const Point& box) {
    if (!is_finite(box)) detail::refuse_place("box", box, "must be finite");
    if (circle_wall_gap(box, params.box_side_m * 0.7072, params.arena_half_side_m) < 0.0) {
        detail::refuse_place("box", box, "reaches into a wall");
    }
}

/// Where the robot must be able to stand and turn to push the box towards the goal. Precondition: they differ.
[[nodiscard]] inline Point push_place(const Point& box, const Point& goal, const StartRules& rules = {}) noexcept {
    const double away = distance_m(box, goal);
    return ahead(box, {(box.x_m - goal.x_m) / away, (box.y_m - goal.y_m) / away}, rules.push_place_m);
}

/// Whether it has room there: at the push_place.
[[nodiscard]] inline bool has_push_place(const PusherParams& params, const Point& box, const Point& goal,
                                         const StartRules& rules = {}) noexcept {
    return circle_wall_gap(push_place(box, goal, rules), reach_m(params.body), params.arena_half_side_m) >= 0.0;
}

/// Refuses a box that cannot stand there or cannot be pushed to the goal.
/// \throws std::invalid_argument as the two above do, or "the box at (x, y) ..." if there is no room for the robot to
/// stand behind it and push it towards the goal.
inline void require_pushable(const PusherParams& params, const Point& box, const Point& goal,
                             const StartRules& rules = {}) {
    require_goal_place(params, goal);
    require_box_place(params, box);
    if (distance_m(box, goal) < 1e-9) detail::refuse_place("box", box, "is in the middle of the goal already");
    if (!has_push_place(params, box, goal, rules)) {
        const Point stand = push_place(box, goal, rules);
        using sspql::detail::to_text;
        detail::refuse_place("box", box,
                             "cannot be pushed towards the goal at (" + to_text(goal.x_m) + ", " + to_text(goal.y_m) +
                                 "): the robot has no room behind it, at (" + to_text(stand.x_m) + ", " +
                                 to_text(stand.y_m) + ")");
    }
}

/// Random poses by the rules: box and goal anywhere they may be, the robot anywhere it is clear of box and walls,
/// looking anywhere. A box or goal that is given stays where it is; then only what it takes to push it there must hold.
/// Every draw is repeated until all is well. \throws std::invalid_argument as require_pushable does for what is given,
/// or if a thousand draws did not do.
inline MissionStart random_mission_start(const PusherParams& params, Random& random, const Point* box = nullptr,
                                         const Point* goal = nullptr, const StartRules& rules = {}) {
    if (box != nullptr) require_box_place(params, *box);
    if (goal != nullptr) require_goal_place(params, *goal);
    if (box != nullptr && goal != nullptr) require_pushable(params, *box, *goal, rules);
    const auto coordinate = [&](double wall_m) {
        const double most = params.arena_half_side_m - wall_m;
        return random.uniform(-most, most);
    };
    std::string why;
    for (int i = 0; i < 1000; ++i) {
        MissionStart start;
        start.box.x_m = coordinate(rules.box_wall_m);
        start.box.y_m = coordinate(rules.box_wall_m);
        start.box.heading_rad = random.uniform(-pi, pi);
        start.goal.x_m = coordinate(rules.goal_wall_m);
        start.goal.y_m = coordinate(rules.goal_wall_m);
        start.robot.x_m = coordinate(reach_m(params.body) + rules.robot_clearance_m);
        start.robot.y_m = coordinate(reach_m(params.body) + rules.robot_clearance_m);
        start.robot.heading_rad = random.uniform(-pi, pi);
        if (box != nullptr) start.box = {box->x_m, box->y_m, start.box.heading_rad};
        if (goal != nullptr) start.goal = *goal;
        const bool both_given = box != nullptr && goal != nullptr;
        if (!both_given && distance_m(position(start.box), start.goal) < rules.goal_box_m) continue;
        const double gap = box_gap_m(params.body, start.robot, square_at(start.box, params.box_side_m));
        if (gap < rules.robot_clearance_m) continue;
        try {
            require_pushable(params, position(start.box), start.goal, rules);
        } catch (const std::invalid_argument& error) {
            why = error.what();
            continue;
        }
        return start;
    }
    throw std::invalid_argument(why.empty() ? "no room for robot, box and goal" : why);
}

}  // namespace sspql::sim
