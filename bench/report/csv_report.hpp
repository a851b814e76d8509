// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/results.hpp"

namespace sspql::report {

/// One row per episode: phase,learner,seed,episode,steps,return,success,capped. Episodes count from 1, success and
/// capped are 0 or 1, return is undiscounted (an empty field if it is not finite). Fields are quoted where RFC 4180
/// asks for it; lines end in \n.
[[nodiscard]] std::string csv_report(const ExperimentResults& results);

}  // namespace sspql::report
