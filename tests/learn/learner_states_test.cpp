// SPDX-License-Identifier: MIT
#include <sspql/learn/transition.hpp>

#include <cstdint>
#include <stdexcept>

#include "learn/learner_testing.hpp"

using namespace sspql;
using namespace sspql::testing;

template <class L>
class LearnerStates : public ::testing::Test {};
TYPED_TEST_SUITE(LearnerStates, AllLearners, LearnerNames);

TEST(StateCount, IsFixedOrGrows) {
    EXPECT_EQ(StateCount(7).initial(), 7u);
    EXPECT_FALSE(StateCount(7).grows());
    EXPECT_EQ(StateCount::growing().initial(), 0u);
    EXPECT_TRUE(StateCount::growing().grows());
    EXPECT_THROW(StateCount(0), std::invalid_argument);
    EXPECT_THROW(StateCount(4294967295u), std::invalid_argument);
    EXPECT_THROW(StateCount(static_cast<std::size_t>(-1)), std::invalid_argument);
}

TYPED_TEST(LearnerStates, AGrowingLearnerAdmitsTheNextId) {
    TypeParam learner(StateCount::growing(), 3);
    EXPECT_EQ(learner.states(), 0u);
    EXPECT_TRUE(learner.grows());
    EXPECT_THROW((void)learner.begin(state_id(1)), std::invalid_argument);
    EXPECT_EQ(learner.states(), 0u);
    EXPECT_FALSE(learner.running());
    (void)learner.begin(state_id(0));
    EXPECT_EQ(learner.states(), 1u);
    (void)learner.step(0.0, state_id(1));
    EXPECT_EQ(learner.states(), 2u);
    EXPECT_THROW((void)learner.step(0.0, state_id(3)), std::invalid_argument);
    EXPECT_THROW((void)learner.step(not_a_number, state_id(2)), std::invalid_argument);
    EXPECT_EQ(learner.states(), 2u) << "a refused call adds no state";
    learner.end(1.0, state_id(2), true);
    EXPECT_EQ(learner.states(), 3u);
    EXPECT_EQ(learner.q().states(), 3u);
}

TYPED_TEST(LearnerStates, ObserveAdmitsBothItsStates) {
    TypeParam learner(StateCount::growing(), 2);
    learner.observe(state_id(0), action_id(1), 0.0, state_id(1), false);
    EXPECT_EQ(learner.states(), 2u);
    EXPECT_THROW(learner.observe(state_id(3), action_id(0), 0.0, state_id(2), false), std::invalid_argument);
    EXPECT_THROW(learner.observe(state_id(2), action_id(0), 0.0, state_id(4), false), std::invalid_argument);
    EXPECT_EQ(learner.states(), 2u);
    learner.observe(state_id(2), action_id(0), 0.0, state_id(2), true);
    EXPECT_EQ(learner.states(), 3u);
}

TYPED_TEST(LearnerStates, LookingAddsNoState) {
    TypeParam learner(StateCount::growing(), 2);
    EXPECT_THROW((void)learner.best(state_id(0)), std::invalid_argument);
    EXPECT_THROW((void)learner.terms(state_id(0), action_id(0)), std::invalid_argument);
    EXPECT_EQ(learner.states(), 0u);
}

TYPED_TEST(LearnerStates, GoalsAndMasksAdmitTheNextId) {
    TypeParam learner(StateCount::growing(), 2);
    learner.set_legal_actions(state_id(0), ActionSet::of(2, {action_id(1)}));
    EXPECT_EQ(learner.states(), 1u);
    EXPECT_EQ(learner.begin(state_id(0)), action_id(1));
    learner.set_goals({{state_id(1)}, {state_id(2)}});
    EXPECT_EQ(learner.states(), 3u);
    EXPECT_THROW(learner.set_goals({{state_id(3)}, {state_id(5)}}), std::invalid_argument);
    EXPECT_THROW(learner.set_goals({{state_id(3), -1.0}}), std::invalid_argument);
    EXPECT_EQ(learner.states(), 3u);
}

TYPED_TEST(LearnerStates, GrowAddsStatesAtOnce) {
    TypeParam learner(StateCount::growing(), 2);
    learner.grow(10);
    EXPECT_EQ(learner.states(), 10u);
    learner.grow(4);
    EXPECT_EQ(learner.states(), 10u);
    EXPECT_NO_THROW((void)learner.begin(state_id(9)));
    TypeParam fixed(5, 2);
    fixed.grow(5);
    EXPECT_THROW(fixed.grow(6), std::invalid_argument);
    EXPECT_EQ(fixed.states(), 5u);
}

TYPED_TEST(LearnerStates, GrowingAndFixedLearnersActAlike) {
    TypeParam fixed(Room::states, Room::actions, {}, 3);
    TypeParam growing(StateCount::growing(), Room::actions, {}, 3);
    Room room(3, 0.2);
    Room same(3, 0.2);
    growing.grow(Room::states);
    for (int k = 0; k < 10; ++k) {
        EXPECT_EQ(walk(fixed, room, Room::at(0, 0), Room::at(4, 4)),
                  walk(growing, same, Room::at(0, 0), Room::at(4, 4)));
    }
    EXPECT_EQ(fingerprint(fixed), fingerprint(growing));
}

template <class L>
class ValueLearnerStates : public ::testing::Test {};
TYPED_TEST_SUITE(ValueLearnerStates, ValueLearners, LearnerNames);

TYPED_TEST(ValueLearnerStates, OneStateAndOneActionAreEnough) {
    TypeParam learner(1, 1, {}, 1);
    for (int k = 0; k < 100; ++k) {
        EXPECT_EQ(learner.begin(state_id(0)), action_id(0));
        for (int i = 0; i < 10; ++i) EXPECT_EQ(learner.step(1.0, state_id(0)), action_id(0));
        learner.end(1.0, state_id(0), k % 2 == 0);
    }
    EXPECT_EQ(learner.best(state_id(0)), action_id(0));
    EXPECT_LT(learner.q()(state_id(0), action_id(0)), 5.0 + 1e-9) << "1 / (1 - gamma)";
    EXPECT_GT(learner.q()(state_id(0), action_id(0)), 1.0 - 1e-9);
}
