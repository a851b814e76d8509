// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "report/learner_statistics.hpp"
#include "report/results.hpp"

namespace sspql::report {

/// What a phase of grid_experiment is judged by.
enum class GridMeasure {
    steps,   ///< of the first 30 episodes: the fewer the better
    reward,  ///< collected in a task counted in steps
    returns  ///< per episode, of a table
};

/// One phase with what its part of the page needs to know.
struct GridPhase {
    std::string name;
    std::optional<double> optimal_steps;
    std::optional<double> optimal_return;
    GridMeasure measure = GridMeasure::steps;
    bool returns_vary = false;                 ///< an episode's return tells more than whether the goal was reached
    std::vector<LearnerStatistics> learners;   ///< at least one
    std::vector<LearningCurve> return_curves;  ///< by learner, undiscounted; if `returns_vary`
    std::size_t seeds = 0;
    std::size_t episodes = 0;  ///< over which the first steps are taken: at most 30
    std::size_t best = 0;      ///< by `measure`

    [[nodiscard]] const LearnerStatistics& winner() const { return learners[best]; }
};

/// \throws std::invalid_argument without phases, or for a phase without learners.
[[nodiscard]] std::vector<GridPhase> grid_phases(const ExperimentResults& results);

/// By what a learner is judged: its steps, its reward at the last report step, its mean return.
[[nodiscard]] Summary measured(const LearnerStatistics& learner, GridMeasure measure);

/// Who was best in which phase, against Q-learning (`q`, or else `q-bonus`), and who was level with it.
[[nodiscard]] std::string grid_lead(const std::vector<GridPhase>& phases);

/// What was run.
[[nodiscard]] std::string grid_setting(const ExperimentResults& results, const std::vector<GridPhase>& phases);

}  // namespace sspql::report
