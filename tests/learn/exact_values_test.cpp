// SPDX-License-Identifier: MIT
#include <sspql/learn/exact_values.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/env/chain.hpp>
#include <sspql/env/random_mdp.hpp>
#include <sspql/model/transition_table_builder.hpp>

namespace sspql_exact_values_test {

using sspql::action_id;
using sspql::ActionId;
using sspql::state_id;
using sspql::TransitionTable;
using sspql::TransitionTableBuilder;

namespace {

template <class Error, class F>
std::string error_of(F&& f) {
    try {
        f();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

/// In 0: "work" earns 1 and stays with .5, else ends with 0; "leave" ends with 1.5 at once. State 1 is where it ends.
TransitionTable work_or_leave() {
    TransitionTableBuilder builder(2, 2);
    builder.add(state_id(0), action_id(0), state_id(0), 0.5, 1.0);
    builder.add(state_id(0), action_id(0), state_id(1), 0.5, 0.0, true);
    builder.add(state_id(0), action_id(1), state_id(1), 1.0, 1.5, true);
    return builder.build();
}

/// Two states that lead to each other, reward 1 from 0 to 1 and 0 back; nothing ends.
TransitionTable ring() {
    TransitionTableBuilder builder(2, 1);
    builder.add(state_id(0), action_id(0), state_id(1), 1.0, 1.0);
    builder.add(state_id(1), action_id(0), state_id(0), 1.0);
    return builder.build();
}

}  // namespace

TEST(OptimalValues, ByHand) {
    // Working for ever: V = .5 (1 + gamma V), V = .5 / (1 - gamma / 2) <= 1 < 1.5.
    EXPECT_NEAR(sspql::optimal_values(work_or_leave(), 1.0)[0], 1.5, 1e-12);
    EXPECT_EQ(sspql::optimal_values(work_or_leave(), 1.0)[1], 0.0);
    EXPECT_EQ(sspql::greedy_policy(work_or_leave(), {1.5, 0.0}, 1.0),
              (std::vector<ActionId>{action_id(1), sspql::no_action}));
    // V(0) = 1 + gamma V(1), V(1) = gamma V(0): V(0) = 1 / (1 - gamma^2).
    for (const double gamma : {0.0, 0.5, 0.8, 0.99}) {
        const auto values = sspql::optimal_values(ring(), gamma, 1e-9);
        EXPECT_NEAR(values[0], 1.0 / (1.0 - gamma * gamma), 1e-9) << gamma;
        EXPECT_NEAR(values[1], gamma / (1.0 - gamma * gamma), 1e-9) << gamma;
    }
}

TEST(OptimalValues, OfTheChainAreThoseOfOneWaitPerState) {
    // V(i) = p (r + gamma V(i+1)) + (1-p) gamma V(i): V(i) = c^(9-i) / gamma with c = p gamma / (1 - (1-p) gamma).
    const double gamma = 0.8;
    const double p = 0.3;
    const double c = p * gamma / (1.0 - (1.0 - p) * gamma);
    const auto values = sspql::optimal_values(sspql::chain_table({10, p}), gamma, 1e-12);
    for (int i = 0; i < 9; ++i)
        EXPECT_NEAR(values[static_cast<std::size_t>(i)], std::pow(c, 9 - i) / gamma, 1e-11) << i;
    EXPECT_EQ(values[9], 0.0);
}

TEST(OptimalValues, KeepTheirTolerance) {
    for (const double tolerance : {1e-2, 1e-5, 1e-8}) {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const TransitionTable table = sspql::random_mdp({30, 3, 4, -1.0, 0.5, 2.0}, seed);
            const auto exact = sspql::optimal_values(table, 0.95, 1e-13);
            const auto values = sspql::optimal_values(table, 0.95, tolerance);
            for (std::size_t s = 0; s < exact.size(); ++s) EXPECT_NEAR(values[s], exact[s], tolerance) << seed;
        }
    }
}

TEST(OptimalValues, SolveTheBellmanEquation) {
    for (const double gamma : {0.9, 1.0}) {
        const TransitionTable table = sspql::random_mdp({40, 4, 3, -1.0, -0.1, 3.0}, 5);
        const auto values = sspql::optimal_values(table, gamma, 1e-12);
        for (std::size_t s = 0; s + 1 < table.states(); ++s) {
            double best = -1e9;
            for (std::size_t a = 0; a < 4; ++a) {
                best = std::max(best, sspql::action_value(table, values, gamma, state_id(s), action_id(a)));
            }
            EXPECT_NEAR(values[s], best, 1e-10);
        }
    }
}

TEST(OptimalValues, RefuseWhatHasNone) {
    EXPECT_EQ(error_of<std::runtime_error>([] { (void)sspql::optimal_values(ring(), 1.0, 1e-6, 50); }),
              "value iteration did not settle in 50 sweeps, gamma 1");
    EXPECT_EQ(error_of<std::invalid_argument>([] { (void)sspql::optimal_values(ring(), 1.5); }),
              "gamma must lie in [0, 1], got 1.5");
    EXPECT_EQ(error_of<std::invalid_argument>([] { (void)sspql::optimal_values(ring(), 0.5, 0.0); }),
              "tolerance must be finite and > 0, got 0");
}

TEST(GreedyPolicy, TakesTheLeastIdOnTies) {
    TransitionTableBuilder builder(4, 3);  // three actions, all alike
    for (std::size_t s = 0; s < 3; ++s) {
        for (std::size_t a = 0; a < 3; ++a) builder.add(state_id(s), action_id(a), state_id(s + 1), 1.0, 1.0, s == 2);
    }
    const TransitionTable table = builder.build();
    const auto policy = sspql::greedy_policy(table, sspql::optimal_values(table, 0.9), 0.9);
    EXPECT_EQ(policy, (std::vector<ActionId>{action_id(0), action_id(0), action_id(0), sspql::no_action}));
    EXPECT_EQ(error_of<std::invalid_argument>([&] { (void)sspql::greedy_policy(table, {1.0}, 0.9); }),
              "number of values must be the number of states 4, got 1");
}

TEST(PolicyValues, ByHand) {
    // Always work: V = .5 (1 + gamma V).
    const std::vector<ActionId> work{action_id(0), sspql::no_action};
    EXPECT_NEAR(sspql::policy_values(work_or_leave(), work, 1.0)[0], 1.0, 1e-14);
    EXPECT_NEAR(sspql::policy_values(work_or_leave(), work, 0.8)[0], 0.5 / 0.6, 1e-14);
    EXPECT_EQ(sspql::policy_values(work_or_leave(), work, 0.8)[1], 0.0);
}

TEST(PolicyValues, OfTheGreedyPolicyAreTheOptimalOnes) {
    for (const double gamma : {0.8, 0.99, 1.0}) {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const TransitionTable table = sspql::random_mdp({50, 3, 4, -1.0, -0.1, 3.0}, seed);
            const auto values = sspql::optimal_values(table, gamma, 1e-12);
            const auto of_policy = sspql::policy_values(table, sspql::greedy_policy(table, values, gamma), gamma);
            for (std::size_t s = 0; s < values.size(); ++s) EXPECT_NEAR(values[s], of_policy[s], 1e-9) << seed;
        }
    }
}

TEST(PolicyValues, RefuseWhatIsNoPolicyOrNeverEnds) {
    const auto values_of = [](const TransitionTable& table, const std::vector<ActionId>& policy, double gamma) {
        return error_of<std::exception>([&] { (void)sspql::policy_values(table, policy, gamma); });
    };
    EXPECT_EQ(values_of(ring(), {action_id(0), action_id(0)}, 1.0),
              "with gamma 1 the policy has no value in state 0: it may go on for ever");
    EXPECT_EQ(values_of(ring(), {action_id(0)}, 0.9), "size of the policy must be the number of states 2, got 1");
    EXPECT_EQ(values_of(ring(), {action_id(0), action_id(1)}, 0.9),
              "policy must give state 1 one of its actions, got 1");
}

TEST(OptimalReturn, IsTheUndiscountedMeanOverTheStarts) {
    EXPECT_NEAR(*sspql::optimal_return(work_or_leave()), 1.5, 1e-12);
    EXPECT_NEAR(*sspql::optimal_return(sspql::chain_table()), 1.0, 1e-12);
    TransitionTableBuilder two(3, 1);
    two.add(state_id(0), action_id(0), state_id(2), 1.0, 1.0, true);
    two.add(state_id(1), action_id(0), state_id(2), 1.0, -4.0, true);
    EXPECT_DOUBLE_EQ(*sspql::optimal_return(two.build()), -1.5);
    two.start_in({state_id(1)});
    EXPECT_DOUBLE_EQ(*sspql::optimal_return(two.build()), -4.0);
}

TEST(OptimalReturn, IsNoneInAWorldWithoutEnds) {
    EXPECT_FALSE(sspql::optimal_return(ring()).has_value());
    // An end that pays less than going on for ever: found only by the limit of sweeps.
    TransitionTableBuilder loop(1, 2);
    loop.add(state_id(0), action_id(0), state_id(0), 1.0, 1.0);
    loop.add(state_id(0), action_id(1), state_id(0), 1.0, 5.0, true);
    EXPECT_FALSE(sspql::optimal_return(loop.build()).has_value());
}

TEST(OptimalReturn, DoesNotMindAPocketThatNoEpisodeVisits) {
    TransitionTableBuilder builder(3, 1);
    builder.add(state_id(0), action_id(0), state_id(2), 1.0, 1.0, true);
    builder.add(state_id(1), action_id(0), state_id(1), 1.0, -1.0);
    builder.start_in({state_id(0)});
    EXPECT_DOUBLE_EQ(*sspql::optimal_return(builder.build()), 1.0);
}

}  // namespace sspql_exact_values_test
