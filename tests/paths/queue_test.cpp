// SPDX-License-Identifier: MIT
// What every queue must do, against a sorted set.
#include <sspql/paths/queue.hpp>

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/paths/dary_heap.hpp>
#include <sspql/paths/fibonacci_heap.hpp>

#include "paths/queue_pair.hpp"

using sspql::DaryHeap;
using sspql::FibonacciHeap;
using sspql::OperationCounters;
using sspql::Random;
using sspql_test::Pair;

namespace {

/// Keys: reals, or few different ones, so that most are equal.
double draw_key(Random& random, bool few) {
    return few ? static_cast<double>(random.below(4)) : random.uniform(-100.0, 100.0);
}

template <class Queue>
class QueueOf : public testing::Test {};

using Queues = testing::Types<FibonacciHeap<>, DaryHeap<2>, DaryHeap<3>, DaryHeap<4>, DaryHeap<8>,
                              FibonacciHeap<OperationCounters>, DaryHeap<4, OperationCounters>>;

}  // namespace

TYPED_TEST_SUITE(QueueOf, Queues, );

TYPED_TEST(QueueOf, IsAQueue) {
    static_assert(sspql::is_queue_v<TypeParam>);
    static_assert(!sspql::is_queue_v<std::vector<int>>);
    TypeParam queue;
    EXPECT_TRUE(queue.empty());
    queue.prepare(0, 0.0, 0.0);
    EXPECT_TRUE(queue.empty());
}

TYPED_TEST(QueueOf, PopsInOrderUnderRandomOperations) {
    TypeParam queue;  // reused: prepare must clear what an earlier round left
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const std::size_t n = 1 + random.below(120);
        const bool few = random.chance(0.5);
        const double pops = random.uniform(0.1, 0.5);
        Pair<TypeParam> pair(queue, n);
        for (int i = 0; i < 600; ++i) {
            const auto v = static_cast<std::uint32_t>(random.below(n));
            if (!pair.empty() && random.chance(pops)) {
                pair.pop();
            } else if (!pair.queued(v)) {
                pair.push(v, draw_key(random, few));
            } else {
                const double drop = random.chance(0.2) ? 0.0 : draw_key(random, few) + 100.0;
                pair.decrease(v, pair.key(v) - drop);
            }
            if (testing::Test::HasFatalFailure()) return;
        }
        if (seed % 2 == 0) continue;  // what is left inside is the next round's problem
        while (!pair.empty() && !testing::Test::HasFatalFailure()) pair.pop();
    }
}

// As searches do: keys never fall below the last popped one.
TYPED_TEST(QueueOf, PopsInOrderUnderMonotoneOperations) {
    TypeParam queue;
    for (std::uint64_t seed = 500; seed < 530; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const std::size_t n = 400;
        Pair<TypeParam> pair(queue, n);
        pair.push(0, 0.0);
        std::uint32_t fresh = 1;
        while (!pair.empty() && !testing::Test::HasFatalFailure()) {
            const double here = pair.least();
            pair.pop();
            for (int i = 0; i < 3; ++i) {
                if (fresh < n) pair.push(fresh++, here + draw_key(random, false) + 100.0);
                const auto v = static_cast<std::uint32_t>(random.below(n));
                if (pair.queued(v)) pair.decrease(v, random.uniform(here, pair.key(v)));
            }
        }
    }
}

TYPED_TEST(QueueOf, AllKeysEqual) {
    TypeParam queue;
    constexpr std::uint32_t n = 1000;
    Pair<TypeParam> pair(queue, n);
    for (std::uint32_t v = 0; v < n; ++v) pair.push(v, 1.0);
    for (std::uint32_t v = 0; v < n; v += 2) pair.decrease(v, 1.0);
    while (!pair.empty() && !testing::Test::HasFatalFailure()) pair.pop();
}

TYPED_TEST(QueueOf, SmallerThenLargerPrepare) {
    TypeParam queue;
    for (const std::uint32_t n : {10u, 3u, 200u, 1u, 50u}) {
        Pair<TypeParam> pair(queue, n);
        for (std::uint32_t v = 0; v < n; ++v) pair.push(v, static_cast<double>((v * 7) % n));
        while (!pair.empty() && !testing::Test::HasFatalFailure()) pair.pop();
    }
}

TYPED_TEST(QueueOf, HoldsHundredsOfThousands) {
    constexpr std::uint32_t n = 300000;
    TypeParam queue;
    queue.prepare(n, 0.0, 0.0);
    Random random(3);
    std::vector<double> key(n);
    for (std::uint32_t v = 0; v < n; ++v) queue.push(v, key[v] = random.uniform());
    for (std::uint32_t v = 0; v < n; v += 3) queue.decrease(v, key[v] *= 0.5);
    double last = 0.0;
    bool sorted = true;
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t v = queue.pop();
        sorted = sorted && key[v] >= last;
        last = key[v];
        key[v] = -1.0;  // popped twice would show
    }
    EXPECT_TRUE(sorted);
    EXPECT_TRUE(queue.empty());
}
