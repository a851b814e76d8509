// SPDX-License-Identifier: MIT
// After reserve(), recording does not allocate.
#include <sspql/model/transition_counts.hpp>

#include <cstddef>

#include <gtest/gtest.h>

#include "counting_new.hpp"

using sspql::action_id;
using sspql::CountCell;
using sspql::FadingCell;
using sspql::state_id;
using sspql::TransitionCounts;
using sspql_test::allocations;

namespace {

template <class Cell>
class AllocationOf : public testing::Test {};

using Cells = testing::Types<CountCell, FadingCell>;

}  // namespace

TEST(Allocation, IsCounted) {
    const std::size_t before = allocations;
    delete new int(1);
    void* volatile memory = ::operator new(8);
    ::operator delete(memory);
    EXPECT_GE(allocations, before + 1);
}

TYPED_TEST_SUITE(AllocationOf, Cells, );

// All states get their next successor before any gets the one after that: the worst case, in which no block that was
// outgrown finds another taker.
TYPED_TEST(AllocationOf, RecordAfterReserveNever) {
    constexpr std::size_t states = 64;
    for (std::size_t degree = 1; degree <= 32; ++degree) {
        TransitionCounts<TypeParam> counts(states, 4);
        counts.reserve(states, states * degree);
        const std::size_t bytes = counts.bytes();
        const std::size_t before = allocations;
        for (std::size_t k = 0; k < degree; ++k) {
            for (std::size_t s = 0; s < states; ++s) {
                counts.record(state_id(s), action_id(k % 4), state_id((s + k) % states), k == 3, 1.0);
            }
        }
        const std::size_t after = allocations;
        EXPECT_EQ(after - before, 0u) << "degree " << degree;
        EXPECT_EQ(counts.bytes(), bytes) << "degree " << degree;
        EXPECT_EQ(counts.pairs(), states * degree);
    }
}

// A goal has many predecessors, however few successors its predecessors have.
TYPED_TEST(AllocationOf, ManyPredecessorsNeedNone) {
    constexpr std::size_t states = 1000;
    for (std::size_t goals = 1; goals <= 32; ++goals) {
        TransitionCounts<TypeParam> counts(states, 2);
        counts.reserve(states, states * goals);
        const std::size_t bytes = counts.bytes();
        const std::size_t before = allocations;
        for (std::size_t s = 0; s < states; ++s) {
            for (std::size_t goal = 0; goal < goals; ++goal) counts.record(state_id(s), action_id(0), state_id(goal));
        }
        const std::size_t after = allocations;
        EXPECT_EQ(after - before, 0u) << goals << " goals";
        EXPECT_EQ(counts.bytes(), bytes) << goals << " goals";
    }
}

TYPED_TEST(AllocationOf, GrowingUpToTheReserveNever) {
    TransitionCounts<TypeParam> counts(0, 3);
    counts.reserve(500, 2000);
    const std::size_t bytes = counts.bytes();
    const std::size_t before = allocations;
    for (std::size_t s = 0; s < 500; ++s) {
        counts.grow(s + 1);
        for (std::size_t k = 0; k < 4 && k <= s; ++k) counts.record(state_id(s), action_id(0), state_id(s - k));
    }
    const std::size_t after = allocations;
    EXPECT_EQ(after - before, 0u);
    EXPECT_EQ(counts.bytes(), bytes);
}

// Weights live in two arrays that only exist once there are any.
TYPED_TEST(AllocationOf, WeightsNeedTwoArraysAtMost) {
    constexpr std::size_t states = 200;
    TransitionCounts<TypeParam> counts(states, 3);
    counts.reserve(states, states * 4);
    const std::size_t before = allocations;
    for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t s = 0; s < states; ++s) {
            counts.record(state_id(s), action_id(0), state_id((s + k) % states), false, 0.0, 2.0);
        }
    }
    const std::size_t after = allocations;
    EXPECT_LE(after - before, 2u);
}

TYPED_TEST(AllocationOf, RepeatedRecordsNeverEvenWithoutReserve) {
    TransitionCounts<TypeParam> counts(3, 12);
    for (std::size_t a = 0; a < 12; ++a) counts.record(state_id(0), action_id(a), state_id(1));
    const std::size_t bytes = counts.bytes();
    const std::size_t before = allocations;
    for (std::size_t i = 0; i < 1000; ++i) counts.record(state_id(0), action_id(i % 12), state_id(1));
    const std::size_t after = allocations;
    EXPECT_EQ(after - before, 0u);
    EXPECT_EQ(counts.bytes(), bytes);
}
