// SPDX-License-Identifier: MIT
#include <sspql/learn/learner.hpp>

#include "learn/learner_testing.hpp"

using namespace sspql;
using namespace sspql::testing;

template <class L>
class LearnerObserve : public ::testing::Test {};
TYPED_TEST_SUITE(LearnerObserve, AllLearners, LearnerNames);

template <class L>
class LearnerObserveByEq1 : public ::testing::Test {};
TYPED_TEST_SUITE(LearnerObserveByEq1, LearnersByEq1, LearnerNames);

TYPED_TEST(LearnerObserve, LeavesTheRunningEpisodeAlone) {
    TypeParam learner(Room::states, Room::actions, {}, 2);
    const ActionId a = learner.begin(state_id(7));
    learner.observe(state_id(0), action_id(1), 0.5, state_id(1), false);
    learner.observe(state_id(3), action_id(2), 1.0, state_id(4), true);
    EXPECT_TRUE(learner.running());
    EXPECT_EQ(learner.state(), state_id(7));
    EXPECT_EQ(learner.action(), a);
    (void)learner.step(0.25, state_id(8));
    EXPECT_EQ(learner.visits()(state_id(7), a), 1u);
    EXPECT_EQ(learner.visits()(state_id(0), action_id(1)), 1u);
    EXPECT_EQ(learner.visits()(state_id(3), action_id(2)), 1u);
}

TYPED_TEST(LearnerObserveByEq1, UpdatesWhatItIsTold) {
    TypeParam learner(Room::states, Room::actions, {}, 2);
    const ActionId a = learner.begin(state_id(7));
    learner.observe(state_id(0), action_id(1), 0.5, state_id(1), false);
    learner.observe(state_id(3), action_id(2), 1.0, state_id(4), true);
    (void)learner.step(0.25, state_id(8));
    EXPECT_DOUBLE_EQ(learner.q()(state_id(7), a), 0.8 * 0.25);
    EXPECT_DOUBLE_EQ(learner.q()(state_id(0), action_id(1)), 0.8 * 0.5);
    EXPECT_DOUBLE_EQ(learner.q()(state_id(3), action_id(2)), 0.8 * 1.0);
}

TYPED_TEST(LearnerObserveByEq1, LearnsWhatActingLearns) {
    TypeParam actor(Room::states, Room::actions, {}, 2);
    TypeParam pupil(Room::states, Room::actions, {}, 2);
    Room room(2, 0.1);
    for (int episode = 0; episode < 10; ++episode) {
        StateId s = Room::at(0, 0);
        (void)actor.begin(s);
        for (;;) {
            const ActionId a = actor.action();
            const StateId next = room.step(s, a);
            const bool home = next == Room::at(4, 4);
            pupil.observe(s, a, home ? 1.0 : 0.0, next, home);
            if (home) {
                actor.end(1.0, next, true);
                break;
            }
            (void)actor.step(0.0, next);
            s = next;
        }
        EXPECT_EQ(pupil.q().matrix(), actor.q().matrix());
        for (std::size_t i = 0; i < Room::states; ++i) EXPECT_EQ(pupil.best(state_id(i)), actor.best(state_id(i)));
    }
}

TYPED_TEST(LearnerObserveByEq1, ATruncatedEndKeepsItsFutureValue) {
    TypeParam learner(3, 1);
    learner.observe(state_id(1), action_id(0), 1.0, state_id(2), true);
    const double value = learner.q()(state_id(1), action_id(0));
    TypeParam terminated = learner;
    (void)learner.begin(state_id(0));
    learner.end(0.0, state_id(1), false);
    EXPECT_DOUBLE_EQ(learner.q()(state_id(0), action_id(0)), 0.8 * 0.8 * value);
    (void)terminated.begin(state_id(0));
    terminated.end(0.0, state_id(1), true);
    EXPECT_EQ(terminated.q()(state_id(0), action_id(0)), 0.0);
}

TEST(SspqlObserve, ATerminatedStepRenewsThePaths) {
    Sspql<> learner(4, 2);
    learner.observe(state_id(0), action_id(1), 0.0, state_id(1), false);
    learner.observe(state_id(1), action_id(0), 0.0, state_id(2), false);
    EXPECT_EQ(learner.ssp_values().action(state_id(0)), no_action) << "no episode ended yet";
    learner.observe(state_id(2), action_id(1), 1.0, state_id(3), true);
    EXPECT_EQ(learner.ssp_values().action(state_id(0)), action_id(1));
    EXPECT_EQ(learner.ssp_values().action(state_id(1)), action_id(0));
    EXPECT_EQ(learner.ssp_values().action(state_id(2)), action_id(1));
    EXPECT_EQ(learner.tree().path(state_id(0)),
              (std::vector<StateId>{state_id(0), state_id(1), state_id(2), state_id(3)}));
}
