// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/honest_comparison.hpp"

/// \file
/// The statements, one function for each part of the paper or of the field it is compared with.

namespace sspql::report {

/// A phase and where it stands: what kind of task it is decides which statements it bears on.
struct Place {
    const RecordedRun* run = nullptr;
    const RecordedPhase* phase = nullptr;
    std::string name{};         ///< "soft54", or "soft54 (run 2)" if there are several runs
    bool after_change = false;  ///< not the first of its run
};

enum class TaskKind { grid, chain, maze, approach, turn, other };

[[nodiscard]] TaskKind kind_of(const RecordedRun& run, const RecordedPhase& phase);

/// All phases of that kind.
[[nodiscard]] std::vector<Place> places_of(const std::vector<RecordedRun>& runs, TaskKind kind);

[[nodiscard]] ComparisonSection scratch_section(const std::vector<Place>& grids);
[[nodiscard]] ComparisonSection change_section(const std::vector<Place>& grids);
[[nodiscard]] ComparisonSection constant_section(const std::vector<Place>& grids);
[[nodiscard]] ComparisonSection table1_section(const std::vector<Place>& approaches);
[[nodiscard]] ComparisonSection robot_section(const std::vector<Place>& tasks);
[[nodiscard]] ComparisonSection cost_section(const std::vector<RecordedRun>& runs);
[[nodiscard]] ComparisonSection chain_section(const std::vector<Place>& chains);
[[nodiscard]] ComparisonSection maze_section(const std::vector<Place>& mazes);
[[nodiscard]] ComparisonSection adaptive_section(const std::vector<Place>& grids);

/// k of a learner that plans: its suffix (":20"), or --set, or the default.
[[nodiscard]] std::string planning_steps(const RecordedRun& run, const std::string& learner);

/// Of a phase, mean over seeds. Of a task counted in steps only `episodes` that every seed has are recorded; where each
/// goal gives reward 1 (the mazes), the reward counts the others too; elsewhere it is NaN.
[[nodiscard]] double recorded_episodes(const RecordedPhase& phase, const LearnerStatistics& learner);

/// Over all phases and seeds.
[[nodiscard]] double steps_per_episode(const RecordedRun& run, const std::string& learner);

}  // namespace sspql::report
