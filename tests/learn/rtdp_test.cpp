// SPDX-License-Identifier: MIT
#include <sspql/learn/rtdp.hpp>

#include <stdexcept>

#include <gtest/gtest.h>

#include <sspql/learn/action_selector.hpp>

namespace sspql_rtdp_test {

using namespace sspql;

namespace {

constexpr StateId s0{0}, s1{1}, s2{2};
constexpr ActionId a0{0}, a1{1}, a2{2};

struct GreedyEverywhere : ModelPolicies {
    using Selector = EpsilonGreedy;
    using LegalActions = AllActions;
};

}  // namespace

// 0 -a0-> 1 -a0-> 2 (end, 1), gamma 0.8: each walk carries the value one state further back.
TEST(Rtdp, UpdatesTheStateJustLeftOnly) {
    Rtdp<> learner(3, 3);
    learner.observe(s0, a0, 0.0, s1, false);
    learner.observe(s1, a0, 1.0, s2, true);
    EXPECT_DOUBLE_EQ(learner.q()(s1, a0), 1.0);
    EXPECT_EQ(learner.q()(s0, a0), 0.0);
    learner.observe(s0, a0, 0.0, s1, false);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.8);
}

// Both actions of 0 were tried before anything was known of 1; then one try of a1 brings both up to date.
TEST(Rtdp, UpdatesEveryActionTriedInThatState) {
    RtdpParams<> params;
    params.initial_q = 0.25;
    Rtdp<> learner(3, 3, params);
    learner.observe(s0, a0, 0.0, s1, false);
    learner.observe(s0, a1, 0.0, s0, false);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.8 * 0.25);
    for (const ActionId a : {a0, a1, a2}) learner.observe(s1, a, 1.0, s2, true);
    learner.observe(s0, a1, 0.0, s0, false);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.8);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a1), 0.64) << "stays in 0, whose best is 0.8 by now";
    EXPECT_DOUBLE_EQ(learner.q()(s0, a2), 0.25) << "never tried";
}

// 1 of 4 outcomes ends with 1: 0.25, whatever alpha is.
TEST(Rtdp, BacksUpTheMeanOfAllOutcomes) {
    RtdpParams<> params;
    params.alpha = 0.0;
    Rtdp<> learner(3, 3, params);
    for (int k = 0; k < 4; ++k) learner.observe(s0, a0, k == 2 ? 1.0 : 0.0, k == 2 ? s2 : s1, true);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.25);
    EXPECT_EQ(learner.visits()(s0, a0), 4u);
}

TEST(Rtdp, IllegalActionsAreNotTheBest) {
    Rtdp<> learner(3, 3);
    learner.set_legal_actions(s1, ActionSet::of(3, {a1}));
    learner.observe(s1, a0, 1.0, s2, true);
    learner.observe(s0, a0, 0.0, s1, false);
    EXPECT_EQ(learner.q()(s0, a0), 0.0);
    learner.observe(s1, a1, 0.5, s2, true);
    learner.observe(s0, a0, 0.0, s1, false);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.4);
}

TEST(Rtdp, PseudoCountsAndCapsHoldHereToo) {
    RtdpParams<> params;
    params.kappa = 1.0;
    params.unknown_value = 3.0;
    params.cap = 1.0;
    Rtdp<> learner(3, 3, params);
    for (int k = 0; k < 5; ++k) learner.observe(s0, a0, 1.0, s2, true);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 2.0) << "(1 + 3) / 2: one observation counts, and one pseudo-count";
}

TEST(Rtdp, CountsWhatItTouches) {
    Rtdp<> learner(3, 3);
    learner.observe(s0, a0, 0.0, s1, false);  // a record, one edge
    EXPECT_EQ(learner.model_operations(), 2u);
    learner.observe(s0, a1, 0.0, s1, false);  // a record, one edge for each of two actions
    EXPECT_EQ(learner.model_operations(), 5u);
    EXPECT_NO_THROW((Rtdp<GreedyEverywhere>(2, 2)));
    RtdpParams<> params;
    params.kappa = -1.0;
    EXPECT_THROW(Rtdp<>(2, 2, params), std::invalid_argument);
}

}  // namespace sspql_rtdp_test

// Every member compiles.
template class sspql::Rtdp<>;
template class sspql::Rtdp<sspql_rtdp_test::GreedyEverywhere>;
