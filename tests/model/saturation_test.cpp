// SPDX-License-Identifier: MIT
// Counts that reach their limit are halved, never wrapped.
#include <sspql/model/transition_counts.hpp>

#include <cstdint>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/model/cells.hpp>
#include <sspql/model/probability.hpp>

using sspql::ActionId;
using sspql::BasicCountCell;
using sspql::CountCell;
using sspql::state_id;
using sspql::StateId;
using sspql::TransitionCounts;

namespace {

constexpr ActionId a0{0}, a1{1};
constexpr StateId s0{0}, s1{1}, s2{2}, s3{3};

}  // namespace

// Limit 8: the ninth record first halves 8 to 4, then counts to 5.
TEST(Saturation, HalvesWhenTheLimitIsReached) {
    TransitionCounts<BasicCountCell<8>> counts(2, 1);
    for (int i = 0; i < 8; ++i) counts.record(s0, a0, s1);
    EXPECT_EQ(counts.n(s0, a0), 8u);
    counts.record(s0, a0, s1);
    EXPECT_EQ(counts.n(s0, a0), 5u);
    EXPECT_EQ(counts.n(s0, a0, s1), 5u);
}

// Limit 8 with 5 to s1, 2 to s2, 1 to s3: halved upwards 3, 1, 1; then one more to s3.
TEST(Saturation, HalvesAllOutcomesOfTheActionAndForgetsNone) {
    TransitionCounts<BasicCountCell<8>> counts(4, 2);
    for (int i = 0; i < 5; ++i) counts.record(s0, a0, s1);
    for (int i = 0; i < 2; ++i) counts.record(s0, a0, s2);
    counts.record(s0, a0, s3);
    for (int i = 0; i < 3; ++i) counts.record(s0, a1, s1);
    counts.record(s0, a0, s3, true);
    EXPECT_EQ(counts.n(s0, a0, s1), 3u);
    EXPECT_EQ(counts.n(s0, a0, s2), 1u);
    EXPECT_EQ(counts.n(s0, a0, s3), 2u);
    EXPECT_EQ(counts.n(s0, a0), 6u);
    EXPECT_EQ(counts.n(s0, a1), 3u) << "other actions keep theirs";
    EXPECT_TRUE(counts.cell(s0, a0, s3)->terminal());
}

TEST(Saturation, KeepsTheTerminalFlag) {
    TransitionCounts<BasicCountCell<4>> counts(3, 1);
    counts.record(s0, a0, s1, true);
    for (int i = 0; i < 40; ++i) counts.record(s0, a0, s2);
    EXPECT_TRUE(counts.cell(s0, a0, s1)->terminal());
    EXPECT_GE(counts.n(s0, a0, s1), 1u);
}

// 7 : 2 : 1 in turn, for a hundred times the limit. Rounding up adds at most 1/2 for each outcome and halving.
TEST(Saturation, KeepsProbabilities) {
    TransitionCounts<BasicCountCell<1000>> counts(4, 1);
    const StateId outcome[] = {s1, s1, s2, s1, s1, s3, s1, s2, s1, s1};
    for (int i = 0; i < 100000; ++i) {
        counts.record(s0, a0, outcome[i % 10]);
        ASSERT_LE(counts.n(s0, a0), 1000u);
    }
    EXPECT_NEAR(sspql::probability(counts, s0, a0, s1), 0.7, 0.01);
    EXPECT_NEAR(sspql::probability(counts, s0, a0, s2), 0.2, 0.01);
    EXPECT_NEAR(sspql::probability(counts, s0, a0, s3), 0.1, 0.01);
}

// As many outcomes as the limit: halving cannot make room, the total outgrows the limit but stays the sum of its parts.
TEST(Saturation, MoreOutcomesThanTheLimitStillAddUp) {
    TransitionCounts<BasicCountCell<2>> counts(50, 12);
    sspql::Random random(7);
    for (int i = 0; i < 3000; ++i) {
        counts.record(s0, ActionId{11}, state_id(random.below(50)), random.chance(0.5));
        std::uint64_t sum = 0;
        counts.for_each_successor(s0, [&](const auto& successor) {
            const std::uint32_t n = successor.n(ActionId{11});
            EXPECT_GE(n, 1u);
            EXPECT_LE(n, 2u);
            sum += n;
        });
        ASSERT_EQ(counts.n(s0, ActionId{11}), sum) << "seed 7, record " << i;
    }
}

TEST(Saturation, TheDefaultLimitIsThirtyOneBits) {
    EXPECT_EQ(CountCell::limit, 0x7FFFFFFFu);
    EXPECT_EQ(sizeof(CountCell), 4u);
    using Largest = BasicCountCell<0x7FFFFFFFu>;
    Largest cell;
    EXPECT_EQ(cell.count(), 0u);
    cell.add(0.0, true);
    EXPECT_EQ(cell.count(), 1u);
    EXPECT_TRUE(cell.terminal());
    cell.halve();
    EXPECT_EQ(cell.count(), 1u) << "nothing observed is forgotten";
    EXPECT_TRUE(cell.terminal());
}
