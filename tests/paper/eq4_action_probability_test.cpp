// SPDX-License-Identifier: MIT
// Eq. 4: P(s'|s,a) = N(s,a,s') / N(s,a); mu, about 0, where N(s,a) = 0.
#include <sspql/model/probability.hpp>

#include <limits>

#include <gtest/gtest.h>

#include <sspql/model/transition_counts.hpp>
#include <sspql/paths/cost_publisher.hpp>
#include <sspql/paths/reverse_graph.hpp>
#include <sspql/paths/shortest_paths.hpp>

using sspql::ActionId;
using sspql::CountCell;
using sspql::FadingCell;
using sspql::probability;
using sspql::StateId;
using sspql::TransitionCounts;

namespace {

constexpr ActionId a0{0}, a1{1};
constexpr StateId s0{0}, s1{1}, s2{2};

}  // namespace

// Five tries of a0: s1, s1, s2, s1, s1.
TEST(Eq4ActionProbability, IsTheShareOfObservations) {
    TransitionCounts<CountCell> counts(3, 2);
    for (const StateId next : {s1, s1, s2, s1, s1}) counts.record(s0, a0, next);
    EXPECT_DOUBLE_EQ(probability(counts, s0, a0, s1), 0.8);
    EXPECT_DOUBLE_EQ(probability(counts, s0, a0, s2), 0.2);
    EXPECT_EQ(probability(counts, s0, a0, s0), 0.0);
}

// Deviation: 0 instead of mu.
TEST(Eq4ActionProbability, IsZeroForAnUntriedAction) {
    TransitionCounts<CountCell> counts(3, 2);
    counts.record(s0, a0, s1);
    EXPECT_EQ(probability(counts, s0, a1, s1), 0.0);
    EXPECT_EQ(probability(counts, s1, a0, s0), 0.0);
}

// Only observed edges exist: nothing leads from s2 to s1, so s2 reaches no goal.
TEST(Eq4ActionProbability, UnobservedPairsAreNoEdges) {
    TransitionCounts<CountCell> counts(3, 2);
    counts.record(s0, a0, s1);
    EXPECT_EQ(counts.pairs(), 1u);
    sspql::CostPublisher<>().publish(counts);
    sspql::ReverseGraph graph;
    graph.assign(counts);
    EXPECT_EQ(shortest_paths_to(graph, {{s1}}).distance[2], std::numeric_limits<double>::infinity());
}

// Fading keeps the quotient: (4, 1) and (2, 0.5) are the same model; with new outcomes the old ones count less:
// (2, 0.5 + 1) of 3.5.
TEST(Eq4ActionProbability, OfFadingCountsWeighsRecentOutcomesMore) {
    TransitionCounts<FadingCell> counts(3, 1);
    for (const StateId next : {s1, s1, s2, s1, s1}) counts.record(s0, a0, next);
    counts.fade(s0, a0, 0.5, 0.1);
    EXPECT_DOUBLE_EQ(probability(counts, s0, a0, s1), 0.8);
    counts.record(s0, a0, s2);
    EXPECT_DOUBLE_EQ(probability(counts, s0, a0, s1), 2.0 / 3.5);
    EXPECT_DOUBLE_EQ(probability(counts, s0, a0, s2), 1.5 / 3.5);
}
