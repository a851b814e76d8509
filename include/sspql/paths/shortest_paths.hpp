// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/paths/fibonacci_heap.hpp>
#include <sspql/paths/queue.hpp>

namespace sspql {

/// Where paths may end. `offset` (>= 0) is the cost still to pay there: of two goals the one with the smaller offset is
/// worth going further for.
struct Goal {
    StateId state{};
    double offset = 0.0;
};

/// Shortest paths from every state to its best goal, as a tree whose edges lead towards the goals.
struct ShortestPathTree {
    /// By state: cost of the path, the goal's offset included; infinite where no path is known.
    std::vector<double> distance;
    /// By state: the next state on the path; no_state at a goal where paths end, and where no path is known.
    std::vector<StateId> next;

    [[nodiscard]] std::size_t size() const noexcept { return distance.size(); }

    [[nodiscard]] bool reaches_goal(StateId s) const noexcept {
        return index(s) < size() && distance[index(s)] < std::numeric_limits<double>::infinity();
    }

    /// The states from s to its goal, both included; empty if no path is known. O(length).
    [[nodiscard]] std::vector<StateId> path(StateId s) const {
        std::vector<StateId> states;
        if (!reaches_goal(s)) return states;
        for (; s != no_state; s = next[index(s)]) states.push_back(s);
        return states;
    }
};

/// How much one search did.
struct SearchWork {
    std::size_t states = 0;  ///< settled: those with a path
    std::size_t edges = 0;   ///< looked at
};

namespace detail {

/// \throws std::invalid_argument for a goal outside the graph or an offset that is NaN, infinite or negative.
inline void require_goals(const std::vector<Goal>& goals, std::size_t states) {
    for (const Goal& goal : goals) {
        if (index(goal.state) >= states) {
            throw_invalid("goal", "be below the number of states " + std::to_string(states), index(goal.state));
        }
        require_not_negative("offset of goal " + std::to_string(index(goal.state)), goal.offset);
    }
}

}  // namespace detail

/// Single-destination shortest paths (Dijkstra; line 9 of Algorithm 1) from every state to the best of several goals,
/// searching backwards over a PredecessorGraph with costs > 0.
///
/// The tree does not depend on the queue: next(s) = argmin over s' of cost(s,s') + distance(s'), the least s' on ties;
/// only where a distance absorbs a cost entirely (d + c == d) does the order of settling decide, and the tree stays
/// free of cycles. A goal keeps next = no_state unless another goal is strictly nearer than its own offset. The same
/// goal twice: the smaller offset counts. No goals: nothing reaches one.
///
/// `tree` and `queue` are overwritten; reuse them to avoid allocation. O(m + n log n) with FibonacciHeap.
/// \throws std::invalid_argument for a goal outside the graph or an offset that is not finite and >= 0; `tree` is
/// untouched then.
template <class Graph, class Queue>
SearchWork shortest_paths_to(const Graph& graph, const std::vector<Goal>& goals, Queue& queue, ShortestPathTree& tree) {
    static_assert(is_queue_v<Queue>, "sspql: this Queue lacks one of prepare(n, least_cost, greatest_cost), "
                                     "push(vertex, key), decrease(vertex, key), pop() -> vertex, empty()");
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::size_t n = graph.size();
    detail::require_goals(goals, n);
    tree.distance.assign(n, infinity);
    tree.next.assign(n, no_state);
    queue.prepare(n, graph.least_cost(), graph.greatest_cost());
    for (const Goal& goal : goals) {
        double& distance = tree.distance[index(goal.state)];
        const auto vertex = static_cast<std::uint32_t>(goal.state);
        if (distance == infinity) {
            distance = goal.offset;
            queue.push(vertex, goal.offset);
        } else if (goal.offset < distance) {
            distance = goal.offset;
            queue.decrease(vertex, goal.offset);
        }
    }
    SearchWork work;
    while (!queue.empty()) {
        const StateId v{queue.pop()};
        const double here = tree.distance[index(v)];
        ++work.states;
        graph.for_each_predecessor(v, [&](StateId u, double cost) {
            ++work.edges;
            const double through = here + cost;
            double& distance = tree.distance[index(u)];
            StateId& next = tree.next[index(u)];
            if (through < distance) {
                const bool known = distance != infinity;
                distance = through;
                next = v;
                if (known) {
                    queue.decrease(static_cast<std::uint32_t>(u), through);
                } else {
                    queue.push(static_cast<std::uint32_t>(u), through);
                }
            } else if (through == distance && here < distance && next != no_state && v < next) {
                next = v;  // here < distance: v settled strictly before u, so no cycle can close
            }
        });
    }
    return work;
}

/// The same with a queue of its own: `const auto tree = shortest_paths_to(graph, {{goal}});`
template <class Graph>
[[nodiscard]] ShortestPathTree shortest_paths_to(const Graph& graph, const std::vector<Goal>& goals) {
    ShortestPathTree tree;
    FibonacciHeap<> queue;
    shortest_paths_to(graph, goals, queue, tree);
    return tree;
}

}  // namespace sspql
