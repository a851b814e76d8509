// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include <sspql/learn/adaptive/optimism_scale.hpp>

namespace sspql::testing {

inline constexpr double no_path = std::numeric_limits<double>::infinity();

/// Parameters for sums in the head: c is half of the median, 2 to 6, 3 more for others, below limit / (1 - gamma).
inline OptimismParams easy(double limit = 1.0) {
    OptimismParams params;
    params.fraction = 0.5;
    params.least = 2.0;
    params.most = 6.0;
    params.gap = 3.0;
    params.limit = limit;
    params.saving = 1.0;
    return params;
}

/// An episode of `steps` steps that bring `reward` each, and an end.
inline void episode(OptimismScale& scale, int steps, double reward, double last, bool first = false) {
    scale.begin_episode();
    for (int k = 0; k < steps; ++k) scale.observe_step(reward, first);
    scale.observe_end(last, scale.counts_as_goal(last));
    scale.end_episode();
}

}  // namespace sspql::testing
