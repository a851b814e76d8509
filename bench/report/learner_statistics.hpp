// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <sspql/run/statistics.hpp>

#include "report/results.hpp"

/// \file
/// From raw episodes to the numbers every writer shows.

namespace sspql::report {

/// Steps per episode, over seeds: element i belongs to episode i + 1.
struct LearningCurve {
    std::vector<double> mean;
    std::vector<double> deviation;  ///< sample standard deviation over seeds; 0 for one seed
};

/// Reward collected up to a step, over seeds.
struct RewardPoint {
    std::uint64_t step = 0;
    Summary reward;
};

/// The numbers of one learner. A Summary is taken over seeds, one value each. "Late" is a seed's last
/// min(20, episodes) episodes. A capped episode counts its steps. What cannot be computed (a rate of no episodes) is
/// NaN.
struct LearnerStatistics {
    std::string name;
    std::size_t seeds = 0;
    /// Episodes that every seed has. Seeds differ only in tasks counted in steps.
    std::size_t episodes = 0;

    Summary total_steps;    ///< sum over a seed's episodes
    Summary first5_steps;   ///< sum over episodes 1 to min(5, episodes)
    Summary first30_steps;  ///< sum over episodes 1 to min(30, episodes)
    Summary late_steps;     ///< per episode
    Summary late_return;    ///< undiscounted, per episode
    Summary mean_return;    ///< undiscounted, per episode, over all episodes

    double success_rate = 0.0;       ///< of all episodes of all seeds
    double late_success_rate = 0.0;  ///< of all late episodes of all seeds
    std::uint64_t capped_episodes = 0;
    std::uint64_t all_episodes = 0;              ///< of all seeds
    double model_ops_per_step = 0.0;             ///< all operations over all steps
    double learn_ns_per_step = 0.0;              ///< all learning time over all steps; differs from run to run
    LearningCurve curve;                         ///< over the episodes that every seed has
    std::vector<RewardPoint> cumulative_reward;  ///< tasks counted in steps; else empty

    std::vector<double> total_steps_of;  ///< by seed, as are the next three
    std::vector<double> first5_steps_of;
    std::vector<double> first30_steps_of;
    std::vector<double> late_steps_of;

    /// Steps of episode 1 over seeds; an empty Summary when a seed has no episode.
    Summary first_episode;
};

/// `report_at` is the phase's. O(episodes).
[[nodiscard]] LearnerStatistics statistics_of(const LearnerRuns& learner, const std::vector<std::uint64_t>& report_at);

/// The same for each learner of a phase, in its order.
[[nodiscard]] std::vector<LearnerStatistics> statistics_of(const PhaseRuns& phase);

}  // namespace sspql::report
