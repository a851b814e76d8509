// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "report/arena_picture.hpp"
#include "report/grid_report.hpp"
#include "report/mission_replay.hpp"
#include "report/mission_results.hpp"
#include "report/results.hpp"

/// \file
/// All that an experiment program found: the results, and what their pictures need beyond them. Whether one process
/// found it or many did, outputs.hpp prints and writes it.

namespace sspql::report {

struct PusherFindings {
    ExperimentResults results;
    /// By learner: from each starting place, of the last ten episodes of the first seed the one of median length. Empty
    /// if there is nothing to draw.
    std::vector<std::vector<ArenaPath>> typical_paths;
};

struct GridFindings {
    ExperimentResults results;
    std::vector<GridPhasePictures> pictures;  ///< of the first seed, by phase
    std::vector<std::uint32_t> checksums;     ///< of each phase's world, whose file may differ from one host to another
};

struct MissionFindings {
    MissionResults results;
    ReplayStage stage;
};

}  // namespace sspql::report
