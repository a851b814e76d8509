// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <sspql/run/statistics.hpp>

#include "report/mission_replay.hpp"
#include "report/results.hpp"

/// \file
/// What pusher_mission measured, as plain numbers, and what every writer derives from it: nothing here knows the
/// simulator.

namespace sspql::report {

inline constexpr std::size_t mission_tasks = 4;
inline constexpr std::array<const char*, mission_tasks> mission_task_names{"search", "approach", "turn", "push"};

struct TaskTally {
    int attempts = 0;
    int successes = 0;
    int actions = 0;
};

/// One mission.
struct MissionRecord {
    bool in_goal = false;
    bool first_push = false;
    bool believed = false;                 ///< the robot thinks the box is in the goal
    bool cornered = false;                 ///< not in the goal, and there is no room behind it
    std::string end;                       ///< how the last attempt ended, in words
    std::vector<std::string> failed_ends;  ///< how all attempts that failed ended
    std::array<TaskTally, mission_tasks> tasks{};
    double driven_s = 0.0;
};

/// What the learner would do in each of the 432 cells about the box.
struct LearntMap {
    static constexpr int unknown = -1;
    std::vector<int> best;  ///< by state: an action, or unknown where none was ever tried
    std::vector<std::string> actions;
};

struct MissionResults {
    std::vector<Setting> settings;
    Manifest manifest;
    std::string learner;
    std::vector<MissionRecord> missions;
    std::vector<SeedRun> approach_training;  ///< by robot
    std::vector<SeedRun> turn_training;
    std::vector<LearnerRuns> curves;  ///< 'approach' as in Figs. 11 and 13; may be empty
    LearntMap map;
    std::vector<MissionReplay> replays;
};

/// A share with its standard error, sqrt(q (1 - q) / (n + 2)), q = (count + 1) / (n + 2): all of 300 is not certainty.
struct Rate {
    std::size_t count = 0;
    std::size_t of = 0;
    double value = 0.0;  ///< NaN of none
    double error = 0.0;
};

[[nodiscard]] Rate rate_of(std::size_t count, std::size_t of);

/// "98.7 % +- 0.7 %", with a true plus-minus sign; "n/a" of none.
[[nodiscard]] std::string rate_text(const Rate& rate);

struct TaskStatistics {
    Rate success;     ///< of its attempts
    Summary actions;  ///< a mission
};

struct ReasonCount {
    std::string reason;
    std::size_t count = 0;
};

struct MissionStatistics {
    std::size_t missions = 0;
    Rate in_goal;
    Rate first_push;
    std::size_t mistaken = 0;  ///< believed to be in the goal, and was not
    std::array<TaskStatistics, mission_tasks> tasks{};
    Summary pushes;                        ///< begun, a mission
    Summary driven_s;                      ///< a mission
    std::vector<ReasonCount> failures;     ///< of missions whose box is not in the goal, most frequent first
    std::vector<ReasonCount> failed_ends;  ///< of attempts
};

[[nodiscard]] MissionStatistics statistics_of(const std::vector<MissionRecord>& missions);

/// The table on the terminal.
[[nodiscard]] std::string mission_text(const MissionResults& results);

/// The results as JSON, ending in a newline; no threads, paths or dates in it.
[[nodiscard]] std::string mission_json(const MissionResults& results);

}  // namespace sspql::report
