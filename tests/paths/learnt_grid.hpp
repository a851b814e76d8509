// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/model/transition_counts.hpp>
#include <sspql/paths/reverse_graph.hpp>
#include <sspql/paths/shortest_paths.hpp>

namespace sspql::testing {

/// Where a move ends on a square grid, up, down, left or right.
inline std::size_t moved(std::size_t side, std::size_t s, std::size_t direction) {
    switch (direction) {
        case 0: return s >= side ? s - side : s;
        case 1: return s + side < side * side ? s + side : s;
        case 2: return s % side != 0 ? s - 1 : s;
        default: return s % side != side - 1 ? s + 1 : s;
    }
}

/// Counts of a grid in which one move in ten goes elsewhere, `tries` of every (s,a).
template <class Cell>
TransitionCounts<Cell> learnt_grid(std::size_t side, std::size_t tries = 8) {
    TransitionCounts<Cell> counts(side * side, 4);
    Random random(7);
    for (std::size_t s = 0; s < side * side; ++s) {
        for (std::size_t i = 0; i < 4 * tries; ++i) {
            const std::size_t direction = random.chance(0.1) ? random.below(4) : i % 4;
            counts.record(state_id(s), action_id(i % 4), state_id(moved(side, s, direction)));
        }
    }
    return counts;
}

/// An episode on such a grid: from anywhere along the tree, exploring and slipping one step in ten each. Where counts
/// can fade, some do.
template <class Cell>
void walk(TransitionCounts<Cell>& counts, std::size_t side, const ShortestPathTree& tree,
          const std::vector<Goal>& goals, Random& random) {
    std::size_t s = random.below(side * side);
    for (int steps = 0; steps < 2000; ++steps) {
        for (const Goal& goal : goals) {
            if (index(goal.state) == s) return;
        }
        std::size_t action = random.below(4);
        if (!random.chance(0.1) && tree.reaches_goal(state_id(s))) {
            while (moved(side, s, action) != index(tree.next[s])) action = (action + 1) % 4;
        }
        const std::size_t next = moved(side, s, random.chance(0.1) ? random.below(4) : action);
        counts.record(state_id(s), action_id(action), state_id(next));
        if constexpr (!std::is_integral_v<typename Cell::Number>) {
            if (random.chance(0.05)) counts.fade(state_id(s), action_id(action), 0.3, 0.5);
        }
        s = next;
    }
}

/// That the tree is the one a search from scratch finds, bit for bit.
template <class Cell>
void expect_solved(const ShortestPathTree& tree, const TransitionCounts<Cell>& counts, const std::vector<Goal>& goals) {
    ReverseGraph graph;
    graph.assign(counts);
    const ShortestPathTree fresh = shortest_paths_to(graph, goals);
    EXPECT_EQ(tree.distance, fresh.distance);
    EXPECT_EQ(tree.next, fresh.next);
}

}  // namespace sspql::testing
