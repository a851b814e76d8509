// SPDX-License-Identifier: MIT
// Eq. 1: Q(s,a) <- Q(s,a) + alpha [r + gamma max_a' Q(s',a') - Q(s,a)]
#include <sspql/learn/q_update.hpp>

#include <gtest/gtest.h>

#include <sspql/learn/q_table.hpp>
#include <sspql/learn/transition.hpp>
#include <sspql/spaces/action_set.hpp>
#include <sspql/spaces/legal_actions.hpp>

using sspql::ActionId;
using sspql::ActionSet;
using sspql::AllActions;
using sspql::LegalActionTable;
using sspql::QTable;
using sspql::StateId;

namespace {

constexpr ActionId a0{0}, a1{1}, a2{2};
constexpr StateId s0{0}, s1{1};

/// Q(s0,a1) = 0.5; Q(s1,.) = 0.1, 0.25, 2.
QTable table() {
    QTable q(2, 3);
    q(s0, a1) = 0.5;
    q(s1, a0) = 0.1;
    q(s1, a1) = 0.25;
    q(s1, a2) = 2.0;
    return q;
}

}  // namespace

// alpha = 0.8, gamma = 0.8, r = 0.1: 0.5 + 0.8 (0.1 + 0.8 x 2 - 0.5) = 0.5 + 0.8 x 1.2 = 1.46
TEST(Eq1QUpdate, MovesByAlphaTowardsTheTarget) {
    QTable q = table();
    q_update(q, {s0, a1, 0.1, s1}, 0.8, 0.8, AllActions{});
    EXPECT_DOUBLE_EQ(q(s0, a1), 1.46);
    EXPECT_EQ(q(s0, a0), 0.0);
    EXPECT_EQ(q(s0, a2), 0.0);
}

// Algorithm 2 line 7 prints Q(s',a) on the left: s is the state before the action.
TEST(Eq1QUpdate, ChangesTheStateBeforeTheAction) {
    QTable q = table();
    q_update(q, {s0, a1, 0.1, s1}, 0.8, 0.8, AllActions{});
    EXPECT_EQ(q(s1, a0), 0.1);
    EXPECT_EQ(q(s1, a1), 0.25);
    EXPECT_EQ(q(s1, a2), 2.0);
}

// 0.5 + 0.8 (1 - 0.5) = 0.9: what stands in s1 does not count, a terminal state has Q = 0.
TEST(Eq1QUpdate, ATerminalStateHasNoFuture) {
    QTable q = table();
    q_update(q, {s0, a1, 1.0, s1, true}, 0.8, 0.8, AllActions{});
    EXPECT_DOUBLE_EQ(q(s0, a1), 0.9);
}

// From 0, reward 1 and alpha 0.8: 0.8, then 0.8 + 0.8 x 0.2 = 0.96, then 0.96 + 0.8 x 0.04 = 0.992.
TEST(Eq1QUpdate, ApproachesAConstantRewardGeometrically) {
    QTable q(2, 1);
    for (const double expected : {0.8, 0.96, 0.992}) {
        q_update(q, {s0, a0, 1.0, s1, true}, 0.8, 0.8, AllActions{});
        EXPECT_DOUBLE_EQ(q(s0, a0), expected);
    }
}

// A step that stays: 1 + 0.5 (0 + 0.8 x 1 - 1) = 0.9.
TEST(Eq1QUpdate, BacksUpFromItself) {
    QTable q(1, 1, 1.0);
    q_update(q, {s0, a0, 0.0, s0}, 0.5, 0.8, AllActions{});
    EXPECT_DOUBLE_EQ(q(s0, a0), 0.9);
}

// a2 is not legal in s1: 0.5 + 0.8 (0.1 + 0.8 x 0.25 - 0.5) = 0.5 - 0.8 x 0.2 = 0.34
TEST(Eq1QUpdate, TheMaximumIsOverLegalActions) {
    QTable q = table();
    LegalActionTable legal;
    legal.set(s1, ActionSet::of(3, {a0, a1}));
    q_update(q, {s0, a1, 0.1, s1}, 0.8, 0.8, legal);
    EXPECT_DOUBLE_EQ(q(s0, a1), 0.34);
}

// Costs of steps: all of s1 below 0, the maximum is -1: 0 + 1 (-1 + 1 x -1 - 0) = -2.
TEST(Eq1QUpdate, TheMaximumMayBeNegative) {
    QTable q(2, 2);
    q(s1, a0) = -3.0;
    q(s1, a1) = -1.0;
    q_update(q, {s0, a0, -1.0, s1}, 1.0, 1.0, AllActions{});
    EXPECT_EQ(q(s0, a0), -2.0);
}

TEST(Eq1QUpdate, AlphaZeroLearnsNothingAndGammaZeroLooksNoStepAhead) {
    QTable q = table();
    q_update(q, {s0, a1, 9.0, s1}, 0.0, 0.8, AllActions{});
    EXPECT_EQ(q(s0, a1), 0.5);
    q_update(q, {s0, a1, 9.0, s1}, 1.0, 0.0, AllActions{});
    EXPECT_EQ(q(s0, a1), 9.0);
}
