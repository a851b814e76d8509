// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/graph/two_bit_color_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <sspql/core/assert.hpp>
#include <sspql/core/errors.hpp>
#include <sspql/paths/queue.hpp>

/// \file
/// Our queues under Boost.Graph's search: its dijkstra_shortest_paths has a 4-ary heap built in, but
/// breadth_first_visit takes any queue. The other way round, our graph under Boost.Graph's algorithms: boost_graph.hpp.
/// Keep both out of other headers: they are slow to compile.

namespace sspql {

/// Any of our queues as what Boost.Graph calls an UpdatableQueue, over vertices that are the numbers 0 .. n-1. A key is
/// what `DistanceMap` holds when a vertex is pushed or updated. Nothing may be pushed or updated between top() and
/// pop(): our queues hand out and drop a vertex at once.
///
/// Keys only decrease while a vertex is queued. A queue that is `monotone_only` takes no key below the last popped one,
/// which serves Dijkstra's search but not Prim's; one that `corrects_labels` also takes vertices back by update().
/// Memory: a bit a vertex, and the queue's.
template <class Queue, class DistanceMap>
class BoostQueue {
    static_assert(detail::QueueRequirements<Queue>::met);

public:
    /// A vertex.
    using value_type = typename boost::property_traits<DistanceMap>::key_type;
    /// Counts vertices.
    using size_type = std::size_t;
    static_assert(std::is_integral_v<value_type>, "sspql: a BoostQueue's vertices are the numbers 0 .. n-1");

    /// Empties `queue`, which must outlive this. The bounds on edge costs are hints for the queue's buckets.
    BoostQueue(Queue& queue, std::size_t n, DistanceMap distance, double least_cost, double greatest_cost)
        : queue_(queue), distance_(distance), queued_(n, false) {
        queue_.prepare(n, least_cost, greatest_cost);
    }

    /// Whether nothing is queued.
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
    /// How many vertices are queued.
    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    /// Whether v is queued.
    [[nodiscard]] bool contains(value_type v) const { return queued_[static_cast<std::size_t>(v)]; }

    /// Queues v, which is not queued, with the key that the map holds for it.
    void push(value_type v) {
        SSPQL_ASSERT(!held_ && !contains(v), "a vertex not queued, and none between top and pop");
        count(v, true);
        queue_.push(static_cast<std::uint32_t>(v), get(distance_, v));
    }

    /// The distance of v became smaller.
    void update(value_type v) {
        SSPQL_ASSERT(!held_ && (contains(v) || corrects_labels_v<Queue>), "a queued vertex");
        if (!contains(v)) count(v, true);
        queue_.decrease(static_cast<std::uint32_t>(v), get(distance_, v));
    }

    /// The vertex that pop() drops: a nearest one, or nearly so if the queue corrects labels. Not empty.
    [[nodiscard]] value_type& top() {
        if (!std::exchange(held_, true)) top_ = static_cast<value_type>(queue_.pop());
        return top_;
    }

    /// Drops top().
    void pop() {
        count(top(), false);
        held_ = false;
    }

private:
    void count(value_type v, bool in) {
        queued_[static_cast<std::size_t>(v)] = in;
        in ? ++size_ : --size_;
    }

    Queue& queue_;
    DistanceMap distance_;
    std::vector<bool> queued_;
    std::size_t size_ = 0;
    value_type top_{};
    bool held_ = false;
};

namespace detail {

/// Turns breadth_first_visit into Dijkstra's search; what a queue's corrected label makes nearer is visited again.
template <class Queue, class WeightMap, class DistanceMap, class PredecessorMap>
class NearestFirst : public boost::default_bfs_visitor {
public:
    NearestFirst(Queue& queue, WeightMap weight, DistanceMap distance, PredecessorMap predecessor)
        : queue_(&queue), weight_(weight), distance_(distance), predecessor_(predecessor) {}

    template <class Edge, class Graph>
    bool tree_edge(const Edge& e, const Graph& g) {
        const auto through = get(distance_, source(e, g)) + get(weight_, e);
        if (!(through < get(distance_, target(e, g)))) return false;
        put(distance_, target(e, g), through);
        put(predecessor_, target(e, g), source(e, g));
        return true;
    }
    template <class Edge, class Graph>
    void non_tree_edge(const Edge& e, const Graph& g) {
        if (tree_edge(e, g)) queue_->update(target(e, g));
    }

private:
    Queue* queue_;
    WeightMap weight_;
    DistanceMap distance_;
    PredecessorMap predecessor_;
};

}  // namespace detail

/// Boost.Graph's search from one vertex, driven by one of our queues, on any IncidenceGraph, VertexListGraph and
/// EdgeListGraph whose vertices are the numbers 0 .. n-1 (ReverseGraph, lists with vecS, compressed rows). Afterwards
/// `distance` and `predecessor` hold what boost::dijkstra_shortest_paths finds, distances to the last bit: infinity and
/// the vertex itself where none leads; of several equal paths another one may be told.
///
/// Time and operations are the queue's (see docs/complexity.md), plus a pass over the edges for their bounds.
/// \throws std::invalid_argument for a weight that is NaN, infinite or negative; the maps are untouched then.
template <class Graph, class Queue, class WeightMap, class DistanceMap, class PredecessorMap>
void dijkstra_with_queue(const Graph& graph, typename boost::graph_traits<Graph>::vertex_descriptor start, Queue& queue,
                         WeightMap weight, DistanceMap distance, PredecessorMap predecessor) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double least = infinity;
    double greatest = 0.0;
    for (auto [e, last] = edges(graph); e != last; ++e) {
        const double cost = get(weight, *e);
        if (!(cost >= 0.0 && cost < infinity)) require_not_negative("weight of an edge", cost);  // it throws
        least = std::min(least, cost);
        greatest = std::max(greatest, cost);
    }
    for (auto [v, last] = vertices(graph); v != last; ++v) {
        put(distance, *v, infinity);
        put(predecessor, *v, *v);
    }
    put(distance, start, 0.0);
    BoostQueue<Queue, DistanceMap> adapted(queue, num_vertices(graph), distance, std::min(least, greatest), greatest);
    const auto number = get(boost::vertex_index, graph);
    const boost::two_bit_color_map<std::decay_t<decltype(number)>> colors(num_vertices(graph), number);
    using Visitor = detail::NearestFirst<BoostQueue<Queue, DistanceMap>, WeightMap, DistanceMap, PredecessorMap>;
    boost::breadth_first_visit(graph, start, adapted, Visitor(adapted, weight, distance, predecessor), colors);
}

}  // namespace sspql
