// SPDX-License-Identifier: MIT
// Our queues under Boost.Graph's search.
#include <sspql/paths/boost_graph.hpp>
#include <sspql/paths/boost_queue.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/buffer_concepts.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <sspql/core/random.hpp>
#include <sspql/paths/auto_queue.hpp>
#include <sspql/paths/bucket_queue.hpp>
#include <sspql/paths/dary_heap.hpp>
#include <sspql/paths/fibonacci_heap.hpp>
#include <sspql/paths/ring_queue.hpp>
#include <sspql/paths/shortest_paths.hpp>

#include "paths/random_graph.hpp"
#include "paths/search_families.hpp"

using namespace sspql;
using sspql_test::Costs;
using sspql_test::SearchCase;
using sspql_test::Shape;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What a search found.
struct Found {
    explicit Found(std::size_t n) : distance(n), predecessor(n) {}

    template <class Values, class Graph>
    static auto map(Values& values, const Graph& graph) {
        return boost::make_iterator_property_map(values.begin(), get(boost::vertex_index, graph));
    }

    std::vector<double> distance;
    std::vector<std::size_t> predecessor;
};

template <class Graph, class Queue>
Found found_with(const Graph& graph, std::size_t start, Queue& queue) {
    Found found(num_vertices(graph));
    dijkstra_with_queue(graph, start, queue, get(boost::edge_weight, graph), Found::map(found.distance, graph),
                        Found::map(found.predecessor, graph));
    return found;
}

template <class Graph>
Found found_by_boost(const Graph& graph, std::size_t start) {
    Found found(num_vertices(graph));
    boost::dijkstra_shortest_paths(graph, start,
                                   boost::weight_map(get(boost::edge_weight, graph))
                                       .distance_map(Found::map(found.distance, graph))
                                       .predecessor_map(Found::map(found.predecessor, graph))
                                       .distance_inf(infinity));
    return found;
}

/// Each predecessor explains its vertex's distance, to the last bit, and a way back to the start has no cycle.
void expect_tree(const ReverseGraph& graph, std::size_t start, const Found& found) {
    std::vector<bool> explained(graph.size(), false);
    for (std::size_t v = 0; v < graph.size(); ++v) {
        graph.for_each_predecessor(state_id(v), [&](StateId u, double cost) {
            if (found.predecessor[index(u)] == v && found.distance[v] + cost == found.distance[index(u)]) {
                explained[index(u)] = true;
            }
        });
    }
    for (std::size_t s = 0; s < graph.size(); ++s) {
        const bool alone = s == start || found.distance[s] == infinity;
        ASSERT_EQ(found.predecessor[s] == s, alone) << "state " << s;
        if (alone) continue;
        ASSERT_TRUE(explained[s]) << "state " << s;
        std::size_t steps = 0;
        for (std::size_t v = s; v != start; v = found.predecessor[v]) ASSERT_LE(++steps, graph.size()) << "a cycle";
    }
}

template <class Queue>
void expect_same(const SearchCase& c, Queue& queue) {
    const std::size_t start = index(c.goal);
    const Found found = found_with(c.graph, start, queue);
    EXPECT_EQ(found.distance, found_by_boost(c.graph, start).distance);
    EXPECT_EQ(found.distance, shortest_paths_to(c.graph, {{c.goal}}).distance);
    expect_tree(c.graph, start, found);
    EXPECT_TRUE(queue.empty());
}

template <class Queue>
class BoostQueueOf : public testing::Test {};

using Queues = testing::Types<FibonacciHeap<>, DaryHeap<4>, BucketQueue<>, RingQueue<>, AutoQueue<>>;

using Distances = decltype(Found::map(std::declval<std::vector<double>&>(), ReverseGraph()));
BOOST_CONCEPT_ASSERT((boost::UpdatableQueueConcept<BoostQueue<FibonacciHeap<>, Distances>>));
BOOST_CONCEPT_ASSERT((boost::UpdatableQueueConcept<BoostQueue<AutoQueue<>, Distances>>));

}  // namespace

TYPED_TEST_SUITE(BoostQueueOf, Queues, );

TYPED_TEST(BoostQueueOf, FindsBoostsDistancesOnRandomGraphs) {
    TypeParam queue;  // reused
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        for (const Shape shape : sspql_test::shapes) {
            for (const Costs costs : sspql_test::cost_kinds) {
                SCOPED_TRACE("seed " + std::to_string(seed) + ", shape " + std::to_string(static_cast<int>(shape)) +
                             ", costs " + std::to_string(static_cast<int>(costs)));
                Random random(seed);
                const std::size_t n = 2 + random.below(50);
                const std::size_t start = random.below(n);
                expect_same({ReverseGraph::from_edges(n, random_edges(random, n, shape, costs)), state_id(start)},
                            queue);
                if (testing::Test::HasFailure()) return;
            }
        }
    }
}

TYPED_TEST(BoostQueueOf, FindsBoostsDistancesOnFamiliesOfGraphs) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const SearchCase cases[] = {sspql_test::grid_case(2000, false, seed),
                                    sspql_test::grid_case(500, true, seed),
                                    shuffled(sspql_test::grid_case(1000, false, seed), seed),
                                    sspql_test::random_case(1000, 4, 1.74, seed),
                                    sspql_test::random_case(500, 4, 6.0, seed),
                                    sspql_test::star_case(1000, seed),
                                    sspql_test::adversarial_case(300, 16, seed)};
        TypeParam queue;
        for (const SearchCase& c : cases) expect_same(c, queue);
    }
}

// Costs that a queue's buckets cannot tell apart, and none at all.
TYPED_TEST(BoostQueueOf, FindsBoostsDistancesAcrossEdgesThatAreFree) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        using Edges = boost::property<boost::edge_weight_t, double>;
        boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property, Edges> graph(60);
        for (int i = 0; i < 240; ++i) {
            const std::size_t from = random.below(60);
            const std::size_t to = random.below(60);
            add_edge(from, to, random.chance(0.3) ? 0.0 : random.uniform(), graph);
        }
        TypeParam queue;
        EXPECT_EQ(found_with(graph, 0, queue).distance, found_by_boost(graph, 0).distance);
    }
}

TYPED_TEST(BoostQueueOf, IsAnUpdatableQueue) {
    std::vector<double> distance{5.0, 3.0, 4.0, 6.0};
    const ReverseGraph graph = ReverseGraph::from_edges(4, {});
    const auto map = Found::map(distance, graph);
    TypeParam inner;
    BoostQueue<TypeParam, std::decay_t<decltype(map)>> queue(inner, 4, map, 1.0, 10.0);
    EXPECT_TRUE(queue.empty());
    for (std::size_t v = 0; v < 3; ++v) queue.push(v);
    EXPECT_EQ(queue.size(), 3u);
    EXPECT_TRUE(queue.contains(0));
    EXPECT_FALSE(queue.contains(3));
    distance[0] = 1.5;
    queue.update(0);
    EXPECT_EQ(queue.top(), 0u);
    EXPECT_EQ(queue.top(), 0u) << "looking takes nothing away";
    EXPECT_TRUE(queue.contains(0));
    EXPECT_EQ(queue.size(), 3u);
    queue.pop();
    EXPECT_FALSE(queue.contains(0));
    queue.push(3);
    for (const std::size_t expected : {1u, 2u, 3u}) {
        ASSERT_EQ(queue.size(), 4u - expected);
        queue.pop();  // without a look
        EXPECT_FALSE(queue.contains(expected));
    }
    EXPECT_TRUE(queue.empty());
}

TEST(BoostQueue, RefusesWeightsNoSearchCanTake) {
    using Edges = boost::property<boost::edge_weight_t, double>;
    for (const double weight : {-1.0, infinity, std::numeric_limits<double>::quiet_NaN()}) {
        boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property, Edges> graph(2);
        add_edge(0, 1, weight, graph);
        AutoQueue<> queue;
        EXPECT_THROW(found_with(graph, 0, queue), std::invalid_argument) << weight;
    }
}
