// SPDX-License-Identifier: MIT
// Eq. 5: Q_SSP(s,a) = e^{-H(s,a)} if s -> s' lies on the SSP and a = argmax_a' P(s'|s,a'); 0 else.
#include <sspql/paths/ssp_values.hpp>

#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include <sspql/model/transition_counts.hpp>
#include <sspql/spaces/action_set.hpp>
#include <sspql/spaces/legal_actions.hpp>

using sspql::ActionId;
using sspql::ActionSet;
using sspql::AllActions;
using sspql::CountCell;
using sspql::LegalActionTable;
using sspql::no_action;
using sspql::no_state;
using sspql::ShortestPathTree;
using sspql::SspValues;
using sspql::StateId;
using sspql::TransitionCounts;

namespace {

constexpr ActionId a0{0}, a1{1}, a2{2};
constexpr StateId s0{0}, s1{1}, s2{2}, s3{3};
constexpr double infinity = std::numeric_limits<double>::infinity();

void record(TransitionCounts<CountCell>& counts, int times, StateId s, ActionId a, StateId next) {
    for (int i = 0; i < times; ++i) counts.record(s, a, next);
}

// The tree is given: 0 -> 1 -> 3 (goal); 2 reaches nothing.
//
//   from 0:  a0 to 1 once, to 2 three times      P(1|0,a0) = 1/4
//            a1 to 1 three times, to 0 once      P(1|0,a1) = 3/4
//            a2 to 2 always
//   from 1:  a0 to 3 once, to 1 once             P(3|1,a0) = 1/2
//            a1 to 3 twice, to 0 twice           P(3|1,a1) = 1/2: a tie
//            a2 to 0 always
//   from 2:  a0 to 2
TransitionCounts<CountCell> model() {
    TransitionCounts<CountCell> counts(4, 3);
    record(counts, 1, s0, a0, s1);
    record(counts, 3, s0, a0, s2);
    record(counts, 3, s0, a1, s1);
    record(counts, 1, s0, a1, s0);
    record(counts, 2, s0, a2, s2);
    record(counts, 2, s1, a1, s3);
    record(counts, 2, s1, a1, s0);
    record(counts, 1, s1, a0, s3);
    record(counts, 1, s1, a0, s1);
    record(counts, 1, s1, a2, s0);
    record(counts, 1, s2, a0, s2);
    return counts;
}

ShortestPathTree tree() { return {{2.0, 1.0, infinity, 0.0}, {s1, s3, no_state, no_state}}; }

SspValues values(const LegalActionTable& legal = {}) {
    SspValues result;
    result.assign(model(), tree(), legal);
    return result;
}

}  // namespace

// H(0,a1) = -(3/4 ln 3/4 + 1/4 ln 1/4) = 0.5623, and e^{-H} = (3/4)^{3/4} (1/4)^{1/4} = 0.569877
TEST(Eq5SspValue, IsExpOfMinusEntropyOnTreeEdges) {
    EXPECT_NEAR(values()(s0, a1), 0.569877, 1e-6);
    EXPECT_DOUBLE_EQ(values()(s0, a1), std::pow(0.75, 0.75) * std::pow(0.25, 0.25));
}

TEST(Eq5SspValue, IsZeroForOtherActionsEvenIfTheyCanLeadThere) {
    EXPECT_EQ(values().action(s0), a1);
    EXPECT_EQ(values()(s0, a0), 0.0);
    EXPECT_EQ(values()(s0, a2), 0.0);
}

// a0 and a1 both get from 1 to 3 half of the time, and both have H = ln 2: e^{-ln 2} = 1/2. a1 was recorded first.
TEST(Eq5SspValue, TakesTheLeastActionOnTies) {
    EXPECT_EQ(values().action(s1), a0);
    EXPECT_DOUBLE_EQ(values()(s1, a0), 0.5);
    EXPECT_EQ(values()(s1, a1), 0.0);
}

TEST(Eq5SspValue, IsZeroOffThePathsAndAtTheGoal) {
    for (const StateId s : {s2, s3}) {
        EXPECT_EQ(values().action(s), no_action);
        for (const ActionId a : {a0, a1, a2}) EXPECT_EQ(values()(s, a), 0.0);
    }
}

// a1 is forbidden in 0: a0 is the best left, H(0,a0) has the same two shares, 1/4 and 3/4.
TEST(Eq5SspValue, ChoosesAmongLegalActions) {
    LegalActionTable legal;
    legal.set(s0, ActionSet::of(3, {a0, a2}));
    EXPECT_EQ(values(legal).action(s0), a0);
    EXPECT_NEAR(values(legal)(s0, a0), 0.569877, 1e-6);
    EXPECT_EQ(values(legal)(s0, a1), 0.0);
    EXPECT_EQ(values(legal).action(s1), a0) << "without a mask";
}

// Only a2 is left in 0, and it was never seen to lead to 1.
TEST(Eq5SspValue, IsZeroWhereNoLegalActionLeadsOn) {
    LegalActionTable legal;
    legal.set(s0, ActionSet::of(3, {a2}));
    EXPECT_EQ(values(legal).action(s0), no_action);
    for (const ActionId a : {a0, a1, a2}) EXPECT_EQ(values(legal)(s0, a), 0.0);
}

// The likeliest action counts, not the surest: P = 0.5 over many outcomes beats P = 0.4 over two.
TEST(Eq5SspValue, IsOfTheLikeliestActionNotOfTheOneOfLeastEntropy) {
    TransitionCounts<CountCell> counts(7, 2);
    record(counts, 4, s0, a0, s1);
    record(counts, 6, s0, a0, s2);
    record(counts, 5, s0, a1, s1);
    for (std::uint32_t next = 2; next < 7; ++next) record(counts, 1, s0, a1, StateId{next});
    SspValues result;
    result.assign(counts, {{1.0, 0.0}, {s1, no_state}}, AllActions{});
    EXPECT_EQ(result.action(s0), a1);
    // H = 0.5 ln 2 + 5 x 0.1 ln 10, e^{-H} = 2^{-1/2} 10^{-1/2} = 1 / sqrt 20
    EXPECT_DOUBLE_EQ(result(s0, a1), 1.0 / std::sqrt(20.0));
}
