// SPDX-License-Identifier: MIT
#include <sspql/learn/q_update.hpp>

#include <gtest/gtest.h>

#include <sspql/spaces/legal_actions.hpp>

namespace sspql_q_update_test {

using sspql::action_id;
using sspql::ActionSet;
using sspql::QTable;
using sspql::state_id;
using sspql::Transition;

namespace {

const Transition step{state_id(0), action_id(1), 0.5, state_id(1), false, 1.0};
const Transition last{state_id(0), action_id(1), 0.5, state_id(1), true, 1.0};

QTable table() {
    QTable q(2, 2);
    q(state_id(0), action_id(1)) = 1.0;
    q(state_id(1), action_id(0)) = 4.0;
    q(state_id(1), action_id(1)) = 2.0;
    return q;
}

}  // namespace

TEST(QUpdate, IsEq1) {
    QTable q = table();
    sspql::q_update(q, step, 0.25, 0.5, sspql::AllActions{});
    EXPECT_DOUBLE_EQ(q(state_id(0), action_id(1)), 1.0 + 0.25 * (0.5 + 0.5 * 4.0 - 1.0));
    EXPECT_EQ(q(state_id(0), action_id(0)), 0.0) << "one entry changes";
    EXPECT_EQ(q(state_id(1), action_id(0)), 4.0);
}

TEST(QUpdate, ATerminatedStepHasNoFuture) {
    QTable q = table();
    sspql::q_update(q, last, 0.25, 0.5, sspql::AllActions{});
    EXPECT_DOUBLE_EQ(q(state_id(0), action_id(1)), 1.0 + 0.25 * (0.5 - 1.0));
}

TEST(QUpdate, MaximisesOverLegalActions) {
    QTable q = table();
    sspql::LegalActionTable legal;
    legal.set(state_id(1), ActionSet::of(2, {action_id(1)}));
    sspql::q_update(q, step, 0.25, 0.5, legal);
    EXPECT_DOUBLE_EQ(q(state_id(0), action_id(1)), 1.0 + 0.25 * (0.5 + 0.5 * 2.0 - 1.0));
}

TEST(QUpdate, ARateOfZeroLearnsNothingAndOfOneForgetsAll) {
    QTable q = table();
    sspql::q_update(q, step, 0.0, 0.5, sspql::AllActions{});
    EXPECT_EQ(q.matrix(), table().matrix());
    sspql::q_update(q, step, 1.0, 0.5, sspql::AllActions{});
    EXPECT_EQ(q(state_id(0), action_id(1)), 2.5);
}

}  // namespace sspql_q_update_test
