// SPDX-License-Identifier: MIT
#pragma once

// LEMON's Dijkstra on its most compact graph, with three of its heaps. Header-only; compile it as C++17 at most.

#define LEMON_ONLY_TEMPLATES
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <lemon/bin_heap.h>
#include <lemon/dijkstra.h>
#include <lemon/fib_heap.h>
#include <lemon/quad_heap.h>
#include <lemon/static_graph.h>

#include <sspql/core/ids.hpp>
#include <sspql/paths/reverse_graph.hpp>

#include "rivals/contender.hpp"

namespace sspql::rivals {

using LemonGraph = lemon::StaticDigraph;
using LemonPlaces = LemonGraph::NodeMap<int>;
using LemonBinary = lemon::BinHeap<double, LemonPlaces>;
using LemonQuaternary = lemon::QuadHeap<double, LemonPlaces>;
using LemonFibonacci = lemon::FibHeap<double, LemonPlaces>;

/// The graph and its lengths, shared by the heaps.
class LemonInput {
public:
    explicit LemonInput(const ReverseGraph& graph) : costs_(graph_) {
        std::vector<std::pair<int, int>> arcs;
        arcs.reserve(graph.edges());
        for (std::size_t v = 0; v < graph.size(); ++v) {
            graph.for_each_predecessor(state_id(v), [&](StateId u, double) {
                arcs.emplace_back(static_cast<int>(v), static_cast<int>(index(u)));
            });
        }
        graph_.build(static_cast<int>(graph.size()), arcs.begin(), arcs.end());
        int arc = 0;
        for (std::size_t v = 0; v < graph.size(); ++v) {
            graph.for_each_predecessor(state_id(v), [&](StateId, double cost) { costs_[graph_.arc(arc++)] = cost; });
        }
    }

    [[nodiscard]] const LemonGraph& graph() const { return graph_; }
    [[nodiscard]] const LemonGraph::ArcMap<double>& costs() const { return costs_; }

private:
    LemonGraph graph_;
    LemonGraph::ArcMap<double> costs_;
};

template <class Heap>
class LemonDijkstra : public Contender {
public:
    LemonDijkstra(std::string name, const LemonInput& input, StateId goal)
        : Contender(std::move(name)),
          graph_(input.graph()),
          goal_(graph_.node(static_cast<int>(index(goal)))),
          search_(graph_, input.costs()) {}

    void run() override { search_.run(goal_); }
    [[nodiscard]] double distance(std::size_t state) const override {
        return search_.dist(graph_.node(static_cast<int>(state)));
    }

private:
    using Search =
        typename lemon::Dijkstra<LemonGraph, LemonGraph::ArcMap<double>>::template SetStandardHeap<Heap>::Create;

    const LemonGraph& graph_;
    LemonGraph::Node goal_;
    Search search_;
};

}  // namespace sspql::rivals
