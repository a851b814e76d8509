// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/results.hpp"

namespace sspql::report {

/// The results as JSON (design.md, section 7), ending in a newline. Keys stand in a fixed order and numbers have the
/// shortest text that reads back as the same double, so two runs differ at most in "timing", which comes last.
///
/// A standard error of fewer than two seeds, NaN and infinities are null. Bytes that are not UTF-8 become U+FFFD.
/// "timing" is by learner, over all phases. The manifest's command and compiler stay out: they name paths and threads.
///
/// \throws std::invalid_argument if a setting marked as JSON is none.
[[nodiscard]] std::string json_report(const ExperimentResults& results);

}  // namespace sspql::report
