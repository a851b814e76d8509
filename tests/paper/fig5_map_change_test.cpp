// SPDX-License-Identifier: MIT
// Fig. 5: after the map changed. Table 1's constant w_SSP goes on repeating what was blocked; a weight that falls with
// the visits (eq. 9) recovers faster than Q-learning.
#include <sspql/env/grid_maps.hpp>

#include <cstddef>
#include <cstdint>

#include <gtest/gtest.h>

#include <sspql/env/grid_world.hpp>
#include <sspql/env/time_limit.hpp>
#include <sspql/learn/agent.hpp>
#include <sspql/learn/q_learning.hpp>
#include <sspql/learn/sspql.hpp>
#include <sspql/run/episode.hpp>
#include <sspql/spaces/enum_state.hpp>

using namespace sspql;

namespace {

struct AfterTheChange {
    double first5 = 0.0;   ///< steps, mean of the seeds
    double first30 = 0.0;  ///< steps, mean of the seeds; a cut episode counts its 2000
    double cut = 0.0;      ///< of 30 episodes
};

/// 50 episodes on open64, then walls are built: 30 on soft54. 20 seeds.
template <class Params>
AfterTheChange after_the_change(const Params& params) {
    constexpr std::uint64_t seeds = 20;
    AfterTheChange result;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        TimeLimit world(grid_task("open64").world(), 2000);
        Agent robot(EnumState<StateId>(64), EnumActions<Move>(4), params, seed);
        (void)run_episodes(world, robot, 50, 1000 * seed);
        world.environment().set_map(grid_task("soft54").map);
        std::size_t k = 0;
        for (const EpisodeResult& episode : run_episodes(world, robot, 30, 1000 * seed + 500)) {
            const double steps = static_cast<double>(episode.steps) / seeds;
            result.first30 += steps;
            if (k++ < 5) result.first5 += steps;
            if (!episode.terminated) result.cut += 1.0 / seeds;
        }
    }
    return result;
}

AfterTheChange q_with_bonus() {
    QLearningParams<> params;
    params.w_exp = 0.1;
    return after_the_change(params);
}

}  // namespace

// Measured with 10 seeds: 13860 steps and 5.2 cut episodes of 30; Q-learning with a bonus 1039 and none.
TEST(Fig5MapChange, AConstantWeightFails) {
    const AfterTheChange constant = after_the_change(SspqlParams<>::constant_weight());
    const AfterTheChange rival = q_with_bonus();
    EXPECT_GE(constant.first30, 5.0 * rival.first30);
    EXPECT_GE(constant.cut, 2.0);
    EXPECT_EQ(rival.cut, 0.0);
}

// Measured with 10 seeds: 646 of 1039 steps, and no episode cut.
TEST(Fig5MapChange, AWeightThatFallsWithTheVisitsDoesNot) {
    const AfterTheChange falling = after_the_change(SspqlParams<>{});
    const AfterTheChange rival = q_with_bonus();
    EXPECT_LE(falling.first30, 0.8 * rival.first30);
    EXPECT_LE(falling.first5, 0.8 * rival.first5);
    EXPECT_EQ(falling.cut, 0.0);
}
