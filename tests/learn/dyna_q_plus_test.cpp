// SPDX-License-Identifier: MIT
#include <sspql/learn/dyna_q_plus.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>

#include <gtest/gtest.h>

#include <sspql/learn/action_selector.hpp>

namespace sspql_dyna_q_plus_test {

using namespace sspql;

namespace {

constexpr StateId s0{0}, s1{1}, s2{2};
constexpr ActionId a0{0}, a1{1};

struct GreedyEverywhere : ValuePolicies {
    using Selector = EpsilonGreedy;
    using LegalActions = AllActions;
};

/// One planning step, time bonus 0.1.
DynaQPlusParams<> planning(double alpha, double gamma) {
    DynaQPlusParams<> params;
    params.alpha = alpha;
    params.gamma = gamma;
    params.planning_steps = 1;
    params.time_bonus = 0.1;
    return params;
}

}  // namespace

// Only a1 may be planned in state 0, and it was never tried: reward 0.1 sqrt(steps so far), and nothing else (gamma 0).
TEST(DynaQPlus, AnActionNeverTriedEarnsTheRootOfAllTime) {
    DynaQPlus<> learner(2, 2, planning(1.0, 0.0));
    learner.set_legal_actions(s0, ActionSet::of(2, {a1}));
    for (int now = 1; now <= 9; ++now) {
        learner.observe(s0, a0, 0.0, s1, true);
        EXPECT_DOUBLE_EQ(learner.q()(s0, a1), 0.1 * std::sqrt(now));
    }
    EXPECT_DOUBLE_EQ(learner.q()(s0, a1), 0.3);
    EXPECT_EQ(learner.visits()(s0, a1), 0u);
    EXPECT_EQ(learner.model_operations(), 18u) << "nine records, nine looks";
}

// Tried at step 1 with reward 2 and not since: at step 5, tau = 4, a bonus of 0.2 on top.
TEST(DynaQPlus, TheBonusCountsFromTheLastTry) {
    DynaQPlus<> learner(2, 2, planning(1.0, 0.0));
    learner.set_legal_actions(s0, ActionSet::of(2, {a1}));
    learner.observe(s0, a1, 2.0, s1, true);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a1), 2.0);
    for (int k = 0; k < 4; ++k) learner.observe(s0, a0, 0.0, s1, true);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a1), 2.2);
    learner.observe(s0, a1, 1.0, s1, true);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a1), 1.0) << "the last outcome, with no bonus";
}

// gamma 1/2: q <- 0.1 sqrt(now) + q / 2, as if it led back to state 0.
TEST(DynaQPlus, AnActionNeverTriedLeadsBackToItsState) {
    DynaQPlus<> learner(2, 2, planning(1.0, 0.5));
    learner.set_legal_actions(s0, ActionSet::of(2, {a1}));
    double q = 0.0;
    for (int now = 1; now <= 5; ++now) {
        learner.observe(s0, a0, 0.0, s1, true);
        q = 0.1 * std::sqrt(now) + 0.5 * q;
        EXPECT_DOUBLE_EQ(learner.q()(s0, a1), q);
    }
}

// Rate 1/2, gamma 1/2, one step of reward 1 to the end: Q(0,a0) = 0.5. Planning takes either action:
// a0: 0.5 + 0.5 (1 - 0.5) = 0.75, tau = 0; a1, never tried: 0.5 (0.1 sqrt(1) + 0.5 x 0.5) = 0.175.
TEST(DynaQPlus, PlansTriedAndUntriedActionsAlike) {
    int tried = 0;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        DynaQPlus<> learner(2, 2, planning(0.5, 0.5), seed);
        learner.observe(s0, a0, 1.0, s1, true);
        const bool a0_planned = learner.q()(s0, a0) > 0.5;
        EXPECT_DOUBLE_EQ(learner.q()(s0, a0), a0_planned ? 0.75 : 0.5);
        EXPECT_DOUBLE_EQ(learner.q()(s0, a1), a0_planned ? 0.0 : 0.175);
        tried += a0_planned ? 1 : 0;
    }
    EXPECT_NEAR(tried, 500, 60);  // 4 standard deviations
}

TEST(DynaQPlus, PlansInStatesThatWereLeftOnly) {
    DynaQPlusParams<> params = planning(1.0, 0.8);
    params.planning_steps = 100;
    DynaQPlus<> learner(3, 2, params);
    learner.observe(s0, a0, 0.0, s1, false);
    for (const ActionId a : {a0, a1}) {
        EXPECT_EQ(learner.q()(s1, a), 0.0);
        EXPECT_EQ(learner.q()(s2, a), 0.0);
    }
    EXPECT_GT(learner.q()(s0, a1), 0.0);
}

// Uniform over visited states, then over legal actions: 0 has two, 1 has one, so (1,a0) gets half of the planning.
TEST(DynaQPlus, StatesShareThePlanningEvenly) {
    DynaQPlusParams<> params = planning(1.0, 0.0);
    std::map<double, int> seen;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        DynaQPlus<> learner(3, 2, params, seed);
        learner.set_legal_actions(s0, ActionSet::of(2, {a1}));
        learner.set_legal_actions(s1, ActionSet::of(2, {a1}));
        learner.observe(s0, a0, 0.0, s2, true);
        learner.observe(s1, a0, 0.0, s2, true);
        ++seen[learner.q()(s1, a1)];
    }
    EXPECT_NEAR(seen[0.1 * std::sqrt(2.0)], 500, 60);
    EXPECT_EQ(seen.size(), 2u);
}

TEST(DynaQPlus, PlanningTakesTheBestOfLegalActions) {
    DynaQPlusParams<> params = planning(0.5, 0.8);
    params.time_bonus = 0.0;
    params.planning_steps = 50;
    DynaQPlus<> learner(3, 2, params, 1);
    learner.set_legal_actions(s1, ActionSet::of(2, {a1}));
    learner.observe(s1, a0, 1.0, s2, true);
    EXPECT_DOUBLE_EQ(learner.q()(s1, a0), 0.5) << "illegal: never planned";
    learner.observe(s0, a0, 0.0, s1, false);
    EXPECT_EQ(learner.q()(s0, a0), 0.0);
    for (int k = 0; k < 5; ++k) learner.observe(s1, a1, 0.25, s2, true);
    EXPECT_NEAR(learner.q()(s0, a0), 0.2, 1e-9);
}

// The point of it: a door that was shut is tried again. Without a bonus a learner that knows a way never does.
//
//     0 --a1--> 1 (end, 0.5), always      0 --a0--> stays, until step 100; then to 2 (end, 1)
TEST(DynaQPlus, TriesAgainWhatDidNotWorkLongAgo) {
    const auto finds_it = [](double time_bonus) {
        DynaQPlusParams<> params = planning(0.5, 0.8);
        params.time_bonus = time_bonus;
        params.planning_steps = 10;
        DynaQPlus<> learner(3, 2, params, 1);
        int found = 0;
        for (int now = 0; now < 2000; ++now) {
            const ActionId a = learner.running() ? learner.action() : learner.begin(s0);
            const bool open = now >= 100;
            if (a == a1 || open) {
                learner.end(a == a1 ? 0.5 : 1.0, a == a1 ? s1 : s2, true);
                found += a == a0 ? 1 : 0;
            } else {
                (void)learner.step(0.0, s0);
            }
        }
        return found;
    };
    EXPECT_EQ(finds_it(0.0), 0);
    EXPECT_GT(finds_it(0.02), 500);
}

TEST(DynaQPlus, RefusesATimeBonusThatIsNegative) {
    DynaQPlusParams<> params;
    for (const double bad : {-0.1, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        params.time_bonus = bad;
        EXPECT_THROW(DynaQPlus<>(2, 2, params), std::invalid_argument);
    }
    EXPECT_NO_THROW((DynaQPlus<GreedyEverywhere>(2, 2)));
}

}  // namespace sspql_dyna_q_plus_test

// Every member compiles.
template class sspql::DynaQPlus<>;
template class sspql::DynaQPlus<sspql_dyna_q_plus_test::GreedyEverywhere>;
