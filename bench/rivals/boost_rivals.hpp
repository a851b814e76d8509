// SPDX-License-Identifier: MIT
#pragma once

// Boost.Graph's dijkstra_shortest_paths on its three kinds of graph, and its search over Boost.Heap's Fibonacci heap.
// All find distances and predecessors; the latter without a rule for ties.

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/reverse_graph.hpp>
#include <boost/graph/two_bit_color_map.hpp>
#include <boost/heap/fibonacci_heap.hpp>
#include <boost/property_map/property_map.hpp>

#include <sspql/core/ids.hpp>
#include <sspql/paths/reverse_graph.hpp>

#include "rivals/contender.hpp"

namespace sspql::rivals {

using BoostWeight = boost::property<boost::edge_weight_t, double>;

/// The edges already reversed, as one would build them for searches towards a goal.
using BoostList = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property, BoostWeight>;

/// The edges as learnt, in both directions, so that boost::reverse_graph can turn them.
using BoostBothWays =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::bidirectionalS, boost::no_property, BoostWeight>;

struct BoostCost {
    double cost;
};
using BoostRows = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, BoostCost>;

inline BoostList boost_list(const ReverseGraph& graph) {
    BoostList list(graph.size());
    for (std::size_t v = 0; v < graph.size(); ++v) {
        graph.for_each_predecessor(state_id(v), [&](StateId u, double cost) { add_edge(v, index(u), cost, list); });
    }
    return list;
}

inline BoostBothWays boost_both_ways(const ReverseGraph& graph) {
    BoostBothWays list(graph.size());
    for (std::size_t v = 0; v < graph.size(); ++v) {
        graph.for_each_predecessor(state_id(v), [&](StateId u, double cost) { add_edge(index(u), v, cost, list); });
    }
    return list;
}

inline BoostRows boost_rows(const ReverseGraph& graph) {
    std::vector<std::pair<std::size_t, std::size_t>> edges;
    std::vector<BoostCost> costs;
    edges.reserve(graph.edges());
    costs.reserve(graph.edges());
    for (std::size_t v = 0; v < graph.size(); ++v) {
        graph.for_each_predecessor(state_id(v), [&](StateId u, double cost) {
            edges.emplace_back(v, index(u));
            costs.push_back({cost});
        });
    }
    return BoostRows(boost::edges_are_sorted, edges.begin(), edges.end(), costs.begin(), graph.size());
}

/// What all have: buffers reused from run to run. (Raw pointers would not do for property maps: the header of the
/// compressed rows hides their get.)
template <class Graph>
class BoostContender : public Contender {
public:
    /// Boost's lists cannot be moved, so `make` builds the graph in place.
    BoostContender(std::string name, const ReverseGraph& graph, Graph (*make)(const ReverseGraph&), StateId goal)
        : Contender(std::move(name)),
          graph_(make(graph)),
          goal_(index(goal)),
          distance_(num_vertices(graph_)),
          predecessor_(num_vertices(graph_)) {}

    [[nodiscard]] double distance(std::size_t state) const override { return distance_[state]; }

protected:
    template <class View, class Weights>
    void search(const View& view, const Weights& weights) {
        boost::dijkstra_shortest_paths(
            view, goal_,
            boost::weight_map(weights).distance_map(map(distance_, view)).predecessor_map(map(predecessor_, view)));
    }

    template <class Values, class View>
    static auto map(Values& values, const View& view) {
        return boost::make_iterator_property_map(values.begin(), get(boost::vertex_index, view));
    }

    Graph graph_;
    std::size_t goal_;
    std::vector<double> distance_;
    std::vector<std::size_t> predecessor_;
};

class BoostListDijkstra : public BoostContender<BoostList> {
public:
    BoostListDijkstra(const ReverseGraph& graph, StateId goal)
        : BoostContender("Boost list", graph, boost_list, goal) {}
    void run() override { search(graph_, get(boost::edge_weight, graph_)); }
};

class BoostBothWaysDijkstra : public BoostContender<BoostBothWays> {
public:
    BoostBothWaysDijkstra(const ReverseGraph& graph, StateId goal)
        : BoostContender("Boost both ways", graph, boost_both_ways, goal) {}
    void run() override {
        const boost::reverse_graph<BoostBothWays> reversed(graph_);
        search(reversed, get(boost::edge_weight, reversed));
    }
};

class BoostRowsDijkstra : public BoostContender<BoostRows> {
public:
    BoostRowsDijkstra(const ReverseGraph& graph, StateId goal)
        : BoostContender("Boost rows", graph, boost_rows, goal) {}
    void run() override { search(graph_, get(&BoostCost::cost, graph_)); }
};

/// The queue that Boost.Graph's search asks for, over Boost.Heap's Fibonacci heap. compare<greater> makes the least
/// distance the heap's top, and a smaller distance its `increase`, which is O(1); `decrease` would consolidate.
class BoostFibonacciQueue {
public:
    explicit BoostFibonacciQueue(const std::vector<double>& distance) : distance_(distance), handle_(distance.size()) {}

    [[nodiscard]] bool empty() const { return heap_.empty(); }
    void push(std::size_t v) { handle_[v] = heap_.push({distance_[v], v}); }
    [[nodiscard]] std::size_t top() const { return heap_.top().second; }
    void pop() { heap_.pop(); }
    void update(std::size_t v) { heap_.increase(handle_[v], {distance_[v], v}); }

private:
    using Item = std::pair<double, std::size_t>;
    using Heap = boost::heap::fibonacci_heap<Item, boost::heap::compare<std::greater<Item>>>;

    const std::vector<double>& distance_;
    Heap heap_;
    std::vector<Heap::handle_type> handle_;
};

class BoostFibonacciDijkstra : public BoostContender<BoostRows> {
public:
    BoostFibonacciDijkstra(const ReverseGraph& graph, StateId goal)
        : BoostContender("Boost rows, Boost.Heap Fibonacci", graph, boost_rows, goal), queue_(distance_) {}

    void run() override {
        distance_.assign(distance_.size(), std::numeric_limits<double>::infinity());
        distance_[goal_] = 0.0;
        const auto vertex_index = get(boost::vertex_index, graph_);
        const auto predecessors = map(predecessor_, graph_);
        const auto distances = map(distance_, graph_);
        const auto weights = get(&BoostCost::cost, graph_);
        boost::two_bit_color_map<decltype(vertex_index)> colors(distance_.size(), vertex_index);
        using Visitor =
            boost::detail::dijkstra_bfs_visitor<boost::dijkstra_visitor<>, BoostFibonacciQueue,
                                                std::remove_const_t<decltype(weights)>,
                                                std::remove_const_t<decltype(predecessors)>,
                                                std::remove_const_t<decltype(distances)>, std::plus<>, std::less<>>;
        const Visitor visitor(boost::dijkstra_visitor<>(), queue_, weights, predecessors, distances, std::plus<>(),
                              std::less<>(), 0.0);
        boost::breadth_first_visit(graph_, &goal_, &goal_ + 1, queue_, visitor, colors);
    }

private:
    BoostFibonacciQueue queue_;
};

}  // namespace sspql::rivals
