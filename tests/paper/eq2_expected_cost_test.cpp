// SPDX-License-Identifier: MIT
// Eq. 2: EC(s,s') = weight(s,s') e^{-lambda P(s'|s)}
#include <sspql/paths/cost.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include <sspql/model/transition_counts.hpp>
#include <sspql/paths/cost_publisher.hpp>
#include <sspql/paths/reverse_graph.hpp>
#include <sspql/paths/shortest_paths.hpp>

using sspql::ActionId;
using sspql::CostPublisher;
using sspql::CountCell;
using sspql::RiskWeighted;
using sspql::StateId;
using sspql::TransitionCounts;

namespace {

constexpr ActionId a0{0}, a1{1};
constexpr StateId s0{0}, s1{1}, s2{2}, s3{3}, s4{4}, s5{5}, s6{6};

void record(TransitionCounts<CountCell>& counts, int times, StateId s, ActionId a, StateId next, double weight = 1.0) {
    for (int i = 0; i < times; ++i) counts.record(s, a, next, false, 0.0, weight);
}

double published(const TransitionCounts<CountCell>& counts, StateId s, StateId next) {
    double cost = -1.0;
    counts.for_each_successor(s, [&](const auto& successor) {
        if (successor.state() == next) cost = successor.label();
    });
    return cost;
}

}  // namespace

// s0 -a0-> s1 three times of four, s2 once. lambda = 2: e^{-2 x 3/4} = e^{-1.5} = 0.2231..., e^{-2 x 1/4} = e^{-0.5}.
TEST(Eq2ExpectedCost, IsWeightTimesExpOfMinusLambdaP) {
    TransitionCounts<CountCell> counts(3, 1);
    record(counts, 3, s0, a0, s1);
    record(counts, 1, s0, a0, s2);
    CostPublisher<>().publish(counts);
    EXPECT_DOUBLE_EQ(published(counts, s0, s1), 0.22313016014842982);
    EXPECT_DOUBLE_EQ(published(counts, s0, s2), 0.6065306597126334);
}

// Weights 2, 4 and 6 were observed towards s1: their mean is 4, and 4 e^{-1.5} = 0.8925...
TEST(Eq2ExpectedCost, TakesTheMeanObservedWeight) {
    TransitionCounts<CountCell> counts(3, 1);
    for (const double weight : {2.0, 4.0, 6.0}) record(counts, 1, s0, a0, s1, weight);
    record(counts, 1, s0, a0, s2);
    CostPublisher<>().publish(counts);
    EXPECT_DOUBLE_EQ(published(counts, s0, s1), 0.8925206405937193);
    EXPECT_DOUBLE_EQ(published(counts, s0, s2), 0.6065306597126334);
}

// Algorithm 1 line 7, taken literally, would cost H = 0 here. By eq. 2 a certain edge costs e^{-2} = 0.1353...
TEST(Eq2ExpectedCost, OfACertainEdgeIsNotZero) {
    TransitionCounts<CountCell> counts(2, 1);
    record(counts, 5, s0, a0, s1);
    CostPublisher<>().publish(counts);
    EXPECT_DOUBLE_EQ(published(counts, s0, s1), 0.1353352832366127);
}

TEST(Eq2ExpectedCost, FallsWithPAndWithLambdaAndRisesWithTheWeight) {
    EXPECT_GT(RiskWeighted(2.0)(1.0, 0.2), RiskWeighted(2.0)(1.0, 0.3));
    EXPECT_GT(RiskWeighted(2.0)(1.0, 0.2), RiskWeighted(3.0)(1.0, 0.2));
    EXPECT_LT(RiskWeighted(2.0)(1.0, 0.2), RiskWeighted(2.0)(1.1, 0.2));
    EXPECT_EQ(RiskWeighted(0.0)(3.0, 0.2), 3.0) << "lambda = 0: distances only";
}

// Fig. 2: a short and risky way, and a long and safe one.
//
//          a0 0.4      a0 0.4
//       0 --------> 1 --------> 5          2 e^{-0.8} = 0.8987 with lambda = 2, 2 with lambda = 0
//       |           '--> 6 (0.6 each, from 0 too)
//    a1 '-> 2 -> 3 -> 4 -> 5               4 e^{-2} = 0.5413 with lambda = 2, 4 with lambda = 0
TEST(Eq2ExpectedCost, PrefersTheLongSafeWayOnceRiskCounts) {
    TransitionCounts<CountCell> counts(7, 2);
    record(counts, 2, s0, a0, s1);
    record(counts, 3, s0, a0, s6);
    record(counts, 2, s1, a0, s5);
    record(counts, 3, s1, a0, s6);
    record(counts, 1, s0, a1, s2);
    record(counts, 1, s2, a0, s3);
    record(counts, 1, s3, a0, s4);
    record(counts, 1, s4, a0, s5);
    TransitionCounts<CountCell> same = counts;
    sspql::ReverseGraph graph;

    CostPublisher<>(RiskWeighted(2.0)).publish(counts);
    graph.assign(counts);
    const auto careful = shortest_paths_to(graph, {{s5}});
    EXPECT_EQ(careful.next[0], s2);
    EXPECT_NEAR(careful.distance[0], 0.5413, 1e-4);
    EXPECT_NEAR(published(counts, s0, s1) + careful.distance[1], 0.8987, 1e-4);

    CostPublisher<>(RiskWeighted(0.0)).publish(same);
    graph.assign(same);
    const auto bold = shortest_paths_to(graph, {{s5}});
    EXPECT_EQ(bold.next[0], s1);
    EXPECT_EQ(bold.distance[0], 2.0);
}
