// SPDX-License-Identifier: MIT
// shortest_paths_to against Boost.Graph's Dijkstra and Bellman-Ford, with every queue. All sum a path's costs from the
// goal outwards, so the distances must agree to the last bit.
#include <sspql/paths/boost_graph.hpp>
#include <sspql/paths/shortest_paths.hpp>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <boost/graph/bellman_ford_shortest_paths.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/property_map.hpp>

#include <sspql/paths/auto_queue.hpp>
#include <sspql/paths/bucket_queue.hpp>
#include <sspql/paths/dary_heap.hpp>
#include <sspql/paths/fibonacci_heap.hpp>
#include <sspql/paths/ring_queue.hpp>

#include "paths/random_graph.hpp"

using sspql::Goal;
using sspql::Random;
using sspql::ReverseGraph;
using sspql::ShortestPathTree;
using sspql_test::Costs;
using sspql_test::Shape;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<double> initial_distances(const ReverseGraph& graph, const std::vector<Goal>& goals) {
    std::vector<double> distance(graph.size(), infinity);
    for (const Goal& goal : goals) distance[index(goal.state)] = std::min(distance[index(goal.state)], goal.offset);
    return distance;
}

std::vector<double> boost_dijkstra(const ReverseGraph& graph, const std::vector<Goal>& goals) {
    std::vector<double> distance = initial_distances(graph, goals);
    std::vector<std::size_t> sources;
    for (std::size_t s = 0; s < graph.size(); ++s) {
        if (distance[s] < infinity) sources.push_back(s);
    }
    std::vector<boost::default_color_type> color(graph.size(), boost::white_color);
    const auto vertex_index = get(boost::vertex_index, graph);
    boost::dijkstra_shortest_paths_no_init(graph, sources.begin(), sources.end(), boost::dummy_property_map(),
                                           boost::make_iterator_property_map(distance.begin(), vertex_index),
                                           get(boost::edge_weight, graph), vertex_index, std::less<double>(),
                                           std::plus<double>(), 0.0, boost::default_dijkstra_visitor(),
                                           boost::make_iterator_property_map(color.begin(), vertex_index));
    return distance;
}

std::vector<double> boost_bellman_ford(const ReverseGraph& graph, const std::vector<Goal>& goals) {
    std::vector<double> distance = initial_distances(graph, goals);
    const auto vertex_index = get(boost::vertex_index, graph);
    const bool settled = boost::bellman_ford_shortest_paths(
        graph, graph.size(), get(boost::edge_weight, graph), boost::dummy_property_map(),
        boost::make_iterator_property_map(distance.begin(), vertex_index), std::plus<double>(), std::less<double>(),
        boost::default_bellman_visitor());
    EXPECT_TRUE(settled) << "no negative cycles";
    return distance;
}

template <class Queue>
void expect_same_tree(const ReverseGraph& graph, const std::vector<Goal>& goals, const std::vector<double>& distance,
                      Queue& queue, ShortestPathTree& tree) {
    sspql::shortest_paths_to(graph, goals, queue, tree);
    EXPECT_EQ(tree.distance, distance);
    sspql_test::expect_shortest_path_tree(graph, goals, tree);
}

/// Reused from graph to graph, as a learner does.
struct Queues {
    sspql::FibonacciHeap<> fibonacci;
    sspql::DaryHeap<2> binary;
    sspql::DaryHeap<3> ternary;
    sspql::DaryHeap<4> quaternary;
    sspql::DaryHeap<8> octal;
    sspql::BucketQueue<> buckets;
    sspql::RingQueue<> ring;
    sspql::RingQueue<sspql::DaryHeap<4>> ring_of_quaternary;
    sspql::AutoQueue<> chosen;
};

void compare(const ReverseGraph& graph, const std::vector<Goal>& goals, Queues& queues, ShortestPathTree& tree) {
    const std::vector<double> distance = boost_dijkstra(graph, goals);
    EXPECT_EQ(boost_bellman_ford(graph, goals), distance) << "the oracles agree";
    expect_same_tree(graph, goals, distance, queues.fibonacci, tree);
    expect_same_tree(graph, goals, distance, queues.binary, tree);
    expect_same_tree(graph, goals, distance, queues.ternary, tree);
    expect_same_tree(graph, goals, distance, queues.quaternary, tree);
    expect_same_tree(graph, goals, distance, queues.octal, tree);
    expect_same_tree(graph, goals, distance, queues.buckets, tree);
    expect_same_tree(graph, goals, distance, queues.ring, tree);
    expect_same_tree(graph, goals, distance, queues.ring_of_quaternary, tree);
    expect_same_tree(graph, goals, distance, queues.chosen, tree);
}

std::string name_of(const testing::TestParamInfo<Costs>& costs) {
    const char* const names[] = {"One", "FewIntegers", "Real", "SixDecades", "Absorbing"};
    return names[static_cast<int>(costs.param)];
}

class ShortestPathsOracle : public testing::TestWithParam<Costs> {};

}  // namespace

INSTANTIATE_TEST_SUITE_P(Costs, ShortestPathsOracle, testing::ValuesIn(sspql_test::cost_kinds), name_of);

TEST_P(ShortestPathsOracle, AgreesOnSmallGraphsOfEveryShape) {
    Queues queues;
    ShortestPathTree tree;
    for (const Shape shape : sspql_test::shapes) {
        for (std::uint64_t seed = 0; seed < 90; ++seed) {
            SCOPED_TRACE("shape " + std::to_string(static_cast<int>(shape)) + ", seed " + std::to_string(seed));
            Random random(seed, static_cast<std::uint64_t>(shape));
            const std::size_t n = 1 + random.below(24);
            const auto graph = ReverseGraph::from_edges(n, sspql_test::random_edges(random, n, shape, GetParam()));
            const std::vector<Goal> goals = sspql_test::random_goals(random, n, GetParam());
            compare(graph, goals, queues, tree);
            if (HasFailure()) return;
        }
    }
}

TEST_P(ShortestPathsOracle, AgreesOnLargerGraphs) {
    Queues queues;
    ShortestPathTree tree;
    for (const Shape shape : {Shape::sparse, Shape::star_in, Shape::star_out, Shape::multigraph}) {
        for (std::uint64_t seed = 1000; seed < 1004; ++seed) {
            SCOPED_TRACE("shape " + std::to_string(static_cast<int>(shape)) + ", seed " + std::to_string(seed));
            Random random(seed, static_cast<std::uint64_t>(shape));
            const std::size_t n = 200 + random.below(300);
            const auto graph = ReverseGraph::from_edges(n, sspql_test::random_edges(random, n, shape, GetParam()));
            compare(graph, sspql_test::random_goals(random, n, GetParam()), queues, tree);
            if (HasFailure()) return;
        }
    }
}

// Offsets from far below the least cost to where they absorb every cost, so that goals come into reach one by one.
TEST_P(ShortestPathsOracle, AgreesWithGoalsAnyDistanceApart) {
    Queues queues;
    ShortestPathTree tree;
    for (const Shape shape : {Shape::sparse, Shape::chain, Shape::disconnected}) {
        for (std::uint64_t seed = 2000; seed < 2060; ++seed) {
            SCOPED_TRACE("shape " + std::to_string(static_cast<int>(shape)) + ", seed " + std::to_string(seed));
            Random random(seed, static_cast<std::uint64_t>(shape));
            const std::size_t n = 1 + random.below(40);
            const auto graph = ReverseGraph::from_edges(n, sspql_test::random_edges(random, n, shape, GetParam()));
            std::vector<Goal> goals;
            for (std::size_t i = 0; i < n; ++i) {
                const double offset = std::pow(10.0, random.uniform(-30.0, 30.0));
                goals.push_back({sspql::state_id(random.below(n)), random.chance(0.2) ? std::floor(offset) : offset});
            }
            compare(graph, goals, queues, tree);
            if (HasFailure()) return;
        }
    }
}

// Distances near 2^53 costs, where sums round and neighbouring keys are as far apart as buckets are wide.
TEST_P(ShortestPathsOracle, AgreesWhereSumsRound) {
    Queues queues;
    ShortestPathTree tree;
    for (std::uint64_t seed = 3000; seed < 3100; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const std::size_t n = 2 + random.below(30);
        const auto graph = ReverseGraph::from_edges(n, sspql_test::random_edges(random, n, Shape::sparse, GetParam()));
        std::vector<Goal> goals;
        for (std::size_t i = 0; i < 4; ++i) {
            const double offset = std::ldexp(random.uniform(0.5, 1.0), 45 + static_cast<int>(random.below(12)));
            goals.push_back({sspql::state_id(random.below(n)), graph.least_cost() * offset});
        }
        compare(graph, goals, queues, tree);
        if (HasFailure()) return;
    }
}
