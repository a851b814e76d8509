// SPDX-License-Identifier: MIT
#include <sspql/model/transition_counts.hpp>

#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/model/cells.hpp>

using sspql::ActionId;
using sspql::CountCell;
using sspql::FadingCell;
using sspql::StateId;
using sspql::TransitionCounts;

namespace {

constexpr ActionId a0{0}, a1{1};
constexpr StateId s0{0}, s1{1}, s2{2};

template <class Cell>
class TransitionCountsOf : public testing::Test {};

using Cells = testing::Types<CountCell, FadingCell>;

}  // namespace

TYPED_TEST_SUITE(TransitionCountsOf, Cells, );

TYPED_TEST(TransitionCountsOf, StartsEmpty) {
    const TransitionCounts<TypeParam> counts(3, 2);
    EXPECT_EQ(counts.states(), 3u);
    EXPECT_EQ(counts.actions(), 2u);
    EXPECT_EQ(counts.pairs(), 0u);
    EXPECT_EQ(counts.n(s0, a1), 0);
    EXPECT_EQ(counts.n(s0, a1, s2), 0);
    EXPECT_EQ(counts.cell(s0, a1, s2), nullptr);
    EXPECT_EQ(counts.out_degree(s0), 0u);
    EXPECT_EQ(counts.in_degree(s0), 0u);
    EXPECT_TRUE(counts.dirty().empty());
    counts.for_each_successor(s0, [](const auto&) { FAIL(); });
    counts.for_each_predecessor(s0, [](StateId, double) { FAIL(); });
}

TYPED_TEST(TransitionCountsOf, RecordCountsTheTripleAndItsAction) {
    TransitionCounts<TypeParam> counts(3, 2);
    counts.record(s0, a0, s1);
    counts.record(s0, a0, s1);
    counts.record(s0, a0, s2);
    counts.record(s0, a1, s1);
    EXPECT_EQ(counts.n(s0, a0), 3);
    EXPECT_EQ(counts.n(s0, a1), 1);
    EXPECT_EQ(counts.n(s0, a0, s1), 2);
    EXPECT_EQ(counts.n(s0, a0, s2), 1);
    EXPECT_EQ(counts.n(s0, a1, s1), 1);
    EXPECT_EQ(counts.n(s0, a1, s2), 0);
    EXPECT_EQ(counts.n(s1, a0), 0) << "the way back was not seen";
    EXPECT_EQ(counts.pairs(), 2u) << "two actions on one (s,s') are one edge";
    EXPECT_EQ(counts.out_degree(s0), 2u);
    EXPECT_EQ(counts.in_degree(s1), 1u);
}

TYPED_TEST(TransitionCountsOf, ASelfLoopIsSuccessorAndPredecessor) {
    TransitionCounts<TypeParam> counts(1, 1);
    for (int i = 0; i < 5; ++i) counts.record(s0, a0, s0);
    EXPECT_EQ(counts.n(s0, a0, s0), 5);
    EXPECT_EQ(counts.out_degree(s0), 1u);
    EXPECT_EQ(counts.in_degree(s0), 1u);
    EXPECT_EQ(counts.pairs(), 1u);
}

TYPED_TEST(TransitionCountsOf, TerminalIsWhatTheLastObservationSaid) {
    TransitionCounts<TypeParam> counts(2, 2);
    counts.record(s0, a0, s1, true);
    EXPECT_TRUE(counts.cell(s0, a0, s1)->terminal());
    counts.record(s0, a1, s1, false);
    EXPECT_TRUE(counts.cell(s0, a0, s1)->terminal()) << "kept per action";
    EXPECT_FALSE(counts.cell(s0, a1, s1)->terminal());
    counts.record(s0, a0, s1, false);
    EXPECT_FALSE(counts.cell(s0, a0, s1)->terminal());
    EXPECT_EQ(counts.n(s0, a0, s1), 2);
}

TYPED_TEST(TransitionCountsOf, DirtyStatesAreListedOnceInOrderOfFirstRecord) {
    TransitionCounts<TypeParam> counts(3, 1);
    counts.record(s2, a0, s0);
    counts.record(s0, a0, s1);
    counts.record(s2, a0, s1);
    EXPECT_EQ(counts.dirty(), (std::vector<StateId>{s2, s0}));
    counts.clear_dirty();
    EXPECT_TRUE(counts.dirty().empty());
    counts.record(s0, a0, s1);
    EXPECT_EQ(counts.dirty(), (std::vector<StateId>{s0}));
}

TYPED_TEST(TransitionCountsOf, ALabelIsReadFromBothEndsAndSurvivesRecords) {
    TransitionCounts<TypeParam> counts(3, 1);
    counts.record(s0, a0, s1);
    counts.record(s2, a0, s1);
    counts.for_each_successor(s2, [&](const auto& successor) { counts.set_label(successor, 7.5); });
    counts.record(s0, a0, s2);
    counts.record(s2, a0, s1);
    counts.for_each_successor(s2, [](const auto& successor) { EXPECT_EQ(successor.label(), 7.5); });
    counts.for_each_predecessor(s1, [](StateId u, double label) {
        if (u == s2) {
            EXPECT_EQ(label, 7.5);
        }
    });
}

TYPED_TEST(TransitionCountsOf, GrowAddsEmptyStatesAndKeepsTheRest) {
    TransitionCounts<TypeParam> counts(0, 3);
    EXPECT_EQ(counts.states(), 0u);
    counts.grow(2);
    counts.record(s0, ActionId{2}, s1);
    counts.grow(100);
    EXPECT_EQ(counts.states(), 100u);
    EXPECT_EQ(counts.n(s0, ActionId{2}, s1), 1);
    EXPECT_EQ(counts.n(StateId{99}, ActionId{2}), 0);
    counts.grow(5);
    EXPECT_EQ(counts.states(), 100u) << "fewer changes nothing";
    counts.record(StateId{99}, a0, s0);
    EXPECT_EQ(counts.in_degree(s0), 1u);
}

TYPED_TEST(TransitionCountsOf, CopiesAreIndependent) {
    TransitionCounts<TypeParam> counts(2, 1);
    counts.record(s0, a0, s1);
    TransitionCounts<TypeParam> copy = counts;
    copy.record(s0, a0, s1);
    EXPECT_EQ(counts.n(s0, a0), 1);
    EXPECT_EQ(copy.n(s0, a0), 2);
}

TYPED_TEST(TransitionCountsOf, NoActionsOrTooManyIdsAreRefused) {
    using Counts = TransitionCounts<TypeParam>;
    EXPECT_THROW(Counts(3, 0), std::invalid_argument);
    EXPECT_THROW(Counts(3, sspql::max_ids), std::invalid_argument);
    EXPECT_THROW(Counts(sspql::max_ids, 1), std::invalid_argument);
    EXPECT_NO_THROW(Counts(0, 1));
}

TYPED_TEST(TransitionCountsOf, BytesCountWhatIsHeld) {
    TransitionCounts<TypeParam> counts(100, 4);
    const std::size_t before = counts.bytes();
    for (std::size_t s = 0; s < 100; ++s) counts.record(sspql::state_id(s), a0, s1);
    EXPECT_GT(counts.bytes(), before);
}
