// SPDX-License-Identifier: MIT
// Several goals, their offsets, and goals that are refused.
#include <sspql/paths/shortest_paths.hpp>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/paths/fibonacci_heap.hpp>
#include <sspql/paths/reverse_graph.hpp>

using sspql::Goal;
using sspql::no_state;
using sspql::ReverseGraph;
using sspql::shortest_paths_to;
using sspql::ShortestPathTree;
using sspql::StateId;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr StateId s0{0}, s1{1}, s2{2}, s3{3}, s4{4};
using States = std::vector<StateId>;
using Distances = std::vector<double>;

/// 0 <-> 1 <-> 2 <-> 3 <-> 4, all 1.
ReverseGraph line() {
    return ReverseGraph::from_edges(5, {{s0, s1, 1.0},
                                        {s1, s2, 1.0},
                                        {s2, s3, 1.0},
                                        {s3, s4, 1.0},
                                        {s1, s0, 1.0},
                                        {s2, s1, 1.0},
                                        {s3, s2, 1.0},
                                        {s4, s3, 1.0}});
}

}  // namespace

TEST(Goals, TheNearestCounts) {
    const ShortestPathTree tree = shortest_paths_to(line(), {{s0}, {s4}});
    EXPECT_EQ(tree.distance, (Distances{0, 1, 2, 1, 0}));
    EXPECT_EQ(tree.next, (States{no_state, s0, s1, s4, no_state})) << "2 lies in the middle: the least state";
}

// 4 is worth one step less: 2 is now 2 from 0 and 3 from 4; 3 has 3 and 2.
TEST(Goals, AnOffsetIsStillToPay) {
    const ShortestPathTree tree = shortest_paths_to(line(), {{s0, 0.0}, {s4, 1.0}});
    EXPECT_EQ(tree.distance, (Distances{0, 1, 2, 2, 1}));
    EXPECT_EQ(tree.next, (States{no_state, s0, s1, s4, no_state}));
}

// Offset 10 at 4, but 0 is 4 steps away: the path leads on from 4.
TEST(Goals, ALesserGoalIsPassedThroughOnTheWayToABetterOne) {
    const ShortestPathTree tree = shortest_paths_to(line(), {{s4, 10.0}, {s0, 0.0}});
    EXPECT_EQ(tree.distance, (Distances{0, 1, 2, 3, 4}));
    EXPECT_EQ(tree.next, (States{no_state, s0, s1, s2, s3}));
}

TEST(Goals, AnEquallyGoodGoalEndsThePath) {
    const ShortestPathTree tree = shortest_paths_to(line(), {{s0, 0.0}, {s4, 4.0}});
    EXPECT_EQ(tree.distance[4], 4.0);
    EXPECT_EQ(tree.next[4], no_state);
    EXPECT_EQ(tree.next[3], s2);
}

TEST(Goals, TwiceTheSameTheSmallerOffsetCounts) {
    const std::vector<std::vector<Goal>> orders{{{s0, 3.0}, {s0, 1.0}}, {{s0, 1.0}, {s0, 3.0}}, {{s0, 1.0}, {s0, 1.0}}};
    for (const std::vector<Goal>& goals : orders) {
        const ShortestPathTree tree = shortest_paths_to(line(), goals);
        EXPECT_EQ(tree.distance, (Distances{1, 2, 3, 4, 5}));
        EXPECT_EQ(tree.next[0], no_state);
    }
}

TEST(Goals, NoneReachesNothing) {
    const ShortestPathTree tree = shortest_paths_to(line(), {});
    EXPECT_EQ(tree.distance, Distances(5, infinity));
    EXPECT_EQ(tree.next, States(5, no_state));
}

TEST(Goals, AllStatesMayBeGoals) {
    const ShortestPathTree tree = shortest_paths_to(line(), {{s4}, {s3}, {s2}, {s1}, {s0}});
    EXPECT_EQ(tree.distance, Distances(5, 0.0));
    EXPECT_EQ(tree.next, States(5, no_state));
}

TEST(Goals, OutsideOrWithABadOffsetAreRefusedAndTheTreeKept) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const ReverseGraph graph = line();
    sspql::FibonacciHeap<> queue;
    ShortestPathTree tree;
    shortest_paths_to(graph, {{s0}}, queue, tree);
    const ShortestPathTree before = tree;
    const std::vector<Goal> bad{{StateId{5}, 0.0}, {no_state, 0.0}, {s1, nan}, {s1, -0.5}, {s1, infinity}};
    for (const Goal& goal : bad) {
        SCOPED_TRACE(std::to_string(index(goal.state)) + " " + std::to_string(goal.offset));
        EXPECT_THROW(shortest_paths_to(graph, {{s2}, goal}, queue, tree), std::invalid_argument);
        EXPECT_EQ(tree.distance, before.distance);
        EXPECT_EQ(tree.next, before.next);
    }
    shortest_paths_to(graph, {{s0}}, queue, tree);
    EXPECT_EQ(tree.distance, before.distance) << "the queue still works";
}

TEST(Goals, TheMessageNamesTheGoal) {
    try {
        static_cast<void>(shortest_paths_to(line(), {{StateId{7}}}));
        FAIL() << "not refused";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "goal must be below the number of states 5, got 7");
    }
    try {
        static_cast<void>(shortest_paths_to(line(), {{s3, -1.0}}));
        FAIL() << "not refused";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "offset of goal 3 must be finite and >= 0, got -1");
    }
}
