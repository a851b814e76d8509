// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/results.hpp"

namespace sspql::report {

/// Whether the paper's Table 1 is about this experiment: pusher_experiment, its task 'approach', 30 episodes or more.
[[nodiscard]] bool has_paper_table(const ExperimentResults& results);

/// The value of a setting as it was given, or an empty text.
[[nodiscard]] std::string setting_of(const ExperimentResults& results, const std::string& key);

/// For each phase, one line per learner: sum of steps over the first min(30, episodes) episodes with its standard
/// deviation and error, its ratio to Q-learning's, the first episode, the z score of the step down from the line above,
/// capped episodes, and the paper's Table 1 where it applies. Plain ASCII, at most 100 columns, for a terminal.
[[nodiscard]] std::string table_text(const ExperimentResults& results);

}  // namespace sspql::report
