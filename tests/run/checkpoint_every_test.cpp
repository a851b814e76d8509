// SPDX-License-Identifier: MIT
#include <sspql/run/checkpoint_every.hpp>

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "io/file_testing.hpp"

#include <sspql/env/chain.hpp>
#include <sspql/env/tabular_environment.hpp>
#include <sspql/learn/adaptive_sspql.hpp>

using namespace sspql;
using namespace sspql::testing;

class CheckpointEveryTest : public FileTest {};

TEST_F(CheckpointEveryTest, ARunThatIsResumedIsTheRunThatNeverStopped) {
    const auto fresh = [] { return AdaptiveSspql<>(10, 2, {}, 5); };
    auto world = TabularEnvironment(chain_table());
    AdaptiveSspql<> uninterrupted = fresh();
    const auto all = run_episodes(world, uninterrupted, 20, 100);

    AdaptiveSspql<> killed = fresh();
    static_cast<void>(run_episodes(world, killed, 13, 100, CheckpointEvery(4, path("robot"))));
    AdaptiveSspql<> resumed = fresh();
    load(path("robot"), resumed);  // as after 12 episodes
    const auto rest = run_episodes(world, resumed, 8, 112);
    for (std::size_t k = 0; k < 8; ++k) EXPECT_EQ(rest[k].steps, all[12 + k].steps) << k;
    EXPECT_EQ(save_to_bytes(resumed), save_to_bytes(uninterrupted));
    EXPECT_EQ(files(), 1u);
}

TEST_F(CheckpointEveryTest, SavesNothingBeforeItsTime) {
    auto world = TabularEnvironment(chain_table());
    AdaptiveSspql<> learner(10, 2);
    static_cast<void>(run_episodes(world, learner, 3, 1, CheckpointEvery(4, path("robot"))));
    EXPECT_EQ(files(), 0u);
    EXPECT_THROW(CheckpointEvery(0, path("robot")), std::invalid_argument);
}

TEST_F(CheckpointEveryTest, AnUnwritablePathEndsTheRunWithAllItHasLearnt) {
    auto world = TabularEnvironment(chain_table());
    AdaptiveSspql<> learner(10, 2);
    EXPECT_THROW(static_cast<void>(run_episodes(world, learner, 3, 1, CheckpointEvery(1, path("none/robot")))),
                 std::runtime_error);
    AdaptiveSspql<> other(10, 2);
    static_cast<void>(run_episodes(world, other, 1, 1));
    EXPECT_EQ(save_to_bytes(learner), save_to_bytes(other));
}
