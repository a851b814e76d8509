// SPDX-License-Identifier: MIT
#include <sspql/learn/learner.hpp>

#include <stdexcept>

#include "learn/learner_testing.hpp"

using namespace sspql;
using namespace sspql::testing;

template <class L>
class LearnerOrder : public ::testing::Test {
protected:
    L learner_{Room::states, Room::actions, typename L::Params(), 5};
    Room room_{5, 0.1};
};
TYPED_TEST_SUITE(LearnerOrder, AllLearners, LearnerNames);

TYPED_TEST(LearnerOrder, OutcomesBeforeBeginAreLogicErrorsAndChangeNothing) {
    auto& learner = this->learner_;
    const auto refused = [&] {
        const auto before = fingerprint(learner);
        EXPECT_THROW((void)learner.step(0.0, state_id(1)), std::logic_error);
        EXPECT_THROW(learner.end(1.0, state_id(1), true), std::logic_error);
        EXPECT_THROW(learner.replace_action(action_id(0)), std::logic_error);
        EXPECT_EQ(fingerprint(learner), before);
    };
    refused();
    (void)walk(learner, this->room_, Room::at(0, 0), Room::at(4, 4));
    refused();  // after an end
    (void)learner.begin(Room::at(0, 0));
    learner.abort();
    refused();  // after an abort
}

TYPED_TEST(LearnerOrder, BeginDuringAnEpisodeIsALogicErrorAndChangesNothing) {
    auto& learner = this->learner_;
    (void)walk(learner, this->room_, Room::at(0, 0), Room::at(4, 4));
    const ActionId a = learner.begin(Room::at(2, 2));
    const auto before = fingerprint(learner);
    EXPECT_THROW((void)learner.begin(Room::at(0, 0)), std::logic_error);
    EXPECT_EQ(fingerprint(learner), before);
    EXPECT_EQ(learner.action(), a);
    EXPECT_EQ(learner.state(), Room::at(2, 2));
    EXPECT_NO_THROW((void)learner.step(0.0, Room::at(2, 3)));
}

TYPED_TEST(LearnerOrder, RefusedCallsLeaveNoTraceInLaterActions) {
    auto& learner = this->learner_;
    TypeParam twin{Room::states, Room::actions, {}, 5};
    Room other{5, 0.1};
    for (int episode = 0; episode < 10; ++episode) {
        EXPECT_THROW((void)learner.step(0.0, state_id(1)), std::logic_error);
        EXPECT_THROW((void)learner.begin(state_id(Room::states)), std::invalid_argument);
        EXPECT_THROW(learner.observe(state_id(0), action_id(9), 0.0, state_id(1), true), std::invalid_argument);
        const auto chosen = walk(learner, this->room_, Room::at(0, 0), Room::at(4, 4));
        ASSERT_EQ(chosen, walk(twin, other, Room::at(0, 0), Room::at(4, 4))) << "episode " << episode;
    }
    EXPECT_EQ(fingerprint(learner), fingerprint(twin));
}

TYPED_TEST(LearnerOrder, RunningTellsWhetherAnEpisodeIsUnderWay) {
    auto& learner = this->learner_;
    EXPECT_FALSE(learner.running());
    EXPECT_EQ(learner.action(), no_action);
    const ActionId a = learner.begin(state_id(3));
    EXPECT_TRUE(learner.running());
    EXPECT_EQ(learner.state(), state_id(3));
    EXPECT_EQ(learner.action(), a);
    const ActionId b = learner.step(0.0, state_id(4));
    EXPECT_EQ(learner.state(), state_id(4));
    EXPECT_EQ(learner.action(), b);
    learner.end(0.0, state_id(9), false);
    EXPECT_FALSE(learner.running());
}

TYPED_TEST(LearnerOrder, AbortDropsTheActionWhoseOutcomeNobodyTells) {
    auto& learner = this->learner_;
    learner.abort();  // between episodes: nothing
    const ActionId first = learner.begin(state_id(0));
    const ActionId second = learner.step(0.5, state_id(1));
    learner.abort();
    EXPECT_FALSE(learner.running());
    EXPECT_EQ(learner.visits()(state_id(0), first), 1u) << "what was learnt before stays";
    EXPECT_GT(learner.q()(state_id(0), first), 0.0);
    EXPECT_EQ(learner.visits()(state_id(1), second), 0u);
    learner.abort();
    EXPECT_NO_THROW((void)learner.begin(state_id(0)));
}

TYPED_TEST(LearnerOrder, ReplacedActionIsTheOneThatLearns) {
    auto& learner = this->learner_;
    const ActionId chosen = learner.begin(state_id(0));
    const ActionId other = action_id((index(chosen) + 1) % Room::actions);
    EXPECT_THROW(learner.replace_action(action_id(Room::actions)), std::invalid_argument);
    EXPECT_THROW(learner.replace_action(no_action), std::invalid_argument);
    EXPECT_EQ(learner.action(), chosen);
    learner.replace_action(other);
    EXPECT_EQ(learner.action(), other);
    (void)learner.step(1.0, state_id(1));
    EXPECT_EQ(learner.visits()(state_id(0), chosen), 0u);
    EXPECT_EQ(learner.visits()(state_id(0), other), 1u);
}
