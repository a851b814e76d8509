// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/recorded_run.hpp"

/// \file
/// docs/adaptive-results.md: the learner `adaptive` beside the others, task by task. No number is written down here;
/// all are computed from recorded runs.

namespace sspql::report {

/// The page, as Markdown. \throws std::invalid_argument for runs in which no task has `adaptive` and another learner.
[[nodiscard]] std::string adaptive_results(const std::vector<RecordedRun>& runs);

}  // namespace sspql::report
