// SPDX-License-Identifier: MIT
// The queues that take monotone keys only, against a sorted set: the way searches use them, and at the edges of it.
#include <sspql/paths/auto_queue.hpp>
#include <sspql/paths/bucket_queue.hpp>
#include <sspql/paths/ring_queue.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/paths/dary_heap.hpp>
#include <sspql/paths/fibonacci_heap.hpp>

#include "paths/queue_pair.hpp"

using sspql::AutoQueue;
using sspql::BucketQueue;
using sspql::DaryHeap;
using sspql::FibonacciHeap;
using sspql::OperationCounters;
using sspql::Random;
using sspql::RingQueue;
using sspql_test::Pair;

namespace {

/// Pushes vertices in order and decreases others, up to `greatest` above the last popped key. Buckets may pop a key
/// that is larger than the least by less than the least cost.
template <class Queue>
void simulate(Queue& queue, std::uint64_t seed, double least, double greatest) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    constexpr std::size_t n = 400;
    Pair<Queue> pair(queue, n, least, greatest);
    const double slack = sspql::corrects_labels_v<Queue> ? least : 0.0;
    std::uint32_t fresh = 0;
    const std::uint64_t goals = 1 + random.below(5);
    for (std::uint64_t i = 0; i < goals; ++i)
        pair.push(fresh++, std::floor(random.uniform(0.0, 4.0)) * greatest * 100.0);
    while (!pair.empty() && !testing::Test::HasFatalFailure()) {
        const double here = pair.least() + slack;  // no smaller than the key popped
        pair.pop(slack);
        for (int i = 0; i < 3; ++i) {
            if (fresh < n) pair.push(fresh++, here + random.uniform(least, greatest));
            const auto v = static_cast<std::uint32_t>(random.below(n));
            const double key = here + random.uniform(least, greatest);
            if (pair.queued(v) && key <= pair.key(v)) pair.decrease(v, key);
            if (pair.queued(v) && random.chance(0.1)) pair.decrease(v, pair.key(v));
        }
    }
    EXPECT_TRUE(queue.empty());
}

template <class Queue>
class MonotoneQueueOf : public testing::Test {};

using Queues =
    testing::Types<BucketQueue<>, RingQueue<>, RingQueue<DaryHeap<4>>, AutoQueue<>, BucketQueue<OperationCounters>,
                   AutoQueue<OperationCounters>, RingQueue<FibonacciHeap<OperationCounters>, OperationCounters>>;

}  // namespace

TYPED_TEST_SUITE(MonotoneQueueOf, Queues, );

TYPED_TEST(MonotoneQueueOf, IsAQueueAndSaysSo) {
    static_assert(sspql::is_queue_v<TypeParam>);
    static_assert(sspql::is_monotone_only_v<TypeParam>);
    TypeParam queue;
    EXPECT_TRUE(queue.empty());
    queue.prepare(0, 0.0, 0.0);
    EXPECT_TRUE(queue.empty());
}

TYPED_TEST(MonotoneQueueOf, PopsInOrderAsSearchesUseIt) {
    TypeParam queue;  // reused: prepare must clear what an earlier round left
    for (std::uint64_t seed = 0; seed < 40; ++seed) simulate(queue, seed, 1.0, 5.0);
    for (std::uint64_t seed = 100; seed < 110; ++seed) simulate(queue, seed, 1.0, 1.0);
    for (std::uint64_t seed = 200; seed < 210; ++seed) simulate(queue, seed, 1e-6, 1.0);
    for (std::uint64_t seed = 300; seed < 310; ++seed) simulate(queue, seed, 1e-300, 1e300);
}

TYPED_TEST(MonotoneQueueOf, KeysAnyDistanceApartComeOutInOrder) {
    const double keys[] = {0.0, 1e-30, 1.0, 1.5, 2000.0, 1e9, 1e9 + 1.0, 1e18, 1e100, 1e300};
    TypeParam queue;
    constexpr std::uint32_t n = 10;
    for (const double greatest : {1.0, 1000.0, 1e12}) {
        Pair<TypeParam> pair(queue, n, 1.0, greatest);
        for (std::uint32_t i = 0; i < n; ++i) pair.push((i * 7) % n, keys[(i * 7) % n]);
        while (!pair.empty() && !testing::Test::HasFatalFailure()) pair.pop(1.0);
    }
}

TYPED_TEST(MonotoneQueueOf, FarKeysDecreaseWithinReachAndBeyond) {
    TypeParam queue;
    Pair<TypeParam> pair(queue, 5, 1.0, 2.0);
    pair.push(0, 0.0);
    pair.push(1, 1e6);
    pair.push(2, 1e6);
    pair.push(3, 2e6);
    pair.decrease(1, 9e5);
    pair.pop();
    pair.decrease(1, 8e5);  // beyond
    pair.decrease(2, 1.5);  // within
    pair.push(4, 1e7);
    pair.decrease(4, 7e5);
    for (int i = 0; i < 4 && !testing::Test::HasFatalFailure(); ++i) pair.pop();
    EXPECT_TRUE(queue.empty());
}

TYPED_TEST(MonotoneQueueOf, ForgetsWhatAnAbandonedSearchLeft) {
    TypeParam queue;
    for (const double greatest : {3.0, 1e6, 3.0}) {
        queue.prepare(100, 1.0, greatest);
        for (std::uint32_t v = 0; v < 100; ++v) queue.push(v, v);
        static_cast<void>(queue.pop());
        Pair<TypeParam> pair(queue, 50, 1.0, greatest);
        EXPECT_TRUE(queue.empty());
        for (std::uint32_t v = 0; v < 50; ++v) pair.push(v, 50.0 - v);
        while (!pair.empty() && !testing::Test::HasFatalFailure()) pair.pop(1.0);
    }
}

TYPED_TEST(MonotoneQueueOf, WithoutCostsEveryKeyFitsOneBucket) {
    TypeParam queue;
    queue.prepare(3, 0.0, 0.0);
    queue.push(2, 7.0);
    queue.push(0, 1e300);
    queue.push(1, 0.0);
    std::vector<bool> popped(3, false);
    while (!queue.empty()) popped[queue.pop()] = true;
    EXPECT_EQ(popped, std::vector<bool>(3, true));
}

TEST(AutoQueue, TakesBucketsUpToARatioOf1024) {
    AutoQueue<> queue;
    queue.prepare(10, 1.0, 1024.0);
    EXPECT_TRUE(queue.uses_buckets());
    queue.prepare(10, 1.0, 1025.0);
    EXPECT_FALSE(queue.uses_buckets());
    queue.prepare(10, 1e-30, 1.0);
    EXPECT_FALSE(queue.uses_buckets());
    queue.prepare(10, 1e-300, 1e-300);
    EXPECT_TRUE(queue.uses_buckets());
    queue.prepare(10, 0.0, 0.0);
    EXPECT_TRUE(queue.uses_buckets());
}

// A popped vertex that gets nearer still is queued again; what it stands for is counted.
TEST(BucketQueue, TakesPoppedVerticesBack) {
    BucketQueue<OperationCounters> queue;
    static_assert(sspql::corrects_labels_v<BucketQueue<>> && !sspql::corrects_labels_v<RingQueue<>>);
    queue.prepare(3, 10.0, 10.0);  // a wrong hint: the costs below are smaller
    queue.push(0, 0.0);
    EXPECT_EQ(queue.pop(), 0u);
    queue.push(2, 1.0);
    queue.push(1, 2.0);
    EXPECT_EQ(queue.pop(), 1u) << "the last of a bucket first";
    queue.decrease(1, 1.5);
    EXPECT_EQ(queue.counters().rescans, 1u);
    EXPECT_EQ(queue.size(), 2u);
    EXPECT_EQ(queue.pop(), 1u);
    EXPECT_EQ(queue.pop(), 2u);
    EXPECT_TRUE(queue.empty());
}

TEST(BucketQueue, KnowsWhatIsUpcoming) {
    BucketQueue<> queue;
    queue.prepare(5, 1.0, 1.0);
    queue.push(0, 0.0);
    static_cast<void>(queue.pop());
    EXPECT_EQ(queue.upcoming(0), sspql::no_vertex);
    for (std::uint32_t v = 1; v < 5; ++v) queue.push(v, 0.5);
    EXPECT_EQ(queue.upcoming(4), sspql::no_vertex);
    std::vector<std::uint32_t> promised;
    for (std::size_t k = 0; k < 4; ++k) promised.push_back(queue.upcoming(k));
    for (const std::uint32_t vertex : promised) EXPECT_EQ(queue.pop(), vertex);
}
