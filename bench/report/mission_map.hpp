// SPDX-License-Identifier: MIT
#pragma once

#include "report/mission_results.hpp"
#include "report/svg.hpp"

namespace sspql::report {

/// What was learnt about the 36 positions around the box (12 sectors, 3 rings): in each a dial with a wedge for every
/// heading, in the colour of the action that would be chosen there. Unknown cells stay empty.
///
/// \throws std::invalid_argument unless the map has 432 states.
[[nodiscard]] Svg mission_map(const LearntMap& map);

}  // namespace sspql::report
