// SPDX-License-Identifier: MIT
// Eq. 3: P(s'|s) = sum_a P(s'|s,a). No probability: it reaches |A|.
#include <sspql/model/probability.hpp>

#include <gtest/gtest.h>

#include <sspql/model/transition_counts.hpp>

using sspql::ActionId;
using sspql::BestAction;
using sspql::CountCell;
using sspql::state_id;
using sspql::StateId;
using sspql::SumOverActions;
using sspql::TransitionCounts;

namespace {

constexpr StateId s0{0}, s1{1}, s2{2}, s3{3};

template <class Probability>
double p(const Probability& probability, const TransitionCounts<CountCell>& counts, StateId s, StateId next) {
    double found = -1.0;
    counts.for_each_successor(s, [&](const auto& successor) {
        if (successor.state() == next) found = probability(counts, s, successor);
    });
    return found;
}

//          s1      s2      s3
//   a0     1/1
//   a1     3/4     1/4
//   a2     1/2             1/2
//   sum    2.25    0.25    0.5
TransitionCounts<CountCell> model(std::size_t actions) {
    TransitionCounts<CountCell> counts(4, actions);
    counts.record(s0, ActionId{0}, s1);
    for (int i = 0; i < 3; ++i) counts.record(s0, ActionId{1}, s1);
    counts.record(s0, ActionId{1}, s2);
    counts.record(s0, ActionId{2}, s1);
    counts.record(s0, ActionId{2}, s3);
    return counts;
}

}  // namespace

TEST(Eq3StateProbability, SumsOverActions) {
    const auto counts = model(3);
    EXPECT_DOUBLE_EQ(p(SumOverActions{}, counts, s0, s1), 2.25);
    EXPECT_DOUBLE_EQ(p(SumOverActions{}, counts, s0, s2), 0.25);
    EXPECT_DOUBLE_EQ(p(SumOverActions{}, counts, s0, s3), 0.5);
}

TEST(Eq3StateProbability, AnUntriedActionAddsNothing) {
    const auto counts = model(12);
    EXPECT_DOUBLE_EQ(p(SumOverActions{}, counts, s0, s1), 2.25);
}

// Five actions that all always lead to s1: 5.
TEST(Eq3StateProbability, ReachesTheNumberOfActions) {
    TransitionCounts<CountCell> counts(2, 5);
    for (std::size_t a = 0; a < 5; ++a) {
        for (int i = 0; i < 3; ++i) counts.record(s0, sspql::action_id(a), s1);
    }
    EXPECT_EQ(p(SumOverActions{}, counts, s0, s1), 5.0);
    EXPECT_EQ(p(BestAction{}, counts, s0, s1), 1.0);
}

// Over all successors the sums add up to the number of actions tried: 2.25 + 0.25 + 0.5 = 3.
TEST(Eq3StateProbability, AddsUpToTheNumberOfActionsTried) {
    const auto counts = model(8);
    double sum = 0.0;
    counts.for_each_successor(s0, [&](const auto& successor) { sum += SumOverActions{}(counts, s0, successor); });
    EXPECT_DOUBLE_EQ(sum, 3.0);
}

TEST(Eq3StateProbability, BestActionIsAProbability) {
    const auto counts = model(3);
    EXPECT_EQ(p(BestAction{}, counts, s0, s1), 1.0);
    EXPECT_EQ(p(BestAction{}, counts, s0, s2), 0.25);
    EXPECT_EQ(p(BestAction{}, counts, s0, s3), 0.5);
}
