// SPDX-License-Identifier: MIT
#include <sspql/learn/adaptive/optimism_scale.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "learn/optimism_testing.hpp"

namespace sspql_adaptive_optimism_scale_test {

using namespace sspql;
using namespace sspql::testing;

TEST(OptimismScale, KnowsNothingAtFirst) {
    const OptimismScale scale(0.9, easy());
    EXPECT_FALSE(scale.goal_known());
    EXPECT_FALSE(scale.costs());
    EXPECT_EQ(scale.typical_cost(), 0.0);
    for (const double path : {0.0, 7.0, no_path}) {
        EXPECT_EQ(scale.level(path).here, 1.0);
        EXPECT_EQ(scale.level(path).ahead, 1.0);
    }
    EXPECT_DOUBLE_EQ(scale.step_value(), 0.1);
    EXPECT_TRUE(scale.counts_as_goal(0.1));
    EXPECT_FALSE(scale.counts_as_goal(0.0));
    EXPECT_FALSE(scale.counts_as_goal(-1.0));
}

TEST(OptimismScale, AGoalThatPaysIsAsFarAsDiscountingSays) {
    OptimismScale scale(0.9, easy());
    episode(scale, 4, 0.0, 5.0, true);
    EXPECT_TRUE(scale.goal_known());
    EXPECT_FALSE(scale.costs());
    EXPECT_EQ(scale.top(), 5.0);
    EXPECT_NEAR(scale.typical_cost(), 4.0, 1e-12) << "four steps before the one that paid";
    EXPECT_NEAR(scale.step_value(), 0.5, 1e-12);
    EXPECT_NEAR(scale.at_cost(3.0), 5.0 * 0.729, 1e-12);
    EXPECT_NEAR(scale.cost_of(5.0 * 0.729), 3.0, 1e-12);
    EXPECT_EQ(scale.cost_of(5.0), 0.0);
    EXPECT_LT(scale.cost_of(6.0), 0.0) << "better than any goal so far";
    EXPECT_NEAR(scale.cost_of(-1.0), std::log(1e-6) / std::log(0.9), 1e-9) << "finite for what is worth nothing";
}

TEST(OptimismScale, WhereStepsCostTheUnitIsTheLeastCost) {
    OptimismScale scale(0.9, easy());
    scale.begin_episode();
    scale.observe_step(-6.0, true);
    scale.observe_step(-2.0, true);
    EXPECT_TRUE(scale.costs());
    EXPECT_EQ(scale.unit(), 2.0);
    EXPECT_EQ(scale.step_value(), 2.0);
    EXPECT_EQ(scale.level(no_path).here, 0.0) << "no goal yet: nothing is better than no cost";
    EXPECT_EQ(scale.level(no_path).ahead, 0.0);
    scale.observe_end(-2.0, scale.counts_as_goal(-2.0));
    scale.end_episode();
    EXPECT_EQ(scale.top(), -2.0);
    EXPECT_NEAR(scale.typical_cost(), (-2.0 - (-6.0 - 0.9 * 2.0 - 0.81 * 2.0)) / 2.0, 1e-12);
    EXPECT_EQ(scale.at_cost(3.0), -8.0);
    EXPECT_EQ(scale.cost_of(-8.0), 3.0);
}

TEST(OptimismScale, AtCostAndCostOfAreInverse) {
    for (const bool costs : {false, true}) {
        OptimismScale scale(0.97, easy());
        episode(scale, 3, costs ? -0.25 : 0.0, 0.75, true);
        ASSERT_EQ(scale.costs(), costs);
        for (double c = -3.0; c < 60.0; c += 0.37) {
            EXPECT_NEAR(scale.cost_of(scale.at_cost(c)), c, 1e-9) << c;
            EXPECT_LT(scale.at_cost(c + 0.01), scale.at_cost(c)) << c;
        }
    }
}

TEST(OptimismScale, TheTypicalCostIsTheMedianOfTheLastNineEpisodes) {
    OptimismScale scale(0.99, easy());
    for (int k = 1; k <= 9; ++k) {
        episode(scale, k, 0.0, 1.0);
        EXPECT_NEAR(scale.typical_cost(), 1 + k / 2, 1e-9) << "of 1 to " << k << ", the upper one of two";
    }
    for (int k = 0; k < 3; ++k) episode(scale, 100, 0.0, 1.0);
    EXPECT_NEAR(scale.typical_cost(), 8.0, 1e-9) << "of 4 to 9 and three times 100";
    for (int k = 0; k < 2; ++k) episode(scale, 100, 0.0, 1.0);
    EXPECT_NEAR(scale.typical_cost(), 100.0, 1e-9);
}

TEST(OptimismScale, EpisodesWithoutAGoalSayNothing) {
    OptimismScale scale(0.9, easy());
    episode(scale, 4, 0.0, 1.0);
    scale.begin_episode();
    for (int k = 0; k < 50; ++k) scale.observe_step(0.0, false);
    scale.end_episode();            // cut
    episode(scale, 2, 0.0, -10.0);  // into a hazard
    EXPECT_NEAR(scale.typical_cost(), 4.0, 1e-12);
    EXPECT_EQ(scale.top(), 1.0);
    episode(scale, 8, 0.0, 1.0);
    EXPECT_NEAR(scale.typical_cost(), 8.0, 1e-12) << "and do not count into the next one";
}

TEST(OptimismScale, OptimismIsAPartOfTheTypicalCostWithinLimits) {
    const auto optimism = [](int cost, double limit) {
        OptimismScale scale(0.99, easy(limit));
        episode(scale, cost, 0.0, 1.0);
        return scale.optimism();
    };
    EXPECT_NEAR(optimism(1, 1.0), 2.0, 1e-9) << "the least";
    EXPECT_NEAR(optimism(8, 1.0), 4.0, 1e-9);
    EXPECT_NEAR(optimism(50, 1.0), 6.0, 1e-9) << "the most";
    EXPECT_NEAR(optimism(50, 0.05), 5.0, 1e-9) << "0.05 / (1 - gamma)";
}

TEST(OptimismScale, UnknownActionsMayCostMoreThanPlainSteps) {
    OptimismScale scale(0.99, easy());
    scale.begin_episode();
    for (const double cost : {-1.0, -1.0, -4.0}) scale.observe_step(cost, true);
    for (int k = 0; k < 9; ++k) scale.observe_step(-9.0, false);
    scale.observe_end(-1.0, true);
    scale.end_episode();
    EXPECT_NEAR(scale.optimism(), 12.0, 1e-9) << "6, times the mean cost 2 of first tries";
    OptimismScale low(0.99, easy(0.1));
    for (const double cost : {-1.0, -1.0, -4.0}) low.observe_step(cost, true);
    low.end_episode();
    EXPECT_NEAR(low.optimism(), 4.0, 1e-9) << "2, times 2; and no more than 10";
}

TEST(OptimismScale, MostFirstTriesDecideWhetherStepsCost) {
    OptimismScale scale(0.9, easy());
    const auto first_tries = [&](double reward, int n) {
        for (int k = 0; k < n; ++k) scale.observe_step(reward, true);
        scale.end_episode();
    };
    first_tries(0.0, 2);
    EXPECT_FALSE(scale.costs());
    first_tries(-1.0, 2);
    EXPECT_FALSE(scale.costs()) << "2 of 4: as before";
    for (int k = 0; k < 100; ++k) scale.observe_step(-1.0, false);
    EXPECT_FALSE(scale.costs()) << "the same ones again say nothing";
    first_tries(-1.0, 1);
    EXPECT_TRUE(scale.costs()) << "3 of 5";
    first_tries(0.0, 1);
    EXPECT_TRUE(scale.costs()) << "3 of 6: as before";
    first_tries(0.0, 1);
    EXPECT_FALSE(scale.costs()) << "3 of 7";
}

TEST(OptimismScale, IncomeIsARewardAndNoCost) {
    OptimismScale scale(0.9, easy());
    scale.begin_episode();
    for (int k = 0; k < 5; ++k) scale.observe_step(0.0, true);
    EXPECT_FALSE(scale.goal_known());
    scale.observe_step(0.5, true);
    EXPECT_TRUE(scale.goal_known());
    EXPECT_FALSE(scale.costs());
    EXPECT_EQ(scale.top(), 0.5);
    scale.observe_step(0.0, false);
    scale.observe_step(0.25, false);
    EXPECT_NEAR(scale.top(), 0.25 + 0.81 * 0.5, 1e-12) << "what was collected, discounted backwards";
    scale.observe_step(-7.0, false);
    EXPECT_NEAR(scale.top(), 0.655, 1e-12) << "costs are not subtracted, the most ever stays";
    scale.begin_episode();
    for (int k = 0; k < 400; ++k) scale.observe_step(0.5, false);
    EXPECT_NEAR(scale.top(), 5.0, 1e-9) << "a steady income r is worth r / (1 - gamma)";
    scale.observe_end(2.0, true);
    EXPECT_NEAR(scale.top(), 2.0 + 0.9 * 5.0, 1e-9) << "a goal at its end comes on top";
}

TEST(OptimismScale, IncomeIsNotTheUnitOfCosts) {
    OptimismScale scale(0.9, easy());
    for (int k = 0; k < 3; ++k) scale.observe_step(-1.0, true);
    scale.observe_step(0.001, true);
    EXPECT_EQ(scale.unit(), 1.0) << "the smallest cost, which a small gain on the way is not";
}

TEST(OptimismScale, RefusesParametersOutOfRange) {
    const auto with = [](double OptimismParams::*member, double value) {
        OptimismParams params;
        params.*member = value;
        return OptimismScale(0.9, params);
    };
    for (const auto member : {&OptimismParams::fraction, &OptimismParams::least, &OptimismParams::gap,
                              &OptimismParams::limit, &OptimismParams::saving}) {
        EXPECT_THROW((void)with(member, -0.1), std::invalid_argument);
        EXPECT_THROW((void)with(member, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
    }
    EXPECT_THROW((void)with(&OptimismParams::most, 1.0), std::invalid_argument) << "less than the least";
    EXPECT_THROW((void)with(&OptimismParams::limit, 1.1), std::invalid_argument);
}

}  // namespace sspql_adaptive_optimism_scale_test
