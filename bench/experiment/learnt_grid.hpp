// SPDX-License-Identifier: MIT
#pragma once

#include <sspql/env/grid_map.hpp>

#include "experiment/any_learner.hpp"
#include "report/grid_picture.hpp"

namespace sspql::experiment {

/// What a learner has learnt about a map: of each cell the value and the best move, and why on maps of up to 400 cells.
[[nodiscard]] report::GridPicture picture_of(const GridMap& map, const AnyLearner& learner);

}  // namespace sspql::experiment
