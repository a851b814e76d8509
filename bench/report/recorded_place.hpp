// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "report/recorded_run.hpp"

/// \file
/// Which of the recorded phases a statement is about.

namespace sspql::report {

/// What kind of task a phase is decides which statements it bears on.
enum class TaskKind {
    grid,   ///< a map, counted in episodes
    chain,  ///< Fig. 3
    maze,   ///< Sutton and Barto's
    approach,
    turn,
    other
};

/// A phase and where it stands.
struct Place {
    const RecordedRun* run = nullptr;
    const RecordedPhase* phase = nullptr;
    std::string name{};         ///< "soft54", or "soft54 (run 2)" if there are several runs
    bool after_change = false;  ///< not the first of its run
};

[[nodiscard]] TaskKind kind_of(const RecordedRun& run, const RecordedPhase& phase);

/// All phases of that kind.
[[nodiscard]] std::vector<Place> places_of(const std::vector<RecordedRun>& runs, TaskKind kind);

/// " (run 2)", or nothing if there is one only.
[[nodiscard]] std::string label_of(const std::vector<RecordedRun>& runs, std::size_t i);

/// The chance that a step goes astray; the chain's own if none was given.
[[nodiscard]] double slip_of(const RecordedRun& run);

/// When the wall of a built-in maze moves; 0 for none.
[[nodiscard]] std::uint64_t change_step(const std::string& maze);

/// Of a phase, mean over seeds. Of a task counted in steps only the episodes that every seed has are recorded; where
/// each goal gives reward 1 (the mazes), the reward counts the others too; elsewhere it is NaN.
[[nodiscard]] double recorded_episodes(const RecordedPhase& phase, const LearnerStatistics& learner);

}  // namespace sspql::report
