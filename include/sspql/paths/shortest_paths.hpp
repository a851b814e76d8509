// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <sspql/core/concepts.hpp>
#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/model/prefetch.hpp>
#include <sspql/paths/auto_queue.hpp>
#include <sspql/paths/queue.hpp>

namespace sspql {

/// Where paths may end. `offset` (>= 0) is the cost still to pay there: of two goals the one with the smaller offset is
/// worth going further for.
struct Goal {
    StateId state{};      ///< where paths may end
    double offset = 0.0;  ///< cost still to pay there, in the unit of edge costs; finite and >= 0

    template <class Archive>
    void serialize(Archive& archive) {
        archive(state, offset);
    }
};

/// Shortest paths from every state to its best goal, as a tree whose edges lead towards the goals.
struct ShortestPathTree {
    /// By state: cost of the path, the goal's offset included; infinite where no path is known.
    std::vector<double> distance;
    /// By state: the next state on the path; no_state at a goal where paths end, and where no path is known.
    std::vector<StateId> next;

    /// The number of states.
    [[nodiscard]] std::size_t size() const noexcept { return distance.size(); }

    /// Whether a path from s is known; false for states outside.
    [[nodiscard]] bool reaches_goal(StateId s) const noexcept {
        return index(s) < size() && distance[index(s)] < std::numeric_limits<double>::infinity();
    }

    /// For checkpoints, of at most `states` states.
    template <class Archive>
    void serialize(Archive& archive, std::size_t states) {
        archive(distance, next);
        if constexpr (Archive::loading) {
            archive.require(distance.size() == next.size() && size() <= states, "shortest paths are of other states");
            for (std::size_t s = 0; s < size(); ++s) {
                archive.require(distance[s] >= 0.0, "a distance is negative or no number");
                archive.require(next[s] == no_state || (index(next[s]) < size() && reaches_goal(state_id(s)) &&
                                                        distance[index(next[s])] <= distance[s]),
                                "a shortest path is wrong");
            }
            archive.require(ends_everywhere(), "a shortest path has no end");
        }
    }

    /// Whether every path comes to an end. O(n).
    [[nodiscard]] bool ends_everywhere() const {
        std::vector<std::size_t> round(size(), 0);  // in which a walk came by; 0: none yet
        for (std::size_t s = 0; s < size(); ++s) {
            StateId at = state_id(s);
            while (at != no_state && round[index(at)] == 0) {
                round[index(at)] = s + 1;
                at = next[index(at)];
            }
            if (at != no_state && round[index(at)] == s + 1) return false;
        }
        return true;
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
    std::size_t states = 0;  ///< settled: those with a path, once each, or more often if a label was corrected
    std::size_t edges = 0;   ///< looked at
};

namespace detail {

/// \throws std::invalid_argument for a goal outside the graph or an offset that is NaN, infinite or negative.
inline void require_goals(const std::vector<Goal>& goals, std::size_t states) {
    for (const Goal& goal : goals) {
        if (index(goal.state) >= states) {
            throw_invalid("goal", "be below the number of states " + std::to_string(states), index(goal.state));
        }
        if (goal.offset >= 0.0 && std::isfinite(goal.offset)) continue;  // no text, no allocation
        require_not_negative("offset of goal " + std::to_string(index(goal.state)), goal.offset);
    }
}

template <class Queue, class F>
using Visit = decltype(std::declval<Queue&>().visit(std::declval<const F&>()));

template <class Graph>
using PrefetchEdges = decltype(std::declval<const Graph&>().prefetch_offset(StateId{}),
                               std::declval<const Graph&>().prefetch_edges(StateId{}));

/// f(the queue that an AutoQueue chose); f(queue) for all others.
template <class Queue, class F>
auto with_chosen(Queue& queue, const F& f) {
    if constexpr (is_detected_v<Visit, Queue, F>) {
        return queue.visit(f);
    } else {
        return f(queue);
    }
}

template <class Queue>
void push_goals(const std::vector<Goal>& goals, Queue& queue, ShortestPathTree& tree) {
    for (const Goal& goal : goals) {
        double& distance = tree.distance[index(goal.state)];
        const auto vertex = static_cast<std::uint32_t>(goal.state);
        if (distance == std::numeric_limits<double>::infinity()) {
            distance = goal.offset;
            queue.push(vertex, goal.offset);
        } else if (goal.offset < distance) {
            distance = goal.offset;
            queue.decrease(vertex, goal.offset);
        }
    }
}

/// Below this many states a search runs within the caches, and asking for memory ahead costs more than it saves.
inline constexpr std::size_t prefetch_from = 30000;

/// Asks for the memory that the coming pops will read: where a state's edges begin, the edges, what they lead to. A
/// search of a large graph waits for memory more than for anything else.
template <class Graph, class Queue>
void prefetch_ahead(const Graph& graph, const Queue& queue, const ShortestPathTree& tree) {
    const std::uint32_t latest = queue.upcoming(8);
    if (latest == no_vertex) return;
    graph.prefetch_offset(StateId{latest});
    graph.prefetch_edges(StateId{queue.upcoming(4)});
    graph.for_each_predecessor(StateId{queue.upcoming(2)},
                               [&](StateId u, double) { prefetch(&tree.distance[index(u)]); });
}

/// Dijkstra's search from what is queued.
template <class Graph, class Queue>
SearchWork settle_all(const Graph& graph, Queue& queue, ShortestPathTree& tree) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double* const distances = tree.distance.data();
    StateId* const nexts = tree.next.data();
    std::size_t states = 0;
    std::size_t edges = 0;
    [[maybe_unused]] const bool large = graph.size() >= prefetch_from;
    while (!queue.empty()) {
        if constexpr (is_detected_v<Upcoming, Queue> && is_detected_v<PrefetchEdges, Graph>) {
            if (large) prefetch_ahead(graph, queue, tree);
        }
        const StateId v{queue.pop()};
        const double here = distances[index(v)];
        ++states;
        graph.for_each_predecessor(v, [&](StateId u, double cost) {
            ++edges;
            const double through = here + cost;
            double& distance = distances[index(u)];
            StateId& next = nexts[index(u)];
            if (!(through <= distance)) return;
            if (through == distance) {
                if (here < distance && next != no_state && v < next) next = v;  // here < distance: no cycle can close
                return;
            }
            const bool known = distance != infinity;
            distance = through;
            next = v;
            if (known) {
                queue.decrease(static_cast<std::uint32_t>(u), through);
            } else {
                queue.push(static_cast<std::uint32_t>(u), through);
            }
        });
    }
    return {states, edges};
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
/// `tree` and `queue` are overwritten; reuse them to avoid allocation. O(m + n log n) with FibonacciHeap, with
/// RingQueue over it and with AutoQueue, for n states and m edges; see docs/complexity.md.
/// \throws std::invalid_argument for a goal outside the graph or an offset that is not finite and >= 0; `tree` is
/// untouched then.
template <class Graph, class Queue>
SearchWork shortest_paths_to(const Graph& graph, const std::vector<Goal>& goals, Queue& queue, ShortestPathTree& tree) {
    static_assert(detail::QueueRequirements<Queue>::met);
    const std::size_t n = graph.size();
    detail::require_goals(goals, n);
    tree.distance.assign(n, std::numeric_limits<double>::infinity());
    tree.next.assign(n, no_state);
    queue.prepare(n, graph.least_cost(), graph.greatest_cost());
    return detail::with_chosen(queue, [&](auto& chosen) {
        detail::push_goals(goals, chosen, tree);
        return detail::settle_all(graph, chosen, tree);
    });
}

/// The same with a queue of its own: `const auto tree = shortest_paths_to(graph, {{goal}});`
template <class Graph>
[[nodiscard]] ShortestPathTree shortest_paths_to(const Graph& graph, const std::vector<Goal>& goals) {
    ShortestPathTree tree;
    AutoQueue<> queue;
    shortest_paths_to(graph, goals, queue, tree);
    return tree;
}

}  // namespace sspql
