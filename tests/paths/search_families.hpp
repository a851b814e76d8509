// SPDX-License-Identifier: MIT
#pragma once

// Families of graphs by size, to count operations on: what grows, and how fast, shows only over several sizes.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/core/random.hpp>
#include <sspql/paths/reverse_graph.hpp>

namespace sspql_test {

/// A graph and a goal that all its states reach.
struct SearchCase {
    sspql::ReverseGraph graph;
    sspql::StateId goal{};
};

inline SearchCase search_case(std::size_t n, std::size_t goal, const std::vector<sspql::CostEdge>& edges) {
    return {sspql::ReverseGraph::from_edges(n, edges), sspql::state_id(goal)};
}

/// A square grid of about n states, goal in its middle; costs e^{-2P} for P in [0.8, 1.2), as learnt ones are, or
/// all 1.
inline SearchCase grid_case(std::size_t n, bool equal_costs, std::uint64_t seed = 1) {
    sspql::Random random(seed);
    const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)));
    std::vector<sspql::CostEdge> edges;
    edges.reserve(4 * side * side);
    const auto connect = [&](std::size_t a, std::size_t b) {
        edges.push_back(
            {sspql::state_id(a), sspql::state_id(b), equal_costs ? 1.0 : std::exp(-2.0 * random.uniform(0.8, 1.2))});
    };
    for (std::size_t s = 0; s < side * side; ++s) {
        if (s % side != 0) connect(s, s - 1);
        if (s % side + 1 != side) connect(s, s + 1);
        if (s >= side) connect(s, s - side);
        if (s + side < side * side) connect(s, s + side);
    }
    return search_case(side * side, (side / 2) * side + side / 2, edges);
}

/// A cycle, so that all states reach the goal, and `degree` - 1 random edges a state; costs log-uniform over `decades`.
inline SearchCase random_case(std::size_t n, std::size_t degree, double decades, std::uint64_t seed = 1) {
    sspql::Random random(seed);
    std::vector<sspql::CostEdge> edges;
    edges.reserve(degree * n);
    for (std::size_t s = 0; s < n; ++s) {
        for (std::size_t i = 0; i < degree; ++i) {
            const std::size_t to = i == 0 ? (s + 1) % n : random.below(n);
            edges.push_back({sspql::state_id(s), sspql::state_id(to), std::pow(10.0, random.uniform(0.0, decades))});
        }
    }
    return search_case(n, n / 2, edges);
}

/// All states lead to the goal, which leads back to all: the queue holds n - 1 vertices after one pop.
inline SearchCase star_case(std::size_t n, std::uint64_t seed = 1) {
    sspql::Random random(seed);
    std::vector<sspql::CostEdge> edges;
    edges.reserve(2 * n);
    for (std::size_t s = 1; s < n; ++s) {
        edges.push_back({sspql::state_id(s), sspql::state_id(0), random.uniform(1.0, 2.0)});
        edges.push_back({sspql::state_id(0), sspql::state_id(s), random.uniform(1.0, 2.0)});
    }
    return search_case(n, 0, edges);
}

/// Where decreases pay: a path to the goal, and from each of its states `degree` edges to it from random states still
/// to come. Each of these lowers a key below all others queued but the path's next, so that a binary heap moves it from
/// the bottom to the top and a Fibonacci heap cuts it in O(1).
inline SearchCase adversarial_case(std::size_t n, std::size_t degree, std::uint64_t seed = 1) {
    sspql::Random random(seed);
    std::vector<sspql::CostEdge> edges;
    edges.reserve((degree + 1) * n);
    const auto size = static_cast<double>(n);
    const double step = size / static_cast<double>(degree * n + 1);
    double key = 2.0 * size;
    for (std::size_t v = 0; v + 1 < n; ++v) {
        edges.push_back({sspql::state_id(v + 1), sspql::state_id(v), 1.0});
        for (std::size_t i = 0; i < degree && v + 2 < n; ++i) {
            const std::size_t u = v + 2 + random.below(n - v - 2);
            edges.push_back({sspql::state_id(u), sspql::state_id(v), key - static_cast<double>(v)});
            key -= step;
        }
    }
    return search_case(n, 0, edges);
}

/// The same graph with its states numbered at random, so that neighbours lie far apart in memory.
inline SearchCase shuffled(const SearchCase& c, std::uint64_t seed = 1) {
    sspql::Random random(seed);
    const std::size_t n = c.graph.size();
    std::vector<std::size_t> number(n);
    for (std::size_t i = 0; i < n; ++i) number[i] = i;
    for (std::size_t i = n; i > 1; --i) std::swap(number[i - 1], number[random.below(i)]);
    std::vector<sspql::CostEdge> edges;
    edges.reserve(c.graph.edges());
    for (std::size_t v = 0; v < n; ++v) {
        c.graph.for_each_predecessor(sspql::state_id(v), [&](sspql::StateId u, double cost) {
            edges.push_back({sspql::state_id(number[index(u)]), sspql::state_id(number[v]), cost});
        });
    }
    return search_case(n, number[index(c.goal)], edges);
}

}  // namespace sspql_test
