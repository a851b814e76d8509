// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/learner_statistics.hpp"
#include "report/results.hpp"

namespace sspql::report {

/// What all parts of pusher_experiment's page need to know.
struct Study {
    std::vector<LearnerStatistics> learners;  ///< at least one
    std::string task;
    std::string backend;       ///< empty if not said
    bool paper_table = false;  ///< the paper's Table 1 is about this run
    std::size_t episodes = 0;  ///< over which the totals are taken: at most 30
    std::size_t seeds = 0;

    [[nodiscard]] const LearnerStatistics* q() const noexcept;     ///< Q-learning, or nullptr
    [[nodiscard]] const LearnerStatistics& best() const noexcept;  ///< the fewest steps
};

/// Of the first phase. \throws std::invalid_argument without a phase or without learners.
[[nodiscard]] Study study_of(const ExperimentResults& results);

/// "1 seed", "2 seeds".
[[nodiscard]] std::string count_text(std::size_t n, const std::string& singular);

/// What was found, in one sentence or two: SSPQL with bonus (or the best learner) against Q-learning.
[[nodiscard]] std::string lead_text(const Study& study);

/// What was run: the task, what a step is, seeds, backend.
[[nodiscard]] std::string setting_text(const Study& study);

}  // namespace sspql::report
