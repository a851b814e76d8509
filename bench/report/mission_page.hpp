// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/mission_replay.hpp"
#include "report/mission_results.hpp"

namespace sspql::report {

/// The page of pusher_mission: how many boxes came to the goal, missions to play, success by sub-task, why attempts
/// failed, how the robots learnt, what they learnt, and the spread of Fig. 13 beside that of Fig. 11. One
/// self-contained file; every sentence about the run is computed from the run. Parts without data are left out.
[[nodiscard]] std::string mission_page(const MissionResults& results, const ReplayStage& stage);

}  // namespace sspql::report
