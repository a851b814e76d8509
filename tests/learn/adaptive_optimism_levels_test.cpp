// SPDX-License-Identifier: MIT
// What goals that were told are worth, and levels of optimism under the bound of the shortest path.
#include <sspql/learn/adaptive/optimism_scale.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include "learn/optimism_testing.hpp"

namespace sspql_adaptive_optimism_levels_test {

using namespace sspql;
using namespace sspql::testing;

TEST(OptimismLevels, ToldGoalsReplaceWhatWasDiscovered) {
    OptimismScale scale(0.9, easy());
    episode(scale, 4, 0.0, 5.0);
    scale.told_goals();
    EXPECT_TRUE(scale.goal_known());
    EXPECT_EQ(scale.top(), 1.0);
    EXPECT_EQ(scale.typical_cost(), 0.0);
    scale.begin_episode();
    for (int k = 0; k < 3; ++k) scale.observe_step(0.5, false);  // pays nothing now
    scale.observe_end(1.0, true);
    scale.end_episode();
    EXPECT_EQ(scale.top(), 1.0);
    scale.told_goals();  // others
    EXPECT_EQ(scale.top(), 1.0);
    scale.discover_goals();
    EXPECT_EQ(scale.top(), 5.0);
    EXPECT_TRUE(scale.goal_known());
    EXPECT_EQ(scale.typical_cost(), 0.0) << "episodes to the other goals say nothing of these";
    scale.discover_goals();  // once more changes nothing
    EXPECT_EQ(scale.top(), 5.0);

    OptimismScale fresh(0.9, easy());
    fresh.told_goals();
    fresh.discover_goals();
    EXPECT_FALSE(fresh.goal_known());
    EXPECT_EQ(fresh.level(no_path).here, 1.0);
}

TEST(OptimismLevels, ToldGoalsAreWorthNothingWhereStepsCost) {
    OptimismScale scale(0.9, easy());
    scale.observe_step(-2.0, true);
    scale.told_goals();
    EXPECT_EQ(scale.top(), 0.0);
    EXPECT_EQ(scale.at_cost(3.0), -6.0);
}

TEST(OptimismLevels, LevelsAreBoundedByTheShortestPath) {
    OptimismScale scale(0.99, easy());
    episode(scale, 20, 0.0, 1.0);  // c = 6
    const auto steps = [&](double path) { return scale.cost_of(scale.level(path).here); };
    EXPECT_NEAR(steps(0.0), 6.0, 1e-9);
    EXPECT_NEAR(steps(7.0), 6.0, 1e-9);
    EXPECT_NEAR(steps(30.0), 29.0, 1e-9) << "at most `saving` nearer than the path";
    EXPECT_NEAR(steps(no_path), 19.0, 1e-9) << "no path: as far as usual";
    for (const double path : {0.0, 15.0, 30.0, no_path}) {
        EXPECT_NEAR(scale.cost_of(scale.level(path).ahead), steps(path) + 3.0, 1e-9);
    }
}

TEST(OptimismLevels, WhereStepsCostPathsAreDiscountedLikeValues) {
    OptimismScale scale(0.99, easy(0.5));  // 50 steps at most
    episode(scale, 20, -1.0, -1.0, true);
    const auto steps = [&](double path) { return scale.cost_of(scale.level(path).here); };
    EXPECT_NEAR(steps(30.0), (1.0 - std::pow(0.99, 30.0)) / 0.01 - 1.0, 1e-9);
    EXPECT_NEAR(steps(no_path), scale.typical_cost() - 1.0, 1e-9);
    for (int k = 0; k < 9; ++k) episode(scale, 500, -1.0, -1.0);
    EXPECT_NEAR(steps(no_path), 49.0, 1e-9) << "no farther than the limit, without a path";
}

}  // namespace sspql_adaptive_optimism_levels_test
