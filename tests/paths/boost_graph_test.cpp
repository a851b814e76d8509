// SPDX-License-Identifier: MIT
// The learnt model as a Boost.Graph graph.
#include <sspql/paths/boost_graph.hpp>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <boost/graph/astar_search.hpp>
#include <boost/graph/graph_concepts.hpp>
#include <boost/graph/strong_components.hpp>

#include <sspql/core/random.hpp>
#include <sspql/paths/cost_publisher.hpp>
#include <sspql/paths/shortest_paths.hpp>

using sspql::CostPublisher;
using sspql::CountCell;
using sspql::Random;
using sspql::ReverseGraph;
using sspql::state_id;
using sspql::StateId;
using sspql::TransitionCounts;

BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<ReverseGraph>));
BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<ReverseGraph>));
BOOST_CONCEPT_ASSERT((boost::EdgeListGraphConcept<ReverseGraph>));
BOOST_CONCEPT_ASSERT((boost::ReadablePropertyMapConcept<boost::property_map<ReverseGraph, boost::edge_weight_t>::type,
                                                        boost::graph_traits<ReverseGraph>::edge_descriptor>));

namespace {

constexpr StateId s0{0}, s1{1}, s2{2};

/// A model learnt by random steps on a ring with a few chords, of which some lead nowhere.
ReverseGraph learnt(std::uint64_t seed, std::size_t n) {
    Random random(seed);
    TransitionCounts<CountCell> counts(n, 3);
    for (std::size_t i = 0; i < 2 * n; ++i) {
        const std::size_t s = random.below(n);
        const sspql::ActionId a = sspql::action_id(random.below(3));
        const std::size_t next = random.chance(0.7) ? (s + 1) % n : random.below(n);
        counts.record(state_id(s), a, state_id(next));
    }
    CostPublisher<>().publish(counts);
    ReverseGraph graph;
    graph.assign(counts);
    return graph;
}

/// reaches[u][v]: Floyd and Warshall's closure.
std::vector<std::vector<bool>> closure(const ReverseGraph& graph) {
    const std::size_t n = graph.size();
    std::vector<std::vector<bool>> reaches(n, std::vector<bool>(n, false));
    for (std::size_t v = 0; v < n; ++v) {
        reaches[v][v] = true;
        graph.for_each_predecessor(state_id(v), [&](StateId u, double) { reaches[index(u)][v] = true; });
    }
    for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; reaches[i][k] && j < n; ++j) {
                if (reaches[k][j]) reaches[i][j] = true;
            }
        }
    }
    return reaches;
}

}  // namespace

TEST(BoostGraph, ListsVerticesAndReversedEdges) {
    const auto graph = ReverseGraph::from_edges(5, {{s0, s2, 1.5}, {s1, s2, 2.5}, {s2, s1, 3.5}});
    EXPECT_EQ(num_vertices(graph), 5u);
    EXPECT_EQ(num_edges(graph), 3u);
    EXPECT_EQ(out_degree(2, graph), 2u);
    EXPECT_EQ(out_degree(0, graph), 0u);
    const auto [first_vertex, last_vertex] = vertices(graph);
    EXPECT_EQ(std::distance(first_vertex, last_vertex), 5);
    std::map<std::pair<std::size_t, std::size_t>, double> listed, incident;
    const auto [first, last] = edges(graph);
    for (auto at = first; at != last; ++at) {
        listed[{source(*at, graph), target(*at, graph)}] = get(boost::edge_weight, graph, *at);
    }
    for (std::size_t v = 0; v < 5; ++v) {
        const auto [begin, end] = out_edges(v, graph);
        for (auto at = begin; at != end; ++at) {
            incident[{source(*at, graph), target(*at, graph)}] = get(get(boost::edge_weight, graph), *at);
        }
    }
    const std::map<std::pair<std::size_t, std::size_t>, double> expected{{{2, 0}, 1.5}, {{2, 1}, 2.5}, {{1, 2}, 3.5}};
    EXPECT_EQ(listed, expected);
    EXPECT_EQ(incident, expected);
}

TEST(BoostGraph, AnEmptyGraphHasNoEdges) {
    for (const ReverseGraph& graph : {ReverseGraph(), ReverseGraph::from_edges(3, {})}) {
        const auto [first, last] = edges(graph);
        EXPECT_TRUE(first == last);
    }
}

TEST(BoostGraph, StrongComponentsAreStatesThatReachEachOther) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const ReverseGraph graph = learnt(seed, 40);
        std::vector<std::size_t> component(graph.size());
        boost::strong_components(graph,
                                 boost::make_iterator_property_map(component.begin(), get(boost::vertex_index, graph)));
        const auto reaches = closure(graph);
        for (std::size_t u = 0; u < graph.size(); ++u) {
            for (std::size_t v = 0; v < graph.size(); ++v) {
                ASSERT_EQ(component[u] == component[v], reaches[u][v] && reaches[v][u]) << u << " and " << v;
            }
        }
    }
}

TEST(BoostGraph, AStarWithoutHeuristicFindsTheSameDistances) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const ReverseGraph graph = learnt(seed, 60);
        std::vector<double> distance(graph.size());
        const auto vertex_index = get(boost::vertex_index, graph);
        boost::astar_search(graph, std::size_t{0}, boost::astar_heuristic<ReverseGraph, double>(),
                            boost::visitor(boost::default_astar_visitor())
                                .weight_map(get(boost::edge_weight, graph))
                                .vertex_index_map(vertex_index)
                                .distance_map(boost::make_iterator_property_map(distance.begin(), vertex_index))
                                .distance_inf(std::numeric_limits<double>::infinity()));
        EXPECT_EQ(sspql::shortest_paths_to(graph, {{s0}}).distance, distance);
    }
}
