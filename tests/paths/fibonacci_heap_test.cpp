// SPDX-License-Identifier: MIT
// The bounds behind O(m + n log n), counted exactly.
#include <sspql/paths/fibonacci_heap.hpp>

#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/paths/dary_heap.hpp>

using sspql::DaryHeap;
using sspql::FibonacciHeap;
using sspql::OperationCounters;
using sspql::Random;

namespace {

constexpr double golden = 1.6180339887498949;

/// Fills a queue of n, then decreases a few keys between pops until it is empty.
template <class Queue>
void exercise(Queue& queue, std::size_t n, std::size_t decreases_per_pop, std::uint64_t seed) {
    Random random(seed);
    queue.prepare(n);
    std::vector<double> key(n);
    std::vector<bool> queued(n, true);
    for (std::uint32_t v = 0; v < n; ++v) queue.push(v, key[v] = random.uniform(1.0, 2.0));
    while (!queue.empty()) {
        queued[queue.pop()] = false;
        for (std::size_t i = 0; i < decreases_per_pop; ++i) {
            const auto v = static_cast<std::uint32_t>(random.below(n));
            if (queued[v]) queue.decrease(v, key[v] *= random.uniform(0.5, 1.0));
        }
    }
}

}  // namespace

// A decrease cuts at most one subtree itself and marks at most one node; a cascade cuts marked nodes only.
// A pop makes at most log_phi(n) children roots; a link takes one root away.
TEST(FibonacciHeapCounters, CutsAndLinksStayWithinTheirBounds) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const std::size_t n = 50 + 100 * seed;
        FibonacciHeap<OperationCounters> heap;
        exercise(heap, n, seed % 12, seed);
        const OperationCounters& count = heap.counters();
        EXPECT_EQ(count.pushes, n);
        EXPECT_EQ(count.pops, n);
        EXPECT_LE(count.cuts, 2 * count.decreases);
        const double degree = std::floor(std::log(static_cast<double>(n)) / std::log(golden));
        EXPECT_LE(static_cast<double>(count.links),
                  static_cast<double>(count.pushes + count.cuts) + degree * static_cast<double>(count.pops));
        EXPECT_EQ(count.moves, 0u) << "nodes stay where they are";
    }
}

TEST(FibonacciHeapCounters, WorkIsLinearInDecreasesAndLogarithmicInPops) {
    for (const std::size_t n : {100u, 1000u, 10000u, 100000u}) {
        SCOPED_TRACE("n " + std::to_string(n));
        FibonacciHeap<OperationCounters> heap;
        exercise(heap, n, 4, n);
        const double size = static_cast<double>(n);
        const double bound = static_cast<double>(heap.counters().decreases) + size * std::log2(size);
        EXPECT_LE(static_cast<double>(heap.counters().work()), 8.0 * bound);
    }
}

// Pushing, and decreasing roots, costs one comparison each: O(1), not amortised.
TEST(FibonacciHeapCounters, PushAndDecreaseOfRootsAreConstant) {
    FibonacciHeap<OperationCounters> heap;
    constexpr std::uint32_t n = 10000;
    heap.prepare(n);
    for (std::uint32_t v = 0; v < n; ++v) heap.push(v, 1.0 + v);
    for (std::uint32_t v = 0; v < n; ++v) heap.decrease(v, 0.5 + v);
    EXPECT_EQ(heap.counters().comparisons, 2u * n - 1u);
    EXPECT_EQ(heap.counters().cuts, 0u);
}

// 2^20 equal keys join to trees of degree up to 20: within the array of degree_bound.
TEST(FibonacciHeapCounters, DegreesStayWithinTheBound) {
    const double most = std::log(4294967296.0) / std::log(golden);
    EXPECT_GT(FibonacciHeap<>::degree_bound, std::floor(most) + 1);
    constexpr std::uint32_t n = (1u << 18) + 1u;
    FibonacciHeap<OperationCounters> heap;
    heap.prepare(n);
    for (std::uint32_t v = 0; v < n; ++v) heap.push(v, 1.0);
    static_cast<void>(heap.pop());
    EXPECT_EQ(heap.counters().links, n - 2) << "2^18 roots became one tree";
    static_cast<void>(heap.pop());
    EXPECT_EQ(heap.counters().links, n - 2) << "its children are of 18 different degrees";
    EXPECT_EQ(heap.size(), n - 2);
}

// A sift goes down at most floor(log_D n) levels with D comparisons on each, and up as many with one.
TEST(DaryHeapCounters, OperationsStayWithinTheHeight) {
    for (const std::size_t n : {10u, 100u, 5000u}) {
        SCOPED_TRACE("n " + std::to_string(n));
        DaryHeap<4, OperationCounters> heap;
        exercise(heap, n, 3, n);
        const OperationCounters& count = heap.counters();
        EXPECT_EQ(count.pushes, n);
        EXPECT_EQ(count.pops, n);
        const double height = std::floor(std::log2(static_cast<double>(n)) / 2.0) + 1.0;
        EXPECT_LE(static_cast<double>(count.comparisons),
                  height * static_cast<double>(count.pushes + count.decreases + 4 * count.pops));
        EXPECT_EQ(count.links + count.cuts, 0u);
    }
}

TEST(QueueCounters, CostNothingWhenEmpty) {
    static_assert(sizeof(FibonacciHeap<OperationCounters>) > sizeof(FibonacciHeap<>));
    static_assert(sizeof(DaryHeap<4, sspql::NoCounters>) == 2 * sizeof(std::vector<int>));
}
