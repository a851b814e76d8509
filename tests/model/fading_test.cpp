// SPDX-License-Identifier: MIT
// TransitionCounts<FadingCell>: fading, forgetting and growing again.
#include <sspql/model/transition_counts.hpp>

#include <cstddef>
#include <set>

#include <gtest/gtest.h>

using sspql::ActionId;
using sspql::FadingCell;
using sspql::state_id;
using sspql::StateId;
using sspql::TransitionCounts;

namespace {

constexpr ActionId a0{0}, a1{1};
constexpr StateId s0{0}, s1{1}, s2{2};

void expect_star(const TransitionCounts<FadingCell>& counts, StateId hub, std::size_t first, std::size_t last) {
    std::set<std::size_t> successors;
    counts.for_each_successor(hub, [&](const auto& successor) { successors.insert(index(successor.state())); });
    ASSERT_EQ(successors.size(), last - first);
    EXPECT_EQ(counts.pairs(), last - first);
    for (std::size_t next = first; next < last; ++next) {
        ASSERT_TRUE(successors.count(next) == 1) << next;
        ASSERT_NE(counts.cell(hub, a0, state_id(next)), nullptr) << next;
        ASSERT_EQ(counts.in_degree(state_id(next)), 1u) << next;
    }
}

}  // namespace

// n = 4 to s1 and 2 to s2, halved: 2 and 1; halved again with least 0.75: 1 stays, 0.5 goes.
TEST(Fading, ScalesCountsAndForgetsSmallOnes) {
    TransitionCounts<FadingCell> counts(3, 2);
    for (int i = 0; i < 4; ++i) counts.record(s0, a0, s1, false, 0.25);
    for (int i = 0; i < 2; ++i) counts.record(s0, a0, s2, true, -1.0);
    counts.fade(s0, a0, 0.5, 0.75);
    EXPECT_EQ(counts.n(s0, a0, s1), 2.0);
    EXPECT_EQ(counts.n(s0, a0, s2), 1.0);
    EXPECT_EQ(counts.n(s0, a0), 3.0);
    EXPECT_EQ(counts.cell(s0, a0, s1)->mean_reward(), 0.25) << "the mean reward does not fade";
    EXPECT_TRUE(counts.cell(s0, a0, s2)->terminal());
    counts.fade(s0, a0, 0.5, 0.75);
    EXPECT_EQ(counts.n(s0, a0), 1.0);
    EXPECT_EQ(counts.cell(s0, a0, s2), nullptr);
    EXPECT_EQ(counts.pairs(), 1u);
    EXPECT_EQ(counts.out_degree(s0), 1u);
    EXPECT_EQ(counts.in_degree(s2), 0u);
}

TEST(Fading, AnotherActionKeepsThePair) {
    TransitionCounts<FadingCell> counts(2, 2);
    counts.record(s0, a0, s1);
    counts.record(s0, a1, s1);
    counts.fade(s0, a0, 0.0, 0.1);
    EXPECT_EQ(counts.pairs(), 1u);
    EXPECT_EQ(counts.n(s0, a0), 0.0);
    EXPECT_EQ(counts.n(s0, a1, s1), 1.0);
    counts.fade(s0, a1, 0.0, 0.1);
    EXPECT_EQ(counts.pairs(), 0u);
}

TEST(Fading, MarksItsStateDirty) {
    TransitionCounts<FadingCell> counts(2, 1);
    counts.record(s0, a0, s1);
    counts.clear_dirty();
    counts.fade(s0, a0, 0.5, 0.1);
    ASSERT_EQ(counts.dirty().size(), 1u);
    EXPECT_EQ(counts.dirty().front(), s0);
}

TEST(Fading, AForgottenOutcomeStartsAnew) {
    TransitionCounts<FadingCell> counts(2, 1);
    counts.record(s0, a0, s1, true, 5.0, 9.0);
    counts.cell(s0, a0, s1)->fast = 0.5f;
    counts.fade(s0, a0, 0.0, 0.1);
    counts.record(s0, a0, s1, false, 1.0, 3.0);
    const FadingCell* cell = counts.cell(s0, a0, s1);
    EXPECT_EQ(cell->n, 1.0);
    EXPECT_EQ(cell->reward_sum, 1.0);
    EXPECT_EQ(cell->fast, 0.0);
    EXPECT_FALSE(cell->terminal());
    counts.for_each_successor(s0, [](const auto& successor) { EXPECT_EQ(successor.weight(), 3.0); });
}

// The sizes stand around 32, from where a hash index takes over, and in the thousands.
TEST(FadingHub, VanishesAndGrowsAgain) {
    for (const std::size_t degree : {31u, 32u, 33u, 34u, 64u, 65u, 3000u}) {
        SCOPED_TRACE("degree " + std::to_string(degree));
        TransitionCounts<FadingCell> counts(degree + 1, 2);
        for (int round = 0; round < 3; ++round) {
            for (std::size_t next = 1; next <= degree; ++next) counts.record(s0, a0, state_id(next));
            expect_star(counts, s0, 1, degree + 1);
            counts.fade(s0, a0, 0.0, 0.5);
            EXPECT_EQ(counts.pairs(), 0u);
            EXPECT_EQ(counts.out_degree(s0), 0u);
            EXPECT_EQ(counts.n(s0, a0), 0.0);
            for (std::size_t next = 0; next <= degree; ++next) {
                ASSERT_EQ(counts.in_degree(state_id(next)), 0u);
                ASSERT_EQ(counts.cell(s0, a0, state_id(next)), nullptr);
            }
        }
    }
}

TEST(FadingHub, ShrinksBelowTheHashAndBack) {
    constexpr std::size_t degree = 100;
    TransitionCounts<FadingCell> counts(degree + 1, 2);
    for (std::size_t next = 1; next <= degree; ++next) {
        // The first 20 twice: they survive one halving.
        counts.record(s0, a0, state_id(next));
        if (next <= 20) counts.record(s0, a0, state_id(next));
    }
    counts.fade(s0, a0, 0.5, 0.75);
    expect_star(counts, s0, 1, 21);
    for (std::size_t next = 21; next <= degree; ++next) counts.record(s0, a0, state_id(next));
    expect_star(counts, s0, 1, degree + 1);
}

// Every other successor survives: more than 32 are left, in other places than before.
TEST(FadingHub, LosesSomeAndFindsTheRest) {
    constexpr std::size_t degree = 300;
    TransitionCounts<FadingCell> counts(degree + 1, 2);
    for (std::size_t next = 1; next <= degree; ++next) {
        for (std::size_t i = 0; i < 1 + next % 2; ++i) counts.record(s0, a0, state_id(next));
    }
    counts.fade(s0, a0, 0.5, 0.75);
    EXPECT_EQ(counts.out_degree(s0), degree / 2);
    for (int round = 0; round < 2; ++round) {
        for (std::size_t next = 1; next <= degree; ++next) {
            ASSERT_EQ(counts.n(s0, a0, state_id(next)), next % 2 == 1 ? 1.0 + round : 0.0) << next;
        }
        for (std::size_t next = 1; next <= degree; next += 2) counts.record(s0, a0, state_id(next));
        EXPECT_EQ(counts.out_degree(s0), degree / 2) << "found, not added again";
    }
}

// Everybody goes to s0: erasing from the in-side moves in-records of other states.
TEST(FadingHub, PredecessorsVanishInAnyOrder) {
    constexpr std::size_t n = 1500;
    TransitionCounts<FadingCell> counts(n, 1);
    for (std::size_t s = 1; s < n; ++s) counts.record(state_id(s), a0, s0);
    for (std::size_t s = 1; s < n; ++s) {
        counts.for_each_successor(state_id(s),
                                  [&](const auto& edge) { counts.set_label(edge, static_cast<double>(s)); });
    }
    for (std::size_t s = 1; s < n; ++s) {
        if (s % 3 != 0) counts.fade(state_id(s), a0, 0.0, 0.5);
    }
    EXPECT_EQ(counts.in_degree(s0), (n - 1) / 3);
    counts.for_each_predecessor(s0, [](StateId u, double label) {
        EXPECT_EQ(index(u) % 3, 0u);
        EXPECT_EQ(label, static_cast<double>(index(u)));
    });
    for (std::size_t s = 3; s < n; s += 3) {
        counts.for_each_successor(state_id(s),
                                  [&](const auto& edge) { EXPECT_EQ(edge.label(), static_cast<double>(s)); });
    }
}
