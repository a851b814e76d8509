// SPDX-License-Identifier: MIT
// The complexity that docs/complexity.md claims, counted instead of timed: on every family of graphs, and for growing
// sizes of the one family that tells a Fibonacci heap from a binary one.
#include <sspql/paths/shortest_paths.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/paths/auto_queue.hpp>
#include <sspql/paths/bucket_queue.hpp>
#include <sspql/paths/dary_heap.hpp>
#include <sspql/paths/fibonacci_heap.hpp>
#include <sspql/paths/ring_queue.hpp>

#include "paths/search_families.hpp"

using sspql::OperationCounters;
using sspql::SearchWork;
using sspql::ShortestPathTree;
using sspql_test::SearchCase;

namespace {

using Counts = OperationCounters;
using Fibonacci = sspql::FibonacciHeap<Counts>;
using Binary = sspql::DaryHeap<2, Counts>;
using Ring = sspql::RingQueue<Fibonacci, Counts>;
using Buckets = sspql::BucketQueue<Counts>;

constexpr double golden = 1.6180339887498949;

/// The search of one family with one queue.
template <class Queue>
struct Search {
    explicit Search(const SearchCase& c) { work = shortest_paths_to(c.graph, {{c.goal}}, queue, tree); }

    [[nodiscard]] const Counts& counts() const { return queue.counters(); }
    [[nodiscard]] double greatest_distance() const {
        return *std::max_element(tree.distance.begin(), tree.distance.end());
    }

    Queue queue;
    ShortestPathTree tree;
    SearchWork work;
};

/// m + n log2 n.
double bound(const SearchCase& c) {
    const auto n = static_cast<double>(c.graph.size());
    return static_cast<double>(c.graph.edges()) + n * std::log2(n);
}

double work_of(const Fibonacci& queue) { return static_cast<double>(queue.counters().work()); }
double work_of(const Binary& queue) { return static_cast<double>(queue.counters().work()); }
double work_of(const Buckets& queue) { return static_cast<double>(queue.counters().work()); }
double work_of(const Ring& queue) {
    return static_cast<double>(queue.counters().work() + queue.inner().counters().work());
}

/// Each state is pushed and popped once; every other look at an edge may decrease a key, not more.
void expect_one_visit_each(const Counts& counts, const SearchCase& c) {
    EXPECT_EQ(counts.pushes, c.graph.size());
    EXPECT_EQ(counts.pops, c.graph.size());
    EXPECT_LE(counts.decreases, c.graph.edges() - c.graph.size() + 1);
}

void expect_fibonacci_bounds(const Counts& counts) {
    EXPECT_LE(counts.cuts, 2 * counts.decreases);
    EXPECT_LE(counts.links, counts.pushes + counts.cuts + counts.children);
    EXPECT_LE(static_cast<double>(counts.most_children),
              std::log(static_cast<double>(counts.pushes)) / std::log(golden) + 1e-9);
    EXPECT_EQ(counts.moves, 0u);
}

class QueueCounting : public testing::TestWithParam<std::pair<const char*, SearchCase (*)()>> {};

const std::pair<const char*, SearchCase (*)()> families[] = {
    {"Grid", [] { return sspql_test::grid_case(20000, false); }},
    {"GridOfEqualCosts", [] { return sspql_test::grid_case(20000, true); }},
    {"Random4", [] { return sspql_test::random_case(10000, 4, 1.7); }},
    {"Random16", [] { return sspql_test::random_case(5000, 16, 1.7); }},
    {"SixDecades", [] { return sspql_test::random_case(10000, 4, 6.0); }},
    {"ThirtyDecades", [] { return sspql_test::random_case(5000, 4, 30.0); }},
    {"Star", [] { return sspql_test::star_case(100000); }},
    {"Adversarial", [] { return sspql_test::adversarial_case(3000, 64); }},
};

}  // namespace

INSTANTIATE_TEST_SUITE_P(Families, QueueCounting, testing::ValuesIn(families),
                         [](const auto& family) { return std::string(family.param.first); });

TEST_P(QueueCounting, FibonacciHeapKeepsItsBounds) {
    const SearchCase c = GetParam().second();
    const Search<Fibonacci> search(c);
    expect_one_visit_each(search.counts(), c);
    expect_fibonacci_bounds(search.counts());
    EXPECT_LE(work_of(search.queue), 8.0 * bound(c));
}

TEST_P(QueueCounting, RingKeepsTheBoundsOfItsInnerHeap) {
    const SearchCase c = GetParam().second();
    const Search<Ring> search(c);
    expect_one_visit_each(search.counts(), c);
    const Counts& inner = search.queue.inner().counters();
    EXPECT_EQ(inner.pushes, c.graph.size()) << "into the heap once each";
    EXPECT_EQ(inner.pops, c.graph.size());
    EXPECT_LE(inner.decreases, search.counts().decreases);
    expect_fibonacci_bounds(inner);
    EXPECT_LE(search.counts().moves, search.counts().pushes + search.counts().decreases)
        << "an entry for each, no more";
    EXPECT_LE(search.counts().buckets, search.counts().moves + 1);
    EXPECT_LE(work_of(search.queue), 8.0 * bound(c));
}

TEST_P(QueueCounting, BucketsAreOpenedOnceAndNoStateTwice) {
    const SearchCase c = GetParam().second();
    const Search<Buckets> search(c);
    expect_one_visit_each(search.counts(), c);
    EXPECT_EQ(search.counts().rescans, 0u) << "nobody's path gets shorter within a bucket";
    EXPECT_EQ(search.work.states, c.graph.size());
    EXPECT_EQ(search.counts().comparisons, 0u);
    const double steps = search.greatest_distance() / (c.graph.least_cost() * (1.0 - 1e-6)) + 1.0;
    EXPECT_LE(static_cast<double>(search.counts().buckets), steps);
    EXPECT_LE(search.counts().buckets, search.counts().pushes + search.counts().decreases) << "empty ones are skipped";
    EXPECT_LE(work_of(search.queue), static_cast<double>(c.graph.edges()) + 1.0 + steps);
}

TEST_P(QueueCounting, EveryQueueFindsTheSameTree) {
    const SearchCase c = GetParam().second();
    const Search<Fibonacci> expected(c);
    const auto compare = [&](const ShortestPathTree& tree, const char* name) {
        EXPECT_TRUE(tree.distance == expected.tree.distance) << name;
        EXPECT_TRUE(tree.next == expected.tree.next) << name;
    };
    compare(Search<Binary>(c).tree, "binary heap");
    compare(Search<sspql::DaryHeap<4>>(c).tree, "4-ary heap");
    compare(Search<Buckets>(c).tree, "buckets");
    compare(Search<Ring>(c).tree, "ring over a Fibonacci heap");
    compare(Search<sspql::RingQueue<sspql::DaryHeap<4>>>(c).tree, "ring over a 4-ary heap");
    compare(Search<sspql::AutoQueue<>>(c).tree, "the automatic choice");
}

TEST(QueueCountingAutoQueue, TakesBucketsForLearntCostsAndTheRingForWideOnes) {
    using Auto = sspql::AutoQueue<Counts>;
    const Search<Auto> learnt(sspql_test::grid_case(400, false));
    EXPECT_EQ(learnt.queue.buckets().counters().pops, 400u);
    EXPECT_EQ(learnt.queue.ring().counters().pops, 0u);
    const Search<Auto> wide(sspql_test::random_case(400, 4, 30.0));
    EXPECT_EQ(wide.queue.buckets().counters().pops, 0u);
    EXPECT_EQ(wide.queue.ring().counters().pops, 400u);
}

// Ten times the states at the same m / n: work / (m + n log2 n) stays where it is for O(m + n log n) and grows with the
// logarithm for O(m log n), of which the binary heap is the proof.
TEST(QueueCountingSlow, OnlyDecreasesOfConstantCostScaleOnTheAdversarialFamily) {
    const SearchCase small = sspql_test::adversarial_case(10000, 64);
    const SearchCase large = sspql_test::adversarial_case(100000, 64);
    const auto growth = [&](auto queue) {
        using Queue = decltype(queue);
        const double before = work_of(Search<Queue>(small).queue) / bound(small);
        const double after = work_of(Search<Queue>(large).queue) / bound(large);
        EXPECT_GT(before, 0.5) << "the family asks for work";
        return after / before;
    };
    EXPECT_LT(growth(Fibonacci()), 1.05);
    EXPECT_LT(growth(Ring()), 1.05);
    EXPECT_GT(growth(Binary()), 1.25);
}
