// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/arena_picture.hpp"
#include "report/results.hpp"

namespace sspql::report {

/// The page of pusher_experiment: what was found, Table 1 beside the paper's, the learning curves of Figs. 8 to 12, the
/// arena with the paths that were learnt, what does not reproduce, the manifest. Every sentence about the run is
/// computed from the run. A path whose name is a learner's, or starts with it and a space or comma, has that learner's
/// colour in the charts, unless `arena.inks` is given.
///
/// \throws std::invalid_argument if the results have no phase or their first phase no learner.
[[nodiscard]] std::string pusher_report(const ExperimentResults& results, const Arena& arena);

/// The page's pictures, to be used elsewhere.
struct PusherPictures {
    Svg arena;
    Svg curves;  ///< of all learners, with standard errors
};

/// \throws std::invalid_argument as pusher_report does.
[[nodiscard]] PusherPictures pusher_pictures(const ExperimentResults& results, const Arena& arena);

}  // namespace sspql::report
