// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/grid_picture.hpp"
#include "report/results.hpp"

namespace sspql::report {

/// What the learners had learnt at the end of a phase, to be drawn side by side.
struct GridPhasePictures {
    /// By learner, in the phase's order; or empty for no maps. A title that is empty becomes the learner's name; the
    /// legends and colour ranges given are replaced by common ones.
    std::vector<GridPicture> learners{};
    std::string caption{};  ///< whose learning is shown: "Seed 1 at the end of the phase."
};

/// The page of grid_experiment: what was found, then for each phase the table of all learners, the learning curves (for
/// a task counted in steps: the reward collected), and the maps with what was learnt, and the manifest. Every sentence
/// about the run is computed from the run.
///
/// `pictures` belong to the phases in order; fewer than phases (none, for a table) leave the rest without maps. Maps of
/// more than `most_picture_cells` cells, or given without cells, are left out, and the page says so. The setting
/// "table", if not empty, names the table that was learnt: then returns count, not steps.
///
/// \throws std::invalid_argument if a phase has no learners, there is no phase, there are more pictures than phases, or
/// a phase's pictures are not one for each learner.
[[nodiscard]] std::string grid_report(const ExperimentResults& results, const std::vector<GridPhasePictures>& pictures);

}  // namespace sspql::report
