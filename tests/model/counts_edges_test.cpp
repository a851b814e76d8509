// SPDX-License-Identifier: MIT
// Counts at the ends of their ranges: as large as they get, and as few as there can be.
#include <sspql/model/transition_counts.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include <gtest/gtest.h>

#include <sspql/model/cells.hpp>
#include <sspql/model/probability.hpp>

using sspql::action_id;
using sspql::ActionId;
using sspql::CountCell;
using sspql::FadingCell;
using sspql::state_id;
using sspql::StateId;
using sspql::TransitionCounts;

namespace {

constexpr StateId s0{0}, s1{1}, s2{2};
constexpr std::uint32_t limit = 0x7FFFFFFFu;

/// A count that nobody could wait for.
void set_count(TransitionCounts<CountCell>& counts, StateId s, ActionId a, StateId next, std::uint32_t n) {
    CountCell* cell = counts.cell(s, a, next);
    ASSERT_NE(cell, nullptr);
    const std::uint32_t bits = n | (cell->terminal() ? 0x80000000u : 0u);
    static_assert(sizeof bits == sizeof *cell);
    std::memcpy(static_cast<void*>(cell), &bits, sizeof bits);
}

/// Up to 8 actions cells are kept in rows, beyond in lists.
class CountsEdges : public testing::TestWithParam<std::size_t> {};

}  // namespace

TEST_P(CountsEdges, TheLargestCountIsHalvedAndDoesNotWrap) {
    const ActionId a = action_id(GetParam() - 1);
    TransitionCounts<CountCell> counts(3, GetParam());
    counts.record(s0, a, s1, true);
    set_count(counts, s0, a, s1, limit - 1);
    counts.record(s0, a, s1, true);
    EXPECT_EQ(counts.n(s0, a, s1), limit) << "the last one that has room";
    counts.record(s0, a, s1, true);
    EXPECT_EQ(counts.n(s0, a, s1), (limit + 1) / 2 + 1);
    EXPECT_EQ(counts.n(s0, a), (limit + 1) / 2 + 1);
    EXPECT_TRUE(counts.cell(s0, a, s1)->terminal());
}

// One of two outcomes is full: both are halved, and so is their sum.
TEST_P(CountsEdges, ProbabilitiesOutliveTheLimit) {
    const ActionId a = action_id(0);
    TransitionCounts<CountCell> counts(3, GetParam());
    counts.record(s0, a, s1);
    counts.record(s0, a, s2);
    set_count(counts, s0, a, s1, limit);
    set_count(counts, s0, a, s2, limit / 3);
    counts.record(s0, a, s1);
    EXPECT_EQ(counts.n(s0, a), counts.n(s0, a, s1) + counts.n(s0, a, s2));
    EXPECT_NEAR(sspql::probability(counts, s0, a, s1), 0.75, 1e-8);
    EXPECT_NEAR(sspql::entropy(counts, s0, a), 0.5623351446188083, 1e-8);
    for (int i = 0; i < 1000; ++i) counts.record(s0, a, i % 4 == 0 ? s2 : s1);
    EXPECT_NEAR(sspql::probability(counts, s0, a, s1), 0.75, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Actions, CountsEdges, testing::Values(1u, 8u, 9u));

// 2^53 + 1 is no double: half of the past makes room, the mean reward stays.
TEST(FadingEdges, TheLargestCountIsHalvedAndCountsOn) {
    constexpr double most = 9007199254740992.0;
    TransitionCounts<FadingCell> counts(2, 1);
    counts.record(s0, action_id(0), s1, false, 3.0);
    counts.cell(s0, action_id(0), s1)->n = most;
    counts.cell(s0, action_id(0), s1)->reward_sum = 3.0 * most;
    counts.fade(s0, action_id(0), 1.0, 0.0);
    EXPECT_EQ(counts.n(s0, action_id(0)), most);
    counts.record(s0, action_id(0), s1, true, 3.0);
    EXPECT_EQ(counts.n(s0, action_id(0), s1), most / 2 + 1.0);
    EXPECT_EQ(counts.n(s0, action_id(0)), most / 2 + 1.0);
    EXPECT_DOUBLE_EQ(counts.cell(s0, action_id(0), s1)->mean_reward(), 3.0);
}

TEST(FadingEdges, TheSmallestCountsAreForgottenNotDividedBy) {
    TransitionCounts<FadingCell> counts(2, 1);
    counts.record(s0, action_id(0), s1, false, -1e300);
    for (int i = 0; i < 1100; ++i) counts.fade(s0, action_id(0), 0.5, 0.0);  // 2^-1100 is 0
    EXPECT_EQ(counts.n(s0, action_id(0)), 0.0);
    EXPECT_EQ(counts.pairs(), 0u);
    EXPECT_EQ(counts.cell(s0, action_id(0), s1), nullptr);
    EXPECT_EQ(FadingCell{}.mean_reward(), 0.0);
}

TEST(EmptyCounts, AnswerAndGrow) {
    EXPECT_THROW(TransitionCounts<CountCell>(3, 0), std::invalid_argument);
    TransitionCounts<CountCell> counts(0, 1);
    EXPECT_EQ(counts.states(), 0u);
    EXPECT_EQ(counts.pairs(), 0u);
    EXPECT_TRUE(counts.dirty().empty());
    counts.clear_dirty();
    counts.reserve(0, 0);
    counts.grow(0);
    counts.grow(1);
    EXPECT_EQ(counts.out_degree(s0), 0u);
    EXPECT_EQ(counts.in_degree(s0), 0u);
    EXPECT_EQ(counts.n(s0, action_id(0)), 0u);
    EXPECT_EQ(sspql::probability(counts, s0, action_id(0), s0), 0.0);
    EXPECT_EQ(sspql::entropy(counts, s0, action_id(0)), 0.0);
}

TEST(OneStateOneAction, LeadsToItself) {
    TransitionCounts<CountCell> counts(1, 1);
    counts.record(s0, action_id(0), s0);
    counts.record(s0, action_id(0), s0, true, 0.0, 1e30);
    EXPECT_EQ(counts.n(s0, action_id(0), s0), 2u);
    EXPECT_EQ(counts.out_degree(s0), 1u);
    EXPECT_EQ(counts.in_degree(s0), 1u);
    EXPECT_EQ(counts.successor(s0, 0).weight(), 5e29);
    EXPECT_EQ(sspql::entropy(counts, s0, action_id(0)), 0.0);
}
