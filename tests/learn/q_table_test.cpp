// SPDX-License-Identifier: MIT
#include <sspql/learn/q_table.hpp>

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <sspql/learn/visit_counts.hpp>
#include <sspql/spaces/action_set.hpp>
#include <sspql/spaces/legal_actions.hpp>

namespace sspql_q_table_test {

using sspql::action_id;
using sspql::ActionSet;
using sspql::QTable;
using sspql::state_id;

TEST(QTable, StartsAtItsInitialValue) {
    const QTable q(3, 2, 0.5);
    EXPECT_EQ(q.states(), 3u);
    EXPECT_EQ(q.actions(), 2u);
    EXPECT_EQ(q.initial(), 0.5);
    for (std::size_t s = 0; s < 3; ++s) EXPECT_EQ(q(state_id(s), action_id(s % 2)), 0.5);
    EXPECT_EQ(QTable(0, 2).states(), 0u);
}

TEST(QTable, EigenSeesTheSameMemory) {
    QTable q(3, 4);
    q(state_id(1), action_id(2)) = 7.0;
    auto map = q.matrix();
    EXPECT_EQ(map.rows(), 3);
    EXPECT_EQ(map.cols(), 4);
    EXPECT_EQ(map(1, 2), 7.0);
    map(2, 3) = -1.0;
    EXPECT_EQ(q(state_id(2), action_id(3)), -1.0);
    EXPECT_EQ(&map(0, 0), &q(state_id(0), action_id(0)));
    EXPECT_EQ(&map(1, 0), &map(0, 0) + 4) << "row = state";
    const QTable& constant = q;
    EXPECT_EQ(constant.matrix().sum(), 6.0);
}

TEST(QTable, GrowsAndKeepsWhatItHas) {
    QTable q(2, 3, 1.0);
    q(state_id(1), action_id(2)) = 9.0;
    q.grow(5);
    EXPECT_EQ(q.states(), 5u);
    EXPECT_EQ(q(state_id(1), action_id(2)), 9.0);
    EXPECT_EQ(q(state_id(4), action_id(2)), 1.0);
    q.grow(3);
    EXPECT_EQ(q.states(), 5u) << "never shrinks";
}

TEST(QTable, ReservedRoomIsNotReallocated) {
    QTable q(1, 4);
    q.reserve(1000);
    const double* before = q.matrix().data();
    for (std::size_t n = 2; n <= 1000; ++n) q.grow(n);
    EXPECT_EQ(q.matrix().data(), before);
}

TEST(QTable, GrowingOneByOneReallocatesSeldom) {
    QTable q(1, 4);
    int moves = 0;
    const double* place = q.matrix().data();
    for (std::size_t n = 2; n <= 100000; ++n) {
        q.grow(n);
        moves += place != q.matrix().data() ? 1 : 0;
        place = q.matrix().data();
    }
    EXPECT_LT(moves, 20) << "capacity doubles";
}

TEST(QTable, MaxLooksAtAllowedActionsOnly) {
    QTable q(2, 3);
    q(state_id(1), action_id(0)) = 5.0;
    q(state_id(1), action_id(1)) = -2.0;
    q(state_id(1), action_id(2)) = 3.0;
    EXPECT_EQ(q.max(state_id(1), sspql::AllActions{}.allowed(state_id(1))), 5.0);
    EXPECT_EQ(q.max(state_id(1), ActionSet::of(3, {action_id(1), action_id(2)})), 3.0);
    EXPECT_EQ(q.max(state_id(1), ActionSet::of(3, {action_id(1)})), -2.0);
    EXPECT_EQ(q.max(state_id(1), ActionSet::none(3)), -std::numeric_limits<double>::infinity());
}

TEST(QTable, ResetGoesBackToTheInitialValue) {
    QTable q(2, 2, 0.25);
    q(state_id(1), action_id(1)) = 3.0;
    q.grow(4);
    q.reset();
    EXPECT_EQ(q.matrix(), QTable(4, 2, 0.25).matrix());
}

TEST(QTable, RefusesNoActionsAndValuesThatAreNotFinite) {
    EXPECT_THROW(QTable(2, 0), std::invalid_argument);
    EXPECT_THROW(QTable(2, 2, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
    EXPECT_THROW(QTable(2, 2, std::numeric_limits<double>::infinity()), std::invalid_argument);
}

TEST(VisitCounts, CountGrowAndReset) {
    sspql::VisitCounts visits(2, 3);
    visits.add(state_id(1), action_id(2));
    visits.add(state_id(1), action_id(2));
    visits.grow(4);
    visits.grow(1);
    visits.add(state_id(3), action_id(0));
    EXPECT_EQ(visits(state_id(1), action_id(2)), 2u);
    EXPECT_EQ(visits(state_id(3), action_id(0)), 1u);
    EXPECT_EQ(visits(state_id(0), action_id(0)), 0u);
    visits.reset();
    EXPECT_EQ(visits(state_id(1), action_id(2)), 0u);
    EXPECT_EQ(visits(state_id(3), action_id(0)), 0u);
}

}  // namespace sspql_q_table_test
