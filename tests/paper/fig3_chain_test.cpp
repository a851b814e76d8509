// SPDX-License-Identifier: MIT
// Fig. 3: a chain whose actions fail 7 times in 10. Backing up sampled outcomes with a large alpha goes round in
// circles there; shortest paths over counts do not.
#include <sspql/env/chain.hpp>

#include <cstdint>

#include <gtest/gtest.h>

#include <sspql/env/tabular_environment.hpp>
#include <sspql/env/time_limit.hpp>
#include <sspql/learn/dyna_q.hpp>
#include <sspql/learn/prioritized_sweeping.hpp>
#include <sspql/learn/sspql.hpp>
#include <sspql/run/episode.hpp>

using namespace sspql;

namespace {

/// Steps of 30 episodes, mean of 100 seeds; a cut episode counts its 5000.
template <class Params>
double steps(const Params& params, double probability = 0.3) {
    ChainParams chain;
    chain.probability = probability;
    double sum = 0.0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        TimeLimit world(TabularEnvironment(chain_table(chain)), 5000);
        typename Params::Learner learner(chain.states, 2, params, seed);
        for (const EpisodeResult& episode : run_episodes(world, learner, 30, 1000 * seed)) {
            sum += static_cast<double>(episode.steps) / 100.0;
        }
    }
    return sum;
}

DynaQParams<> dyna_q(std::size_t k, double alpha = 0.8) {
    DynaQParams<> params;
    params.planning_steps = k;
    params.alpha = alpha;
    return params;
}

}  // namespace

// Measured: 1173 and 2571 steps, 0.46; at best 900.
TEST(Fig3Chain, SspqlNeedsAtMostSixTenthsOfDynaQsSteps) {
    const double sspql = steps(SspqlParams<>::constant_weight());
    EXPECT_LE(sspql, 0.60 * steps(dyna_q(5)));
    EXPECT_GE(sspql, 900.0) << "nobody is faster than the optimum, 30 x 9 / 0.3";
}

TEST(Fig3Chain, ItIsTheSampledBackupsThatCostDynaQ) {
    const double full_backups = steps(PrioritizedSweepingParams<>{});
    EXPECT_LE(full_backups, 0.65 * steps(dyna_q(5))) << "prioritized sweeping, same model";
    EXPECT_LE(steps(dyna_q(5, 0.1)), 0.75 * steps(dyna_q(5))) << "a small alpha averages";
}

TEST(Fig3Chain, WithoutFailuresTheDifferenceIsSmall) {
    EXPECT_GE(steps(SspqlParams<>::constant_weight(), 1.0), 0.75 * steps(dyna_q(5), 1.0));
}
