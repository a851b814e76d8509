// SPDX-License-Identifier: MIT
// How many bytes TransitionCounts holds, and that copies share none of them.
#include <sspql/model/transition_counts.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>

using namespace sspql;

namespace {

/// Random steps on open floor, one in ten slips: 20 a state. \returns the number of distinct (s,a,s').
template <class Cell>
std::size_t walk(TransitionCounts<Cell>& counts, std::size_t columns, std::size_t rows, std::uint64_t seed) {
    Random random(seed);
    std::size_t s = 0;
    std::size_t distinct = 0;
    for (std::size_t i = 0; i < 20 * columns * rows; ++i) {
        if (i % 100 == 0) s = random.below(columns * rows);
        const std::size_t a = random.below(4);
        const std::size_t direction = random.chance(0.1) ? random.below(4) : a;
        const std::size_t x = s % columns, y = s / columns;
        const std::size_t moved[] = {x + 1 < columns ? s + 1 : s, x > 0 ? s - 1 : s, y + 1 < rows ? s + columns : s,
                                     y > 0 ? s - columns : s};
        const std::size_t next = moved[direction];
        if (counts.cell(state_id(s), action_id(a), state_id(next)) == nullptr) ++distinct;
        counts.record(state_id(s), action_id(a), state_id(next));
        s = next;
    }
    return distinct;
}

}  // namespace

// Predecessors, labels, slots and dirty list included, whether the number of states was known or not.
TEST(CountsMemory, ACountedTransitionTakesAtMost36Bytes) {
    TransitionCounts<> counts(40000, 4);
    const std::size_t distinct = walk(counts, 200, 200, 1);
    EXPECT_LE(static_cast<double>(counts.bytes()) / static_cast<double>(distinct), 36.0);
}

TEST(CountsMemory, StatesThatTurnUpOneByOneTakeAQuarterMoreAtMost) {
    TransitionCounts<> known(40000, 4), growing(0, 4);
    for (std::size_t n = 1; n <= 40000; ++n) growing.grow(n);
    EXPECT_LE(growing.bytes(), known.bytes() + known.bytes() / 4);
    EXPECT_GE(growing.bytes(), known.bytes());
}

template <class Cell>
class CountsCopy : public testing::Test {};
using Cells = testing::Types<CountCell, FadingCell>;
TYPED_TEST_SUITE(CountsCopy, Cells, );

// With many successors and predecessors, weights, and many actions: everything there is to copy.
TYPED_TEST(CountsCopy, SharesNothing) {
    for (const std::size_t actions : {3u, 12u}) {
        TransitionCounts<TypeParam> counts(60, actions);
        for (std::size_t k = 0; k < 50; ++k) {
            counts.record(state_id(0), action_id(k % actions), state_id(k), false, 1.0, 2.0);
            counts.record(state_id(k), action_id(0), state_id(59), true);
        }
        TransitionCounts<TypeParam> copy = counts;
        for (std::size_t k = 0; k < 60; ++k) counts.record(state_id(0), action_id(1), state_id(k));
        for (std::size_t k = 0; k < 50; ++k) {
            const ActionId a = action_id(k % actions);
            EXPECT_EQ(copy.n(state_id(0), a, state_id(k)), 1.0) << k;
        }
        EXPECT_EQ(copy.in_degree(state_id(59)), 50u);
        EXPECT_EQ(copy.out_degree(state_id(0)), 51u);
        TransitionCounts<TypeParam> moved = std::move(copy);
        counts = moved;
        EXPECT_EQ(counts.n(state_id(0), action_id(1), state_id(1)), 1.0);
        EXPECT_EQ(counts.out_degree(state_id(0)), 51u);
        EXPECT_EQ(counts.successor(state_id(0), 7).weight(), 2.0);
    }
}
