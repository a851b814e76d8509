// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <boost/property_map/property_map.hpp>

#include <sspql/paths/reverse_graph.hpp>

/// \file
/// ReverseGraph as a Boost.Graph graph: it models IncidenceGraph, VertexListGraph and EdgeListGraph, so that
/// Boost.Graph's algorithms run on the learnt model. Its edges are the learnt ones reversed: an out-edge of v leads to a
/// state that v was reached from, target(e, g) is that state and get(boost::edge_weight, g) its expected cost. A search
/// from a goal therefore finds the paths to it.
///
/// Include it before the Boost.Graph algorithm, and keep it out of other headers: it is slow to compile.

namespace sspql::detail {

/// Edge number `id` of the graph, out of `source`.
struct ReversedEdge {
    std::size_t source = 0;
    std::uint32_t id = 0;

    friend bool operator==(const ReversedEdge& a, const ReversedEdge& b) noexcept { return a.id == b.id; }
    friend bool operator!=(const ReversedEdge& a, const ReversedEdge& b) noexcept { return a.id != b.id; }
};

class OutEdgeIterator : public boost::iterator_facade<OutEdgeIterator, ReversedEdge, boost::random_access_traversal_tag,
                                                      ReversedEdge, std::ptrdiff_t> {
public:
    OutEdgeIterator() = default;
    OutEdgeIterator(std::size_t source, std::uint32_t id) : edge_{source, id} {}

private:
    friend class boost::iterator_core_access;
    [[nodiscard]] ReversedEdge dereference() const { return edge_; }
    [[nodiscard]] bool equal(const OutEdgeIterator& other) const { return edge_ == other.edge_; }
    void increment() { ++edge_.id; }
    void decrement() { --edge_.id; }
    void advance(std::ptrdiff_t n) { edge_.id = static_cast<std::uint32_t>(static_cast<std::ptrdiff_t>(edge_.id) + n); }
    [[nodiscard]] std::ptrdiff_t distance_to(const OutEdgeIterator& other) const {
        return static_cast<std::ptrdiff_t>(other.edge_.id) - static_cast<std::ptrdiff_t>(edge_.id);
    }
    ReversedEdge edge_;
};

/// All edges, by source.
class EdgeIterator
    : public boost::iterator_facade<EdgeIterator, ReversedEdge, boost::forward_traversal_tag, ReversedEdge> {
public:
    EdgeIterator() = default;
    EdgeIterator(const ReverseGraph& graph, std::uint32_t id) : graph_(&graph), edge_{0, id} { skip(); }

private:
    friend class boost::iterator_core_access;
    [[nodiscard]] ReversedEdge dereference() const { return edge_; }
    [[nodiscard]] bool equal(const EdgeIterator& other) const { return edge_ == other.edge_; }
    void increment() {
        ++edge_.id;
        skip();
    }
    void skip() {
        while (edge_.source < graph_->size() && edge_.id >= graph_->end(state_id(edge_.source))) ++edge_.source;
    }
    const ReverseGraph* graph_ = nullptr;
    ReversedEdge edge_;
};

struct ReverseGraphCategory : boost::incidence_graph_tag, boost::vertex_list_graph_tag, boost::edge_list_graph_tag {};

/// Readable property map: an edge's expected cost.
struct EdgeCostMap {
    using value_type = double;
    using reference = double;
    using key_type = ReversedEdge;
    using category = boost::readable_property_map_tag;
    const ReverseGraph* graph = nullptr;
};

inline double get(const EdgeCostMap& map, const ReversedEdge& edge) { return map.graph->cost(edge.id); }

}  // namespace sspql::detail

namespace boost {

template <>
struct graph_traits<sspql::ReverseGraph> {
    using vertex_descriptor = std::size_t;
    using edge_descriptor = sspql::detail::ReversedEdge;
    using directed_category = directed_tag;
    using edge_parallel_category = allow_parallel_edge_tag;
    using traversal_category = sspql::detail::ReverseGraphCategory;
    using vertices_size_type = std::size_t;
    using edges_size_type = std::size_t;
    using degree_size_type = std::size_t;
    using vertex_iterator = counting_iterator<std::size_t>;
    using out_edge_iterator = sspql::detail::OutEdgeIterator;
    using edge_iterator = sspql::detail::EdgeIterator;

    static vertex_descriptor null_vertex() { return static_cast<std::size_t>(-1); }
};

/// Some algorithms (bellman_ford_shortest_paths) take their graph by a reference that deduces const.
template <>
struct graph_traits<const sspql::ReverseGraph> : graph_traits<sspql::ReverseGraph> {};

template <>
struct property_map<sspql::ReverseGraph, edge_weight_t> {
    using type = sspql::detail::EdgeCostMap;
    using const_type = sspql::detail::EdgeCostMap;
};

template <>
struct property_map<sspql::ReverseGraph, vertex_index_t> {
    using type = typed_identity_property_map<std::size_t>;
    using const_type = typed_identity_property_map<std::size_t>;
};

}  // namespace boost

namespace sspql {

/// VertexListGraph: the number of states.
inline std::size_t num_vertices(const ReverseGraph& g) { return g.size(); }
/// EdgeListGraph: the number of edges.
inline std::size_t num_edges(const ReverseGraph& g) { return g.edges(); }

/// VertexListGraph: all states, 0 .. size() - 1.
inline std::pair<boost::counting_iterator<std::size_t>, boost::counting_iterator<std::size_t>> vertices(
    const ReverseGraph& g) {
    return {boost::counting_iterator<std::size_t>(0), boost::counting_iterator<std::size_t>(g.size())};
}

/// EdgeListGraph: all edges, by the state they are out of, which is the one that the learnt edges lead to.
inline std::pair<detail::EdgeIterator, detail::EdgeIterator> edges(const ReverseGraph& g) {
    return {detail::EdgeIterator(g, 0), detail::EdgeIterator(g, static_cast<std::uint32_t>(g.edges()))};
}

/// IncidenceGraph: the edges out of v, to the states that v was reached from.
inline std::pair<detail::OutEdgeIterator, detail::OutEdgeIterator> out_edges(std::size_t v, const ReverseGraph& g) {
    return {detail::OutEdgeIterator(v, g.begin(state_id(v))), detail::OutEdgeIterator(v, g.end(state_id(v)))};
}

/// IncidenceGraph: how many edges are out of v.
inline std::size_t out_degree(std::size_t v, const ReverseGraph& g) { return g.end(state_id(v)) - g.begin(state_id(v)); }

namespace detail {

// Found by argument-dependent lookup through the edge type.
inline std::size_t source(const ReversedEdge& edge, const ReverseGraph&) { return edge.source; }
inline std::size_t target(const ReversedEdge& edge, const ReverseGraph& g) { return index(g.predecessor(edge.id)); }

}  // namespace detail

using detail::source;
using detail::target;

/// The expected costs as a readable property map, valid as long as the graph.
inline detail::EdgeCostMap get(boost::edge_weight_t, const ReverseGraph& g) { return {&g}; }
/// An edge's expected cost.
inline double get(boost::edge_weight_t, const ReverseGraph& g, const detail::ReversedEdge& edge) {
    return g.cost(edge.id);
}
/// The vertices are their own indices.
inline boost::typed_identity_property_map<std::size_t> get(boost::vertex_index_t, const ReverseGraph&) { return {}; }

}  // namespace sspql
