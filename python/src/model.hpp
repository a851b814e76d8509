// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <sspql/io/explanation.hpp>
#include <sspql/paths/shortest_paths.hpp>

#include "any_learner.hpp"

namespace sspql::python {

/// What there is to see in the model of a learner that keeps counts. \throws std::logic_error for one that keeps none.

/// The columns of the counts, a row for each (s,a,s') observed, ascending, as save_npy writes them (io/npy.hpp).
struct CountColumns {
    std::vector<Number> s, a, next;
    std::vector<double> n;
    std::vector<double> weight;
    std::vector<std::uint8_t> terminal;
    std::vector<double> reward_sum;  ///< empty where rewards are not kept
    bool whole = false;              ///< whether n are whole numbers
    bool rewards = false;            ///< whether rewards are kept
};
[[nodiscard]] CountColumns count_columns(const AnyLearner& learner);

/// Its own goals where it knows them, else learnt_goals.
[[nodiscard]] std::vector<Goal> goals_of(const AnyLearner& learner);

/// learnt_paths: its own tree where it keeps one.
[[nodiscard]] ShortestPathTree paths_of(const AnyLearner& learner);

/// explain, also for learners without counts.
[[nodiscard]] Explanation explanation_of(const AnyLearner& learner, Number s, const ExplainOptions& options);

}  // namespace sspql::python
