// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "report/arena_picture.hpp"

/// \file
/// A recorded mission, moment by moment, and its compact text for the page's player: plain numbers, arena frame.

namespace sspql::report {

/// The terms of one action's worth, as the learner adds them, and where the action leads.
struct ReplayTerms {
    double q = 0.0;
    double ssp = 0.0;
    double exploration = 0.0;
    double tries = 0.0;
    int next = -1;        ///< the state it led to most often; -1: not known
    double to_go = -1.0;  ///< from there to the goal; -1: no way is known
};

/// Where a thing is believed to be.
struct ReplayBelief {
    double x_m = 0.0;
    double y_m = 0.0;
    double deviation_m = 0.0;
};

/// What stands before an action is carried out; the last moment of a mission has no action.
struct ReplayMoment {
    int task = 0;  ///< 0 search, 1 approach, 2 turn, 3 push
    int attempt = 1;
    ArenaPose robot{};
    ArenaPose box{};
    ArenaPose odometry{};  ///< where the robot believes itself to be
    std::optional<ReplayBelief> box_belief{};
    std::optional<ReplayBelief> goal_belief{};
    bool box_seen = false;
    bool goal_seen = false;
    std::array<double, 16> sonars_m{};
    double seconds = 0.0;              ///< the action takes
    int command = -1;                  ///< 0 forwards or backwards, 1 a turn, -1 none
    double amount = 0.0;               ///< metres or radians
    int state = -1;                    ///< of the learnt sub-task
    int action = -1;                   ///< ... that was chosen
    double to_go = -1.0;               ///< ... to its goal, by the shortest path learnt; -1: no way is known
    std::vector<ReplayTerms> terms{};  ///< ... by action
};

struct MissionReplay {
    std::size_t number = 0;  ///< among all missions, from 1
    std::string outcome;     ///< in words
    bool in_goal = false;
    bool first_push = false;
    bool to_go_in_steps = true;  ///< else in costs of eq. 2
    ArenaPose goal{};
    std::vector<ReplayMoment> moments;
};

/// What the replays have in common.
struct ReplayStage {
    double half_width_m = 2.5;
    double robot_length_m = 0.40;
    double robot_width_m = 0.344;
    double box_side_m = 0.30;
    double goal_radius_m = 0.30;
    double camera_field_rad = 1.0471975511965976;
    std::vector<double> sonar_offsets_m{};  ///< of the outline from the centre, by sonar
    std::vector<std::string> approach_actions{};
    std::vector<std::string> turn_actions{};
};

/// The replays as JSON for the page's script: lengths in mm, angles in mrad, values in thousandths, sonars in cm; a
/// moment is a list of whole numbers. Nothing in it can end a script element.
[[nodiscard]] std::string replay_json(const ReplayStage& stage, const std::vector<MissionReplay>& replays);

}  // namespace sspql::report
