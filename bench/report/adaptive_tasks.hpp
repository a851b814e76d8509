// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <sspql/run/statistics.hpp>

#include "report/recorded_run.hpp"
#include "report/verdict.hpp"

/// \file
/// Recorded runs of any number of tasks, sorted by task: what docs/adaptive-results.md compares.

namespace sspql::report {

/// What a task is judged by.
enum class TaskMeasure {
    first_steps,  ///< of the first 30 episodes
    all_steps,    ///< of all episodes, where the first one takes most of them
    reward,       ///< collected in a task counted in steps: the more the better
    late_return   ///< per late episode, where steps cost: negative, the nearer to 0 the better
};

/// A learner in a task, under one set of parameters.
struct TaskEntry {
    std::string learner{};  ///< "sspql-bonus"
    std::string changes{};  ///< "decay=1, gamma=.95"; empty: the parameters it has everywhere
    Summary value{};        ///< of the measure, over seeds; over maps where there are several
    double touches = 0.0;   ///< records and edges of the model, per step
    double late_steps = 0.0;
    std::uint64_t cut = 0;  ///< episodes that reached the step limit
    std::uint64_t episodes = 0;
};

/// A task, in the runs' order. Maps that differ in their number only (walls60, walls60:2) are one task.
struct AdaptiveTask {
    std::string name{};  ///< "soft54, after open64"
    TaskMeasure measure = TaskMeasure::first_steps;
    std::string measured{};  ///< "steps, 30 episodes"
    std::size_t maps = 1;
    std::size_t seeds = 0;  ///< of each map
    std::optional<double> optimal_steps{};
    std::vector<TaskEntry> entries{};

    /// The learner with the parameters it has everywhere, or nullptr.
    [[nodiscard]] const TaskEntry* find(const std::string& learner) const noexcept;

    /// The best of all entries for which `admitted` is true, or nullptr.
    [[nodiscard]] const TaskEntry* best(bool (*admitted)(const TaskEntry&)) const;

    /// Whether a does better than b; the ratio is below 1 if so, whatever the measure.
    [[nodiscard]] Contest better(const TaskEntry& a, const TaskEntry& b) const;
};

/// A task of which a learner has two results with the same parameters counts the first: it is the same run (two chains
/// of maps that begin alike). A phase without learners is left out.
[[nodiscard]] std::vector<AdaptiveTask> adaptive_tasks(const std::vector<RecordedRun>& runs);

}  // namespace sspql::report
