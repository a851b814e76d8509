// SPDX-License-Identifier: MIT
// The mean observed weight of a transition (weight(s,s') of eq. 2).
#include <sspql/model/transition_counts.hpp>

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

using sspql::ActionId;
using sspql::CountCell;
using sspql::FadingCell;
using sspql::state_id;
using sspql::StateId;
using sspql::TransitionCounts;

namespace {

constexpr ActionId a0{0}, a1{1};
constexpr StateId s0{0}, s1{1}, s2{2};

template <class Counts>
double weight(const Counts& counts, StateId s, StateId next) {
    double found = -1.0;
    counts.for_each_successor(s, [&](const auto& successor) {
        if (successor.state() == next) found = successor.weight();
    });
    return found;
}

template <class Cell>
class Weights : public testing::Test {};

using Cells = testing::Types<CountCell, FadingCell>;

}  // namespace

TYPED_TEST_SUITE(Weights, Cells, );

TYPED_TEST(Weights, AreOneUnlessGiven) {
    TransitionCounts<TypeParam> counts(2, 1);
    counts.record(s0, a0, s1);
    EXPECT_EQ(weight(counts, s0, s1), 1.0);
}

// (1 + 1 + 4 + 2) / 4 = 2, over both actions; pairs seen before and after the first weight keep 1.
TYPED_TEST(Weights, AreMeansOverAllActions) {
    TransitionCounts<TypeParam> counts(3, 2);
    counts.record(s2, a0, s0);
    counts.record(s0, a0, s1);
    counts.record(s0, a1, s1);
    counts.record(s0, a0, s1, false, 0.0, 4.0);
    EXPECT_DOUBLE_EQ(weight(counts, s0, s1), 2.0);
    counts.record(s0, a1, s1, false, 0.0, 2.0);
    EXPECT_DOUBLE_EQ(weight(counts, s0, s1), 2.0);
    counts.record(s0, a0, s2);
    EXPECT_EQ(weight(counts, s0, s2), 1.0);
    EXPECT_EQ(weight(counts, s2, s0), 1.0);
}

TYPED_TEST(Weights, OfOneCountAfterTheFirstWeight) {
    TransitionCounts<TypeParam> counts(2, 1);
    counts.record(s0, a0, s1, false, 0.0, 3.0);
    counts.record(s0, a0, s1);
    EXPECT_DOUBLE_EQ(weight(counts, s0, s1), 2.0);
}

TYPED_TEST(Weights, StayWithTheirPairWhileBlocksMove) {
    TransitionCounts<TypeParam> counts(300, 2);
    for (std::size_t next = 0; next < 300; ++next) {
        for (std::size_t s = 0; s < 3; ++s) {
            counts.record(state_id(s), a0, state_id(next), false, 0.0, static_cast<double>(1 + s * 1000 + next));
        }
    }
    for (std::size_t next = 0; next < 300; ++next) {
        for (std::size_t s = 0; s < 3; ++s) {
            ASSERT_EQ(weight(counts, state_id(s), state_id(next)), static_cast<double>(1 + s * 1000 + next));
        }
    }
}

TYPED_TEST(Weights, FromTheLeastToTheGreatestAreTaken) {
    TransitionCounts<TypeParam> counts(3, 1);
    counts.record(s0, a0, s1, false, 0.0, 1e-30);
    EXPECT_EQ(weight(counts, s0, s1), 1e-30);
    counts.record(s0, a0, s2, false, 0.0, 1e30);
    EXPECT_EQ(weight(counts, s0, s2), 1e30);
    counts.record(s0, a0, s1, false, 0.0, 1e30);
    EXPECT_DOUBLE_EQ(weight(counts, s0, s1), 5e29);
    for (int i = 0; i < 1000; ++i) {
        counts.record(s0, a0, s1, false, 0.0, i % 2 == 0 ? 1e-30 : 1e30);
        ASSERT_GE(weight(counts, s0, s1), 1e-30);
        ASSERT_LE(weight(counts, s0, s1), 1e30);
    }
}

TYPED_TEST(Weights, OthersAreRefusedAndChangeNothing) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    TransitionCounts<TypeParam> counts(3, 2);
    counts.record(s0, a0, s1, true, 0.0, 2.0);
    counts.clear_dirty();
    for (const double bad : {nan, 0.0, -0.0, -1.0, 1e31, 9.9e-31, infinity, -infinity}) {
        SCOPED_TRACE(bad);
        EXPECT_THROW(counts.record(s0, a0, s1, false, 0.0, bad), std::invalid_argument);
        EXPECT_THROW(counts.record(s0, a1, s2, false, 0.0, bad), std::invalid_argument);
        EXPECT_EQ(counts.pairs(), 1u);
        EXPECT_EQ(counts.n(s0, a0), 1);
        EXPECT_EQ(counts.n(s0, a1), 0);
        EXPECT_TRUE(counts.cell(s0, a0, s1)->terminal());
        EXPECT_EQ(weight(counts, s0, s1), 2.0);
        EXPECT_TRUE(counts.dirty().empty());
    }
}

TEST(WeightsMessage, NamesTheRangeAndTheValue) {
    TransitionCounts<CountCell> counts(1, 1);
    try {
        counts.record(s0, a0, s0, false, 0.0, -3.0);
        FAIL() << "not refused";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "weight must lie in [1e-30, 1e+30], got -3");
    }
}

// A weight that faded to half an observation counts half: (0.5 * 2 + 5) / 1.5 = 4.
TEST(WeightsFading, OldOnesFadeWithTheirCounts) {
    TransitionCounts<FadingCell> counts(2, 1);
    counts.record(s0, a0, s1, false, 0.0, 2.0);
    counts.fade(s0, a0, 0.5, 0.1);
    counts.record(s0, a0, s1, false, 0.0, 5.0);
    EXPECT_DOUBLE_EQ(weight(counts, s0, s1), 4.0);
}
