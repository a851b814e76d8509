// SPDX-License-Identifier: MIT
#include <sspql/paths/shortest_paths.hpp>

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/paths/dary_heap.hpp>
#include <sspql/paths/fibonacci_heap.hpp>
#include <sspql/paths/reverse_graph.hpp>

#include "paths/random_graph.hpp"

using sspql::CostEdge;
using sspql::no_state;
using sspql::ReverseGraph;
using sspql::shortest_paths_to;
using sspql::ShortestPathTree;
using sspql::state_id;
using sspql::StateId;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr StateId s0{0}, s1{1}, s2{2}, s3{3}, s4{4};
using States = std::vector<StateId>;
using Distances = std::vector<double>;

}  // namespace

//      1      1
//  0 ---> 1 ---> 3    4: no way out
//  |      2      ^
//  '----> 2 -----'    0 -> 1 -> 3 costs 2, 0 -> 2 -> 3 costs 2.5
//             0.5
TEST(ShortestPathsTo, FollowsTheCheaperWay) {
    const auto graph =
        ReverseGraph::from_edges(5, {{s0, s1, 1.0}, {s1, s3, 1.0}, {s0, s2, 2.0}, {s2, s3, 0.5}, {s3, s4, 1.0}});
    const ShortestPathTree tree = shortest_paths_to(graph, {{s3}});
    EXPECT_EQ(tree.distance, (Distances{2.0, 1.0, 0.5, 0.0, infinity}));
    EXPECT_EQ(tree.next, (States{s1, s3, s3, no_state, no_state}));
    EXPECT_EQ(tree.path(s0), (States{s0, s1, s3}));
    EXPECT_EQ(tree.path(s3), (States{s3}));
    EXPECT_EQ(tree.path(s4), States{});
    EXPECT_TRUE(tree.reaches_goal(s2));
    EXPECT_FALSE(tree.reaches_goal(s4));
    EXPECT_FALSE(tree.reaches_goal(state_id(99))) << "states added since have no path";
    EXPECT_EQ(tree.path(state_id(99)), States{});
}

// 0 -> {1, 2} -> 3, all 1: both ways cost 2. Whichever edge comes first, the least state wins.
TEST(ShortestPathsTo, TakesTheLeastStateOnTies) {
    const std::vector<CostEdge> edges{{s0, s1, 1.0}, {s0, s2, 1.0}, {s1, s3, 1.0}, {s2, s3, 1.0}};
    const std::vector<CostEdge> reversed(edges.rbegin(), edges.rend());
    EXPECT_EQ(shortest_paths_to(ReverseGraph::from_edges(4, edges), {{s3}}).next[0], s1);
    EXPECT_EQ(shortest_paths_to(ReverseGraph::from_edges(4, reversed), {{s3}}).next[0], s1);
}

// 3 -> 0 directly costs 2 (0 is the goal), 3 -> 2 -> 0 costs 1 + 1: next is 0. From 3 -> 1 (1.5 + 0.5), 0 still.
TEST(ShortestPathsTo, TiesBetweenPathsOfDifferentLengthToo) {
    const auto graph =
        ReverseGraph::from_edges(4, {{s3, s2, 1.0}, {s3, s1, 1.5}, {s3, s0, 2.0}, {s2, s0, 1.0}, {s1, s0, 0.5}});
    const ShortestPathTree tree = shortest_paths_to(graph, {{s0}});
    EXPECT_EQ(tree.distance[3], 2.0);
    EXPECT_EQ(tree.next[3], s0);
}

TEST(ShortestPathsTo, OfParallelEdgesTheCheapestCounts) {
    const auto graph = ReverseGraph::from_edges(2, {{s0, s1, 3.0}, {s0, s1, 1.0}, {s0, s1, 2.0}, {s0, s0, 0.1}});
    EXPECT_EQ(shortest_paths_to(graph, {{s1}}).distance, (Distances{1.0, 0.0}));
}

TEST(ShortestPathsTo, AnEmptyGraphHasAnEmptyTree) {
    EXPECT_EQ(shortest_paths_to(ReverseGraph(), {}).size(), 0u);
    const ShortestPathTree lonely = shortest_paths_to(ReverseGraph::from_edges(3, {}), {{s1}});
    EXPECT_EQ(lonely.distance, (Distances{infinity, 0.0, infinity}));
    EXPECT_EQ(lonely.next, (States{no_state, no_state, no_state}));
}

// 1e20 + 1 == 1e20: 1 and 2 lie in a cycle of absorbed costs behind 0.
TEST(ShortestPathsTo, StaysFreeOfCyclesWhereCostsAreAbsorbed) {
    const auto graph = ReverseGraph::from_edges(
        4, {{s1, s0, 1.0}, {s2, s1, 1.0}, {s1, s2, 1.0}, {s3, s2, 1.0}, {s2, s3, 1.0}, {s0, s1, 1.0}});
    const std::vector<sspql::Goal> goals{{s0, 1e20}};
    const ShortestPathTree tree = shortest_paths_to(graph, goals);
    EXPECT_EQ(tree.distance, (Distances{1e20, 1e20, 1e20, 1e20}));
    sspql_test::expect_shortest_path_tree(graph, goals, tree);
    EXPECT_EQ(tree.path(s3), (States{s3, s2, s1, s0}));
}

// 1 and 2 lead to each other for nothing: raised to 1e-30 of the greatest cost, no cycle is free.
TEST(ShortestPathsTo, FreeCyclesCannotTrapAPath) {
    const auto graph = ReverseGraph::from_edges(4, {{s1, s2, 0.0}, {s2, s1, 0.0}, {s2, s0, 5.0}, {s3, s1, 0.0}});
    const ShortestPathTree tree = shortest_paths_to(graph, {{s0}});
    EXPECT_EQ(tree.path(s3), (States{s3, s1, s2, s0}));
    const auto all_free = ReverseGraph::from_edges(3, {{s1, s2, 0.0}, {s2, s1, 0.0}, {s1, s0, 0.0}});
    EXPECT_EQ(shortest_paths_to(all_free, {{s0}}).path(s2), (States{s2, s1, s0}));
}

TEST(ShortestPathsTo, CountsItsWork) {
    const auto graph =
        ReverseGraph::from_edges(5, {{s0, s1, 1.0}, {s1, s3, 1.0}, {s0, s2, 2.0}, {s2, s3, 0.5}, {s3, s4, 1.0}});
    sspql::FibonacciHeap<sspql::OperationCounters> queue;
    ShortestPathTree tree;
    const sspql::SearchWork work = shortest_paths_to(graph, {{s3}}, queue, tree);
    EXPECT_EQ(work.states, 4u) << "the goal and 0, 1, 2";
    EXPECT_EQ(work.edges, 4u) << "the edge into 4 is not looked at";
    EXPECT_EQ(queue.counters().pops, 4u);
    EXPECT_EQ(queue.counters().pushes, 4u);
}

TEST(ShortestPathsTo, OverwritesATreeOfAnotherSize) {
    sspql::DaryHeap<4> queue;
    ShortestPathTree tree;
    shortest_paths_to(ReverseGraph::from_edges(4, {{s0, s3, 1.0}}), {{s3}}, queue, tree);
    shortest_paths_to(ReverseGraph::from_edges(2, {{s1, s0, 1.0}}), {{s0}}, queue, tree);
    EXPECT_EQ(tree.distance, (Distances{0.0, 1.0}));
    EXPECT_EQ(tree.next, (States{no_state, s0}));
}

TEST(ShortestPathsTo, WalksAChainOfAMillionStates) {
    constexpr std::size_t n = 1000000;
    std::vector<CostEdge> edges;
    edges.reserve(2 * n);
    for (std::size_t s = 0; s + 1 < n; ++s) {
        edges.push_back({state_id(s), state_id(s + 1), 1.0});
        edges.push_back({state_id(s + 1), state_id(s), 1.0});
    }
    const auto graph = ReverseGraph::from_edges(n, edges);
    const ShortestPathTree tree = shortest_paths_to(graph, {{state_id(n - 1)}});
    bool right = true;
    for (std::size_t s = 0; s + 1 < n; ++s) {
        right = right && tree.distance[s] == static_cast<double>(n - 1 - s) && tree.next[s] == state_id(s + 1);
    }
    EXPECT_TRUE(right);
    EXPECT_EQ(tree.path(s0).size(), n);
}
