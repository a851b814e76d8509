// SPDX-License-Identifier: MIT
#include <sspql/learn/backup_queue.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>

namespace sspql_backup_queue_test {

using namespace sspql;

namespace {

constexpr StateId s0{0}, s1{1}, s2{2};
constexpr ActionId a0{0}, a1{1};

void expect_next(BackupQueue& queue, StateId s, ActionId a) {
    ASSERT_FALSE(queue.empty());
    const BackupQueue::Pair pair = queue.pop();
    EXPECT_EQ(pair.state, s);
    EXPECT_EQ(pair.action, a);
}

}  // namespace

TEST(BackupQueue, GivesTheLargestPriorityFirst) {
    BackupQueue queue(3, 2);
    EXPECT_TRUE(queue.empty());
    queue.raise(s0, a1, 0.5);
    queue.raise(s2, a0, 2.0);
    queue.raise(s1, a1, 1.0);
    EXPECT_EQ(queue.size(), 3u);
    expect_next(queue, s2, a0);
    expect_next(queue, s1, a1);
    expect_next(queue, s0, a1);
    EXPECT_TRUE(queue.empty());
}

TEST(BackupQueue, APairIsQueuedOnceWithTheLargestPriorityItWasGiven) {
    BackupQueue queue(3, 2);
    queue.raise(s0, a0, 1.0);
    queue.raise(s0, a1, 2.0);
    queue.raise(s0, a0, 3.0);
    queue.raise(s0, a0, 0.5);
    EXPECT_EQ(queue.size(), 2u);
    expect_next(queue, s0, a0);
    expect_next(queue, s0, a1);
    EXPECT_TRUE(queue.empty());
}

TEST(BackupQueue, APoppedPairStartsAnew) {
    BackupQueue queue(3, 2);
    queue.raise(s0, a0, 3.0);
    expect_next(queue, s0, a0);
    queue.raise(s0, a0, 0.1);
    queue.raise(s1, a0, 0.2);
    expect_next(queue, s1, a0);
    expect_next(queue, s0, a0);
}

TEST(BackupQueue, ClearForgetsPairsAndPriorities) {
    BackupQueue queue(3, 2);
    queue.raise(s0, a0, 3.0);
    queue.raise(s1, a0, 2.0);
    queue.clear();
    EXPECT_TRUE(queue.empty());
    queue.raise(s0, a0, 0.1);
    EXPECT_EQ(queue.size(), 1u);
    queue.clear();
    queue.clear();
    EXPECT_EQ(queue.size(), 0u);
}

TEST(BackupQueue, GrowsWhilePairsWait) {
    BackupQueue queue(0, 2);
    queue.grow(1);
    queue.raise(s0, a1, 1.0);
    queue.grow(3);
    queue.raise(s2, a1, 2.0);
    queue.grow(2);  // fewer changes nothing
    expect_next(queue, s2, a1);
    expect_next(queue, s0, a1);
}

// 20000 random operations on 40 x 3 pairs, distinct priorities, against a search through an array.
TEST(BackupQueue, AgreesWithASearchThroughAllPairs) {
    constexpr std::size_t states = 40, actions = 3;
    BackupQueue queue(states, actions);
    std::vector<double> model(states * actions, 0.0);
    Random random(1);
    for (int k = 0; k < 20000; ++k) {
        if (random.chance(0.55) || queue.empty()) {
            const std::size_t at = random.below(model.size());
            const double priority = 1e-6 + random.uniform();
            queue.raise(state_id(at / actions), action_id(at % actions), priority);
            model[at] = std::max(model[at], priority);
        } else {
            const auto largest = std::max_element(model.begin(), model.end());
            const auto at = static_cast<std::size_t>(largest - model.begin());
            expect_next(queue, state_id(at / actions), action_id(at % actions));
            *largest = 0.0;
        }
        const auto queued = std::count_if(model.begin(), model.end(), [](double p) { return p > 0.0; });
        ASSERT_EQ(queue.size(), static_cast<std::size_t>(queued)) << "operation " << k;
    }
}

}  // namespace sspql_backup_queue_test
