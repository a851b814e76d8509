// SPDX-License-Identifier: MIT
#include <sspql/learn/exact_steps.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/env/chain.hpp>
#include <sspql/env/random_mdp.hpp>
#include <sspql/model/transition_table_builder.hpp>

namespace sspql_exact_steps_test {

using sspql::action_id;
using sspql::ActionId;
using sspql::state_id;
using sspql::TransitionTable;
using sspql::TransitionTableBuilder;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// From 0, "jump" reaches the goal at once with 1 - risk, else a hazard; "walk" goes to 1, 1 to 2, 2 to the goal 3.
/// "wait" stays in 0. The hazard is state 4.
TransitionTable jump_or_walk(double risk) {
    TransitionTableBuilder builder(5, 3);
    if (risk < 1.0) builder.add(state_id(0), action_id(0), state_id(3), 1.0 - risk, 1.0, true);
    if (risk > 0.0) builder.add(state_id(0), action_id(0), state_id(4), risk, 0.0, true);
    builder.add(state_id(0), action_id(1), state_id(1), 1.0);
    builder.add(state_id(0), action_id(2), state_id(0), 1.0);
    builder.add(state_id(1), action_id(1), state_id(2), 1.0);
    builder.add(state_id(2), action_id(1), state_id(3), 1.0, 1.0, true);
    builder.start_in({state_id(0)});
    return builder.build();
}

std::vector<ActionId> policy_of(ActionId first) {
    return {first, action_id(1), action_id(1), sspql::no_action, sspql::no_action};
}

}  // namespace

TEST(ExpectedSteps, OfTheChainAreNineTries) {
    for (const double p : {1.0, 0.3, 0.01}) {
        const TransitionTable table = sspql::chain_table({10, p});
        const std::vector<ActionId> policy(10, action_id(0));
        const auto steps = sspql::expected_steps(table, policy);
        for (std::size_t i = 0; i < 10; ++i) EXPECT_NEAR(steps[i], static_cast<double>(9 - i) / p, 1e-10) << i;
        EXPECT_NEAR(*sspql::optimal_steps(table), 9.0 / p, 1e-9) << p;
    }
}

TEST(ExpectedSteps, AreInfiniteWhereAPolicyMayNeverEnd) {
    const TransitionTable table = jump_or_walk(0.5);
    EXPECT_EQ(sspql::expected_steps(table, policy_of(action_id(0))), (std::vector<double>{1.0, 2.0, 1.0, 0.0, 0.0}));
    EXPECT_EQ(sspql::expected_steps(table, policy_of(action_id(1))), (std::vector<double>{3.0, 2.0, 1.0, 0.0, 0.0}));
    EXPECT_EQ(sspql::expected_steps(table, policy_of(action_id(2))),
              (std::vector<double>{infinity, 2.0, 1.0, 0.0, 0.0}));
}

TEST(OptimalSteps, RulesOutHazards) {
    EXPECT_DOUBLE_EQ(*sspql::optimal_steps(jump_or_walk(0.0)), 1.0);
    EXPECT_DOUBLE_EQ(*sspql::optimal_steps(jump_or_walk(0.01)), 3.0);  // not 1: the jump may fail
    EXPECT_DOUBLE_EQ(*sspql::optimal_steps(jump_or_walk(1.0)), 3.0);
}

TEST(OptimalSteps, IsNoneWhereSuccessIsNotCertain) {
    TransitionTableBuilder builder(3, 1);
    builder.add(state_id(0), action_id(0), state_id(1), 0.9, 1.0, true);
    builder.add(state_id(0), action_id(0), state_id(2), 0.1, 0.0, true);
    EXPECT_FALSE(sspql::optimal_steps(builder.build()).has_value());
    EXPECT_EQ(sspql::least_expected_steps(builder.build())[0], infinity);

    TransitionTableBuilder endless(1, 1);
    endless.add(state_id(0), action_id(0), state_id(0), 1.0);
    EXPECT_FALSE(sspql::optimal_steps(endless.build()).has_value());
}

TEST(OptimalSteps, LeavesOutActionsThatMayLeadToWhereSuccessIsUncertain) {
    // 0 --a0--> 1 or goal; 1 may fail; 0 --a1--> 2 --> goal. a0 is shorter, but not sure.
    TransitionTableBuilder builder(4, 2);
    builder.add(state_id(0), action_id(0), state_id(1), 0.1);
    builder.add(state_id(0), action_id(0), state_id(3), 0.9, 1.0, true);
    builder.add(state_id(0), action_id(1), state_id(2), 1.0);
    builder.add(state_id(1), action_id(0), state_id(3), 0.5, 1.0, true);
    builder.add(state_id(1), action_id(0), state_id(3), 0.5, 0.0, true);
    builder.add(state_id(2), action_id(0), state_id(3), 1.0, 1.0, true);
    builder.start_in({state_id(0)});
    EXPECT_EQ(sspql::least_expected_steps(builder.build()), (std::vector<double>{2.0, infinity, 1.0, 0.0}));
}

TEST(OptimalSteps, AreThoseOfTheBestOfAllPoliciesOfRandomTables) {
    // All 3^5 policies of 20 tables with 5 states and a goal.
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const TransitionTable table = sspql::random_mdp({6, 3, 2}, seed);
        std::vector<double> best(6, infinity);
        for (std::size_t code = 0; code < 243; ++code) {
            std::vector<ActionId> policy;
            for (std::size_t s = 0, rest = code; s < 6; ++s, rest /= 3) policy.push_back(action_id(rest % 3));
            const auto steps = sspql::expected_steps(table, policy);
            for (std::size_t s = 0; s < 6; ++s) best[s] = std::min(best[s], steps[s]);
        }
        const auto steps = sspql::least_expected_steps(table);
        for (std::size_t s = 0; s < 6; ++s) EXPECT_NEAR(steps[s], best[s], 1e-8 * best[s]) << seed << " " << s;
    }
}

TEST(SuccessProbability, ByHand) {
    const TransitionTable table = jump_or_walk(0.25);
    EXPECT_DOUBLE_EQ(sspql::success_probability(table, policy_of(action_id(0)), 1), 0.75);
    EXPECT_DOUBLE_EQ(sspql::success_probability(table, policy_of(action_id(0)), 100), 0.75);
    EXPECT_DOUBLE_EQ(sspql::success_probability(table, policy_of(action_id(1)), 2), 0.0);
    EXPECT_DOUBLE_EQ(sspql::success_probability(table, policy_of(action_id(1)), 3), 1.0);
    EXPECT_DOUBLE_EQ(sspql::success_probability(table, policy_of(action_id(2)), 100), 0.0);
    // Two states of a chain: within h steps with 1 - (1-p)^h.
    const TransitionTable chain = sspql::chain_table({2, 0.3});
    EXPECT_NEAR(sspql::success_probability(chain, {action_id(0), sspql::no_action}, 4), 1.0 - std::pow(0.7, 4), 1e-15);
}

}  // namespace sspql_exact_steps_test
