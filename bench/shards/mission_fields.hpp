// SPDX-License-Identifier: MIT
#pragma once

#include "report/mission_replay.hpp"
#include "report/mission_results.hpp"
#include "shards/fields.hpp"
#include "shards/run_fields.hpp"

/// \file
/// Missions and their replays as JSON and back.

namespace sspql::shards {

template <class Io>
void fields(Io& io, Like<Io, report::TaskTally>& tally) {
    auto& [attempts, successes, actions] = tally;
    io("attempts", attempts);
    io("successes", successes);
    io("actions", actions);
}

template <class Io>
void fields(Io& io, Like<Io, report::MissionRecord>& record) {
    auto& [in_goal, first_push, believed, cornered, end, failed_ends, tasks, driven_s] = record;
    io("in_goal", in_goal);
    io("first_push", first_push);
    io("believed", believed);
    io("cornered", cornered);
    io("end", end);
    io("failed_ends", failed_ends);
    io("tasks", tasks);
    io("driven_s", driven_s);
}

template <class Io>
void fields(Io& io, Like<Io, report::LearntMap>& map) {
    auto& [best, actions] = map;
    io("best", best);
    io("actions", actions);
}

template <class Io>
void fields(Io& io, Like<Io, report::ReplayTerms>& terms) {
    auto& [q, ssp, exploration, tries, next, to_go] = terms;
    io("q", q);
    io("ssp", ssp);
    io("exploration", exploration);
    io("tries", tries);
    io("next", next);
    io("to_go", to_go);
}

template <class Io>
void fields(Io& io, Like<Io, report::ReplayBelief>& belief) {
    auto& [x, y, deviation] = belief;
    io("x_m", x);
    io("y_m", y);
    io("deviation_m", deviation);
}

template <class Io>
void fields(Io& io, Like<Io, report::ReplayMoment>& moment) {
    auto& [task, attempt, robot, box, odometry, box_belief, goal_belief, box_seen, goal_seen, sonars, seconds, command,
           amount, state, action, to_go, terms] = moment;
    io("task", task);
    io("attempt", attempt);
    io("robot", robot);
    io("box", box);
    io("odometry", odometry);
    io("box_belief", box_belief);
    io("goal_belief", goal_belief);
    io("box_seen", box_seen);
    io("goal_seen", goal_seen);
    io("sonars_m", sonars);
    io("seconds", seconds);
    io("command", command);
    io("amount", amount);
    io("state", state);
    io("action", action);
    io("to_go", to_go);
    io("terms", terms);
}

template <class Io>
void fields(Io& io, Like<Io, report::MissionReplay>& replay) {
    auto& [number, outcome, in_goal, first_push, to_go_in_steps, goal, moments] = replay;
    io("number", number);
    io("outcome", outcome);
    io("in_goal", in_goal);
    io("first_push", first_push);
    io("to_go_in_steps", to_go_in_steps);
    io("goal", goal);
    io("moments", moments);
}

template <class Io>
void fields(Io& io, Like<Io, report::ReplayStage>& stage) {
    auto& [half_width, robot_length, robot_width, box_side, goal_radius, camera_field, sonar_offsets, approach_actions,
           turn_actions] = stage;
    io("half_width_m", half_width);
    io("robot_length_m", robot_length);
    io("robot_width_m", robot_width);
    io("box_side_m", box_side);
    io("goal_radius_m", goal_radius);
    io("camera_field_rad", camera_field);
    io("sonar_offsets_m", sonar_offsets);
    io("approach_actions", approach_actions);
    io("turn_actions", turn_actions);
}

}  // namespace sspql::shards
