// SPDX-License-Identifier: MIT
#include <sspql/learn/learner.hpp>

#include <cmath>
#include <stdexcept>

#include "learn/learner_testing.hpp"

using namespace sspql;
using namespace sspql::testing;

namespace {

/// A learner that knows the room, but no goal.
Sspql<> guest(std::uint64_t seed, SspqlParams<> params = {}) {
    Sspql<> learner(Room::states, Room::actions, params, seed);
    show_room(learner);
    return learner;
}

std::size_t steps(Sspql<>& learner, StateId from, StateId to) {
    Room room(1);
    return walk(learner, room, from, to).size();
}

}  // namespace

TEST(SspqlGoals, ANewGoalIsFollowedAtOnce) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        for (const auto& params : {SspqlParams<>::with_bonus(), SspqlParams<>::without_bonus()}) {
            Sspql<> learner = guest(seed, params);
            for (const StateId goal : {Room::at(4, 4), Room::at(4, 0), Room::at(2, 1), Room::at(0, 4)}) {
                learner.set_goals({{goal}});
                EXPECT_EQ(steps(learner, Room::at(0, 0), goal), index(goal) % 5 + index(goal) / 5) << "seed " << seed;
                EXPECT_EQ(learner.q().matrix().array().abs().maxCoeff(), 0.8) << "values of the old goal are gone";
            }
        }
    }
}

TEST(SspqlGoals, TheModelStaysWhenGoalsChange) {
    Sspql<> learner = guest(1);
    const auto pairs = learner.counts().pairs();
    (void)learner.set_goals({{Room::at(4, 4)}});
    EXPECT_EQ(learner.counts().pairs(), pairs);
    EXPECT_EQ(learner.counts().n(state_id(0), action_id(0)), 1u);
    EXPECT_EQ(learner.visits()(state_id(0), action_id(0)), 0u) << "eq. 9 counts from here";
    EXPECT_EQ(learner.terms(state_id(0), action_id(0)).n, 1.0);
}

TEST(SspqlGoals, ANewGoalCanBeSetDuringAnEpisode) {
    Sspql<> learner = guest(4);
    learner.set_goals({{Room::at(4, 0)}});
    ActionId a = learner.begin(Room::at(0, 0));
    EXPECT_EQ(a, action_id(0));
    a = learner.step(0.0, Room::at(1, 0));
    EXPECT_EQ(a, action_id(0));
    learner.set_goals({{Room::at(0, 0)}});
    EXPECT_TRUE(learner.running());
    EXPECT_EQ(learner.step(0.0, Room::at(2, 0)), action_id(1)) << "turns round";
}

TEST(SspqlGoals, TheNearerOfSeveralGoalsIsChosenByPathAndOffset) {
    Sspql<> learner = guest(5);
    learner.set_goals({{Room::at(0, 4)}, {Room::at(2, 0)}});
    EXPECT_EQ(learner.tree().path(Room::at(0, 0)).back(), Room::at(2, 0));
    learner.set_goals({{Room::at(0, 4)}, {Room::at(2, 0), 1000.0}});
    EXPECT_EQ(learner.tree().path(Room::at(0, 0)).back(), Room::at(0, 4));
    EXPECT_EQ(learner.tree().path(Room::at(2, 0)).back(), Room::at(0, 4)) << "not worth staying for";
}

TEST(SspqlGoals, AnEmptyListGoesBackToDiscoveredGoals) {
    Sspql<> learner = guest(6);
    Room room(6);
    (void)walk(learner, room, Room::at(0, 0), Room::at(4, 4));
    ASSERT_EQ(learner.goals().size(), 1u);
    EXPECT_EQ(learner.goals()[0].state, Room::at(4, 4));
    learner.set_goals({{Room::at(1, 1)}, {Room::at(2, 2)}});
    EXPECT_EQ(learner.goals().size(), 2u);
    learner.set_goals({});
    ASSERT_EQ(learner.goals().size(), 1u);
    EXPECT_EQ(learner.goals()[0].state, Room::at(4, 4));
    EXPECT_EQ(steps(learner, Room::at(0, 0), Room::at(4, 4)), 8u);
}

TEST(SspqlGoals, AGoalNeverSeenIsFollowedOnceItIsReached) {
    Sspql<> learner(StateCount::growing(), Room::actions, {}, 7);
    learner.observe(state_id(0), action_id(0), 0.0, state_id(1), false);
    learner.set_goals({{state_id(2)}});
    EXPECT_EQ(learner.states(), 3u);
    EXPECT_FALSE(learner.tree().reaches_goal(state_id(0)));
    EXPECT_EQ(learner.terms(state_id(0), action_id(0)).ssp, 0.0);
    EXPECT_NO_THROW((void)learner.begin(state_id(0)));
    learner.abort();
    learner.observe(state_id(1), action_id(3), 1.0, state_id(2), true);
    EXPECT_EQ(learner.ssp_values().action(state_id(0)), action_id(0));
    EXPECT_EQ(learner.ssp_values().action(state_id(1)), action_id(3));
}

TEST(SspqlGoals, UnreachableGoalsLeaveQAlone) {
    Sspql<> learner(6, 2, {}, 8);
    learner.set_goals({{state_id(5)}});
    for (int k = 0; k < 50; ++k) {  // 0 .. 2 go round, 5 cannot be reached
        (void)learner.begin(state_id(0));
        for (std::size_t i = 1; i < 30; ++i) (void)learner.step(0.0, state_id(i % 3));
        learner.end(0.0, state_id(1), false);
    }
    for (std::size_t s = 0; s < 5; ++s) {
        EXPECT_FALSE(learner.tree().reaches_goal(state_id(s)));
        EXPECT_TRUE(learner.tree().path(state_id(s)).empty());
        for (std::size_t a = 0; a < 2; ++a) EXPECT_EQ(learner.terms(state_id(s), action_id(a)).ssp, 0.0);
    }
    EXPECT_EQ(learner.tree().path(state_id(5)), std::vector<StateId>{state_id(5)});
}

template <class L>
class LearnerGoals : public ::testing::Test {};
TYPED_TEST_SUITE(LearnerGoals, AllLearners, LearnerNames);

TYPED_TEST(LearnerGoals, BadGoalsAreRefusedAndChangeNothing) {
    TypeParam learner(Room::states, Room::actions, {}, 9);
    Room room(9);
    (void)walk(learner, room, Room::at(0, 0), Room::at(4, 4));
    learner.set_goals({{state_id(3)}});
    const auto before = fingerprint(learner);
    EXPECT_THROW(learner.set_goals({{state_id(1)}, {state_id(25)}}), std::invalid_argument);
    EXPECT_THROW(learner.set_goals({{no_state}}), std::invalid_argument);
    for (const double bad : {-1.0, not_a_number, infinity}) {
        EXPECT_THROW(learner.set_goals({{state_id(1), bad}}), std::invalid_argument);
    }
    EXPECT_EQ(fingerprint(learner), before);
}

template <class L>
class ValueLearnerGoals : public ::testing::Test {};
TYPED_TEST_SUITE(ValueLearnerGoals, ValueLearners, LearnerNames);

TYPED_TEST(ValueLearnerGoals, OtherGoalsResetValuesAndVisits) {
    TypeParam learner(Room::states, Room::actions, {}, 9);
    Room room(9);
    for (int k = 0; k < 5; ++k) (void)walk(learner, room, Room::at(0, 0), Room::at(4, 4));
    learner.set_goals({{state_id(3)}});
    for (std::size_t s = 0; s < Room::states; ++s) {
        for (std::size_t a = 0; a < Room::actions; ++a) {
            EXPECT_EQ(learner.q()(state_id(s), action_id(a)), learner.params().initial_q);
            EXPECT_EQ(learner.visits()(state_id(s), action_id(a)), 0u);
        }
    }
}
