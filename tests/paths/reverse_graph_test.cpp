// SPDX-License-Identifier: MIT
#include <sspql/paths/reverse_graph.hpp>

#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/paths/cost_publisher.hpp>

using sspql::CostEdge;
using sspql::CostPublisher;
using sspql::CountCell;
using sspql::ReverseGraph;
using sspql::state_id;
using sspql::StateId;
using sspql::TransitionCounts;

namespace {

constexpr StateId s0{0}, s1{1}, s2{2};
constexpr double least_normal = std::numeric_limits<double>::min();

std::multimap<std::pair<std::size_t, std::size_t>, double> edges_of(const ReverseGraph& graph) {
    std::multimap<std::pair<std::size_t, std::size_t>, double> edges;
    for (std::size_t v = 0; v < graph.size(); ++v) {
        graph.for_each_predecessor(state_id(v), [&](StateId u, double cost) { edges.insert({{index(u), v}, cost}); });
    }
    return edges;
}

}  // namespace

TEST(ReverseGraph, IsEmptyAtFirst) {
    const ReverseGraph graph;
    EXPECT_EQ(graph.size(), 0u);
    EXPECT_EQ(graph.edges(), 0u);
    EXPECT_EQ(graph.least_cost(), 0.0);
    EXPECT_EQ(graph.greatest_cost(), 0.0);
}

TEST(ReverseGraph, FromEdgesKeepsParallelEdgesAndSelfLoops) {
    const auto graph = ReverseGraph::from_edges(4, {{s2, s0, 3.0}, {s1, s0, 2.0}, {s2, s0, 1.0}, {s1, s1, 5.0}});
    EXPECT_EQ(graph.size(), 4u);
    EXPECT_EQ(graph.edges(), 4u);
    const std::multimap<std::pair<std::size_t, std::size_t>, double> expected{
        {{1, 0}, 2.0}, {{1, 1}, 5.0}, {{2, 0}, 3.0}, {{2, 0}, 1.0}};
    EXPECT_EQ(edges_of(graph), expected);
    EXPECT_EQ(graph.least_cost(), 1.0);
    EXPECT_EQ(graph.greatest_cost(), 5.0);
    EXPECT_EQ(graph.end(s0) - graph.begin(s0), 3u);
    EXPECT_EQ(graph.predecessor(graph.begin(s1)), s1);
    EXPECT_EQ(graph.cost(graph.begin(s1)), 5.0);
    EXPECT_EQ(graph.begin(s2), graph.end(s2));
}

TEST(ReverseGraph, FromEdgesRefusesOtherStatesAndBadCosts) {
    EXPECT_THROW(static_cast<void>(ReverseGraph::from_edges(2, {{s2, s0, 1.0}})), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(ReverseGraph::from_edges(2, {{s0, s2, 1.0}})), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(ReverseGraph::from_edges(0, {{s0, s0, 1.0}})), std::invalid_argument);
    for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        EXPECT_THROW(static_cast<void>(ReverseGraph::from_edges(2, {{s0, s1, bad}})), std::invalid_argument);
    }
    try {
        static_cast<void>(ReverseGraph::from_edges(2, {{s0, StateId{9}, 1.0}}));
        FAIL() << "not refused";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "states of an edge must be below 2, got 9");
    }
}

TEST(ReverseGraph, RaisesCostsToAMultipleOfTheGreatest) {
    constexpr double floor = 8.0 * ReverseGraph::least_ratio;
    const auto graph = ReverseGraph::from_edges(3, {{s0, s1, 0.0}, {s1, s2, 2e-29}, {s2, s0, 8.0}, {s0, s2, 1e-30}});
    EXPECT_EQ(graph.greatest_cost(), 8.0);
    EXPECT_EQ(graph.least_cost(), floor);
    const std::multimap<std::pair<std::size_t, std::size_t>, double> expected{
        {{0, 1}, floor}, {{1, 2}, 2e-29}, {{2, 0}, 8.0}, {{0, 2}, floor}};
    EXPECT_EQ(edges_of(graph), expected);
    const auto even = ReverseGraph::from_edges(2, {{s0, s1, floor}, {s1, s0, 8.0}});
    EXPECT_EQ(even.least_cost(), floor) << "just enough";
}

TEST(ReverseGraph, CostsOfNothingBecomeTheLeastNormalNumber) {
    const auto graph = ReverseGraph::from_edges(2, {{s0, s1, 0.0}, {s1, s0, 0.0}});
    EXPECT_EQ(graph.least_cost(), least_normal);
    EXPECT_EQ(graph.greatest_cost(), least_normal);
    const auto tiny = ReverseGraph::from_edges(2, {{s0, s1, 1e-300}, {s1, s0, 0.0}});
    EXPECT_EQ(tiny.least_cost(), least_normal);
    EXPECT_EQ(tiny.greatest_cost(), 1e-300);
}

TEST(ReverseGraph, AssignTakesTheLabelsOfTheCounts) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        sspql::Random random(seed);
        const std::size_t n = 1 + random.below(50);
        TransitionCounts<CountCell> counts(n, 3);
        for (int i = 0; i < 300; ++i) {
            const StateId s = state_id(random.below(n));
            const sspql::ActionId a = sspql::action_id(random.below(3));
            counts.record(s, a, state_id(random.below(n)));
        }
        CostPublisher<>().publish(counts);
        ReverseGraph graph;
        graph.assign(counts);
        graph.assign(counts);
        std::multimap<std::pair<std::size_t, std::size_t>, double> expected;
        for (std::size_t s = 0; s < n; ++s) {
            counts.for_each_successor(state_id(s), [&](const auto& successor) {
                expected.insert({{s, index(successor.state())}, successor.label()});
            });
        }
        EXPECT_EQ(graph.size(), n);
        EXPECT_EQ(graph.edges(), counts.pairs());
        EXPECT_EQ(edges_of(graph), expected);
    }
}

TEST(ReverseGraph, AssignOfASmallerModelShrinks) {
    auto graph = ReverseGraph::from_edges(5, {{s0, s1, 1.0}, {s1, s2, 2.0}});
    TransitionCounts<CountCell> counts(2, 1);
    graph.assign(counts);
    EXPECT_EQ(graph.size(), 2u);
    EXPECT_EQ(graph.edges(), 0u);
    EXPECT_EQ(graph.greatest_cost(), 0.0);
}
