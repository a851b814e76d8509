// SPDX-License-Identifier: MIT
#include <sspql/learn/prioritized_sweeping.hpp>

#include <stdexcept>

#include <gtest/gtest.h>

#include <sspql/learn/action_selector.hpp>

namespace sspql_prioritized_sweeping_test {

using namespace sspql;

namespace {

constexpr StateId s0{0}, s1{1}, s2{2}, s3{3}, s4{4};
constexpr ActionId a0{0}, a1{1};

struct GreedyEverywhere : ModelPolicies {
    using Selector = EpsilonGreedy;
    using LegalActions = AllActions;
};

PrioritizedSweepingParams<> planning(std::size_t backups, double threshold = 1e-4) {
    PrioritizedSweepingParams<> params;
    params.planning_steps = backups;
    params.threshold = threshold;
    return params;
}

/// 0 -a0-> 1 -a0-> 2 -a0-> 3 (end, 1), the way seen once in that order.
void walk_chain(PrioritizedSweeping<>& learner) {
    learner.observe(s0, a0, 0.0, s1, false);
    learner.observe(s1, a0, 0.0, s2, false);
    EXPECT_EQ(learner.backups(), 0u) << "nothing has changed yet";
    learner.observe(s2, a0, 1.0, s3, true);
}

/// A step from which nothing can be learnt: time to plan.
void idle(PrioritizedSweeping<>& learner) { learner.observe(s4, a0, 0.0, s4, false); }

}  // namespace

// gamma 0.8: 1, 0.8, 0.64, one backup each.
TEST(PrioritizedSweeping, OneRewardReachesTheWholeWayBack) {
    PrioritizedSweeping<> learner(5, 2, planning(10));
    walk_chain(learner);
    EXPECT_DOUBLE_EQ(learner.q()(s2, a0), 1.0);
    EXPECT_DOUBLE_EQ(learner.q()(s1, a0), 0.8);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.64);
    EXPECT_EQ(learner.backups(), 3u);
}

TEST(PrioritizedSweeping, DoesSoManyBackupsAStepAndKeepsTheRestForLater) {
    PrioritizedSweeping<> learner(5, 2, planning(1));
    walk_chain(learner);
    EXPECT_DOUBLE_EQ(learner.q()(s2, a0), 1.0);
    EXPECT_EQ(learner.q()(s1, a0), 0.0);
    idle(learner);
    EXPECT_DOUBLE_EQ(learner.q()(s1, a0), 0.8);
    EXPECT_EQ(learner.q()(s0, a0), 0.0);
    idle(learner);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.64);
    idle(learner);
    EXPECT_EQ(learner.backups(), 3u) << "and then nothing is left";
}

// a1 leads from 0 to 2 every second time, a0 from 1 always: 1 has twice the priority.
TEST(PrioritizedSweeping, TheLargerChangeComesFirst) {
    PrioritizedSweeping<> learner(5, 2, planning(2));
    learner.observe(s0, a1, 0.0, s2, false);
    learner.observe(s0, a1, 0.0, s4, false);
    learner.observe(s1, a0, 0.0, s2, false);
    learner.observe(s2, a0, 1.0, s3, true);
    EXPECT_DOUBLE_EQ(learner.q()(s1, a0), 0.8);
    EXPECT_EQ(learner.q()(s0, a1), 0.0);
    idle(learner);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a1), 0.4);
}

// Changes of 1, 0.8 and 0.64 x 0.8 ...: with a threshold of 0.7 the second is passed on no further.
TEST(PrioritizedSweeping, SmallChangesAreNotPassedOn) {
    PrioritizedSweeping<> learner(5, 2, planning(10, 0.7));
    walk_chain(learner);
    EXPECT_DOUBLE_EQ(learner.q()(s1, a0), 0.8);
    EXPECT_EQ(learner.q()(s0, a0), 0.0);
    EXPECT_EQ(learner.backups(), 2u);
    PrioritizedSweeping<> deaf(5, 2, planning(10, 1.0));
    walk_chain(deaf);
    EXPECT_EQ(deaf.backups(), 0u);
    EXPECT_EQ(deaf.q()(s2, a0), 0.0);
}

// Priority 0.8 x 1/4 of the change for a way that was taken one time in four: 0.2.
TEST(PrioritizedSweeping, TheChangeIsWeightedByItsProbability) {
    for (const double threshold : {0.19, 0.21}) {
        PrioritizedSweeping<> learner(5, 2, planning(10, threshold));
        learner.observe(s0, a0, 0.0, s2, false);
        for (int k = 0; k < 3; ++k) learner.observe(s0, a0, 0.0, s4, false);
        learner.observe(s2, a0, 1.0, s3, true);
        EXPECT_DOUBLE_EQ(learner.q()(s0, a0), threshold < 0.2 ? 0.2 : 0.0);
    }
}

// 3 of 4 to the goal: 0.75, whatever alpha is.
TEST(PrioritizedSweeping, BacksUpTheMeanOfAllOutcomes) {
    PrioritizedSweepingParams<> params = planning(10);
    params.alpha = 0.0;
    PrioritizedSweeping<> learner(5, 2, params);
    for (int k = 0; k < 4; ++k) learner.observe(s0, a0, k == 1 ? 0.0 : 1.0, k == 1 ? s4 : s3, true);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.75);
}

// Half of the time it stays: Q = 0.5 + 0.5 x 0.8 Q = 5/6, by backups that raise themselves.
TEST(PrioritizedSweeping, AStateThatLeadsToItselfConverges) {
    PrioritizedSweeping<> learner(5, 1, planning(1000, 1e-13));
    learner.observe(s0, a0, 0.0, s0, false);
    learner.observe(s0, a0, 1.0, s3, true);
    EXPECT_NEAR(learner.q()(s0, a0), 5.0 / 6.0, 1e-12);
    EXPECT_LT(learner.backups(), 40u) << "0.4^33 < 1e-13";
}

TEST(PrioritizedSweeping, ValuesThatOnlyMoveBelowTheBestAreNotPassedOn) {
    PrioritizedSweeping<> learner(5, 2, planning(10));
    walk_chain(learner);
    const auto backups = learner.backups();
    learner.observe(s2, a1, 0.5, s4, true);  // the worse action of state 2
    EXPECT_DOUBLE_EQ(learner.q()(s2, a1), 0.5);
    EXPECT_EQ(learner.backups(), backups + 1);
}

TEST(PrioritizedSweeping, IllegalActionsRaiseNobody) {
    PrioritizedSweeping<> learner(5, 2, planning(10));
    learner.set_legal_actions(s2, ActionSet::of(2, {a1}));
    walk_chain(learner);
    EXPECT_DOUBLE_EQ(learner.q()(s2, a0), 1.0);
    EXPECT_EQ(learner.q()(s1, a0), 0.0);
    EXPECT_EQ(learner.backups(), 1u);
    learner.observe(s2, a1, 0.5, s3, true);
    EXPECT_DOUBLE_EQ(learner.q()(s1, a0), 0.4);
}

// (0 + 1 x 1) / (1 + 1) after one failure, 1/3 after two.
TEST(PrioritizedSweeping, APseudoCountIsOptimistic) {
    PrioritizedSweepingParams<> params = planning(10);
    params.kappa = 1.0;
    PrioritizedSweeping<> learner(5, 2, params);
    learner.observe(s0, a0, 0.0, s4, true);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.5);
    learner.observe(s0, a0, 0.0, s4, true);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 1.0 / 3.0);
}

// A cap of 2: before the third outcome the two good ones fade to 1, before the fourth all fade to 0.5 each.
TEST(PrioritizedSweeping, ACapLetsThePastFade) {
    PrioritizedSweepingParams<> params = planning(10);
    params.cap = 2.0;
    PrioritizedSweeping<> learner(5, 2, params);
    for (int k = 0; k < 2; ++k) learner.observe(s0, a0, 1.0, s3, true);
    learner.observe(s0, a0, 0.0, s4, true);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.5);
    learner.observe(s0, a0, 0.0, s4, true);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.25);
    for (int k = 0; k < 4; ++k) learner.observe(s0, a0, 0.0, s4, true);  // 0.5, 0.25, ... 1/32: above 0.02
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 1.0 / 64.0);
    learner.observe(s0, a0, 0.0, s4, true);  // 1/64 < 0.02: forgotten
    EXPECT_EQ(learner.q()(s0, a0), 0.0);
    EXPECT_EQ(learner.counts().n(s0, a0, s3), 0.0);
}

TEST(PrioritizedSweeping, OtherGoalsEmptyTheQueue) {
    PrioritizedSweeping<> learner(5, 2, planning(1));
    walk_chain(learner);  // (1,a0) waits
    learner.set_goals({{s4}});
    idle(learner);
    EXPECT_EQ(learner.backups(), 1u);
    EXPECT_EQ(learner.q()(s2, a0), 0.0);
    EXPECT_EQ(learner.counts().n(s2, a0), 1.0) << "the model stays";
}

TEST(PrioritizedSweeping, TheOptimisticPresetIsTheStrongBaseline) {
    const auto params = PrioritizedSweepingParams<>::optimistic();
    EXPECT_EQ(params.initial_q, 1.0);
    EXPECT_EQ(params.cap, 5.0);
    EXPECT_EQ(params.kappa, 0.05);
    EXPECT_EQ(params.planning_steps, 10u);
    EXPECT_NO_THROW((PrioritizedSweeping<GreedyEverywhere>(2, 2)));
    EXPECT_THROW(PrioritizedSweeping<>(2, 2, planning(10, -1.0)), std::invalid_argument);
}

}  // namespace sspql_prioritized_sweeping_test

// Every member compiles.
template class sspql::PrioritizedSweeping<>;
template class sspql::PrioritizedSweeping<sspql_prioritized_sweeping_test::GreedyEverywhere>;
