// SPDX-License-Identifier: MIT
#pragma once

// Random graphs of many shapes, and what a shortest-path tree over one must look like.

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/core/ids.hpp>
#include <sspql/core/random.hpp>
#include <sspql/paths/reverse_graph.hpp>
#include <sspql/paths/shortest_paths.hpp>

namespace sspql_test {

enum class Shape { sparse, dense, star_in, star_out, chain, disconnected, multigraph };
inline constexpr Shape shapes[] = {Shape::sparse, Shape::dense,        Shape::star_in,   Shape::star_out,
                                   Shape::chain,  Shape::disconnected, Shape::multigraph};

enum class Costs { one, few_integers, real, six_decades, absorbing };
inline constexpr Costs cost_kinds[] = {Costs::one, Costs::few_integers, Costs::real, Costs::six_decades,
                                       Costs::absorbing};

inline double draw_cost(sspql::Random& random, Costs kind) {
    switch (kind) {
        case Costs::one: return 1.0;
        case Costs::few_integers: return static_cast<double>(1 + random.below(3));
        case Costs::real: return random.uniform(0.1, 1.0);
        case Costs::six_decades: return std::pow(10.0, random.uniform(-3.0, 3.0));
        case Costs::absorbing: return random.chance(0.5) ? 1e20 : 1.0;  // 1e20 + 1 == 1e20
    }
    return 1.0;
}

inline std::vector<sspql::CostEdge> random_edges(sspql::Random& random, std::size_t n, Shape shape, Costs costs) {
    std::vector<sspql::CostEdge> edges;
    const auto add = [&](std::size_t from, std::size_t to) {
        const double cost = draw_cost(random, costs);
        edges.push_back({sspql::state_id(from), sspql::state_id(to), cost});
    };
    const auto add_random = [&](std::size_t m, std::size_t below) {
        for (std::size_t i = 0; i < m; ++i) {
            const std::size_t from = random.below(below);
            add(from, random.below(below));
        }
    };
    switch (shape) {
        case Shape::sparse: add_random(2 * n, n); break;
        case Shape::dense: add_random(n * n / 2, n); break;
        case Shape::star_in:
            for (std::size_t s = 0; s < n; ++s) add(s, 0);
            add_random(n / 4, n);
            break;
        case Shape::star_out:
            for (std::size_t s = 0; s < n; ++s) add(0, s);
            add_random(n / 4, n);
            break;
        case Shape::chain:
            for (std::size_t s = 0; s + 1 < n; ++s) add(s, s + 1);
            for (std::size_t s = 1; s < n; ++s) add(s, s - 1);
            break;
        case Shape::disconnected: add_random(n, (n + 1) / 2); break;
        case Shape::multigraph:
            add_random(3 * n, (n + 2) / 3);
            for (std::size_t s = 0; s < n; ++s) add(s, s);
            add_random(n, n);
            break;
    }
    return edges;
}

/// Up to three goals, now and then the same one twice, with offsets or without.
inline std::vector<sspql::Goal> random_goals(sspql::Random& random, std::size_t n, Costs costs) {
    std::vector<sspql::Goal> goals;
    const std::size_t count = 1 + random.below(3);
    for (std::size_t i = 0; i < count; ++i) {
        const sspql::StateId state = sspql::state_id(random.below(n));
        const double offset = random.chance(0.5) ? 0.0 : draw_cost(random, costs);
        goals.push_back({state, offset});
    }
    return goals;
}

/// What makes `tree` a right answer, checked edge by edge: no edge is slack, next is the least of the best, goals end
/// paths unless another is nearer, and there are no cycles.
inline void expect_shortest_path_tree(const sspql::ReverseGraph& graph, const std::vector<sspql::Goal>& goals,
                                      const sspql::ShortestPathTree& tree) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::size_t n = graph.size();
    ASSERT_EQ(tree.distance.size(), n);
    ASSERT_EQ(tree.next.size(), n);
    std::vector<double> offset(n, infinity), best(n, infinity);
    for (const sspql::Goal& goal : goals) offset[index(goal.state)] = std::min(offset[index(goal.state)], goal.offset);
    best = offset;
    // The least id among those that explain the distance, first by edges that are not absorbed.
    std::vector<sspql::StateId> expected(n, sspql::no_state);
    std::vector<bool> absorbed(n, false);
    for (std::size_t v = 0; v < n; ++v) {
        graph.for_each_predecessor(sspql::state_id(v), [&](sspql::StateId u, double cost) {
            const double through = tree.distance[v] + cost;
            best[index(u)] = std::min(best[index(u)], through);
            if (through != tree.distance[index(u)] || through == infinity) return;
            if (tree.distance[v] < tree.distance[index(u)]) {
                if (expected[index(u)] == sspql::no_state) expected[index(u)] = sspql::state_id(v);
            } else {
                absorbed[index(u)] = true;
            }
        });
    }
    for (std::size_t s = 0; s < n; ++s) {
        SCOPED_TRACE("state " + std::to_string(s));
        EXPECT_EQ(tree.distance[s], best[s]);
        if (tree.distance[s] == infinity || tree.distance[s] == offset[s]) {
            EXPECT_EQ(tree.next[s], sspql::no_state);
        } else if (expected[s] != sspql::no_state) {
            EXPECT_EQ(tree.next[s], expected[s]);
        } else {
            EXPECT_TRUE(absorbed[s]);
            EXPECT_NE(tree.next[s], sspql::no_state);
        }
        std::size_t length = 0;
        for (sspql::StateId at = sspql::state_id(s); at != sspql::no_state; at = tree.next[index(at)]) {
            ASSERT_LE(++length, n) << "a cycle";
        }
    }
}

}  // namespace sspql_test
