// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include <sspql/core/errors.hpp>

namespace sspql::sim {

/// The four sub-tasks of section 4.1, in the order in which they follow each other.
enum class SubTask { search, approach, turn, push };

/// How many sub-tasks there are.
inline constexpr std::size_t sub_tasks = 4;

/// "search", "approach", "turn" or "push".
[[nodiscard]] constexpr std::string_view name_of(SubTask task) noexcept {
    constexpr std::array<std::string_view, sub_tasks> names{"search", "approach", "turn", "push"};
    return names[static_cast<std::size_t>(task)];
}

/// Why an attempt at a sub-task ended.
enum class Outcome {
    success,
    search_timeout,    ///< box or goal not found
    approach_timeout,  ///< not behind the box in time
    turn_timeout,      ///< not aligned in time
    box_forgotten,     ///< the box or the goal was not where it was believed to be
    push_off_axis,     ///< the box slid away to a side
    push_stuck,        ///< many pushes without progress
    push_past_goal,    ///< the box went past the goal beside it
    push_timeout,      ///< too many pushes
    not_delivered,     ///< believed to be in the goal, seen outside of it
    goal_not_seen      ///< ... where the goal should be seen around it, and is not
};

/// How many outcomes there are.
inline constexpr std::size_t outcomes = 11;

/// An outcome in words, such as "turn: not aligned in time".
[[nodiscard]] constexpr std::string_view text_of(Outcome outcome) noexcept {
    constexpr std::array<std::string_view, outcomes> texts{"success",
                                                           "search: box or goal not found in time",
                                                           "approach: not behind the box in time",
                                                           "turn: not aligned in time",
                                                           "box or goal not where it was believed to be",
                                                           "push: the box slid off to a side",
                                                           "push: no progress",
                                                           "push: went past the goal",
                                                           "push: too many pushes",
                                                           "push: the box is not in the goal",
                                                           "push: no goal to be seen around the box"};
    return texts[static_cast<std::size_t>(outcome)];
}

/// What the robot goes by: its sensors, or the true poses (the learning study's assumption).
enum class Sensing { sensors, truth };

/// Limits and rules of a mission.
struct MissionParams {
    Sensing sensing = Sensing::sensors;  ///< what the robot goes by
    double goal_radius_m = 0.30;         ///< delivered when the box's centre lies in this disc
    int pushes = 9;                      ///< the first attempt and 8 more; an attempt is search, approach, turn, push
    int search_actions = 80;             ///< at most, an attempt
    int approach_actions = 600;          ///< at most, an attempt
    int turn_actions = 60;               ///< at most, an attempt
    int push_actions = 250;              ///< at most, an attempt

    /// Checks every member. \throws std::invalid_argument naming the first member out of range.
    void validate() const {
        require_positive("goal_radius_m", goal_radius_m);
        for (const int limit : {pushes, search_actions, approach_actions, turn_actions, push_actions}) {
            if (limit < 1) throw_invalid("a mission's limits", "be at least 1", limit);
        }
    }
};

/// One sub-task over a mission.
struct SubTaskTally {
    int attempts = 0;   ///< how often it was begun
    int successes = 0;  ///< how often it succeeded
    int actions = 0;    ///< commands carried out
};

/// How a mission went.
struct MissionResult {
    bool in_goal = false;            ///< the truth: the box's centre lies in the goal at the end
    bool first_push = false;         ///< ... and only one push was begun
    bool believed = false;           ///< what the robot thinks
    bool cornered = false;           ///< the truth: not in the goal, and the robot has no room behind the box
    Outcome end = Outcome::success;  ///< of the last attempt; not success: the robot gave up
    /// By SubTask.
    std::array<SubTaskTally, sub_tasks> tasks{};
    std::array<int, outcomes> ends{};  ///< of all attempts, by Outcome
    double driven_s = 0.0;             ///< all moves at full speed

    /// The tally of a sub-task.
    [[nodiscard]] SubTaskTally& of(SubTask task) noexcept { return tasks[static_cast<std::size_t>(task)]; }
    /// The tally of a sub-task.
    [[nodiscard]] const SubTaskTally& of(SubTask task) const noexcept { return tasks[static_cast<std::size_t>(task)]; }
};

}  // namespace sspql::sim
