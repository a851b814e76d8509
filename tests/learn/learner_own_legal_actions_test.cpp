// SPDX-License-Identifier: MIT
#include <sspql/spaces/legal_actions.hpp>

#include <stdexcept>

#include "learn/learner_testing.hpp"

using namespace sspql;
using namespace sspql::testing;

namespace {

/// A user's rule: in state s only action s, so none from state `actions` on.
struct Diagonal {
    struct Allowed {
        StateId s;
        bool contains(ActionId a) const { return index(a) == index(s); }
    };
    Allowed allowed(StateId s) const { return {s}; }
};

/// A user's rule that also keeps a mask: one for all states, nothing at first.
struct OneMask {
    ActionSet mask = ActionSet::none(2);
    const ActionSet& allowed(StateId) const { return mask; }
    void set(StateId, const ActionSet& given) { mask = given; }
};

template <class Base, class Legal>
struct With : Base {
    using LegalActions = Legal;
};

template <class L>
struct Kind;
template <template <class> class L, class Policies>
struct Kind<L<Policies>> {
    template <class Legal>
    using Learner = L<With<Policies, Legal>>;
};

}  // namespace

template <class L>
class LearnerOwnLegalActions : public ::testing::Test {};
TYPED_TEST_SUITE(LearnerOwnLegalActions, AllLearners, LearnerNames);

TYPED_TEST(LearnerOwnLegalActions, AreObeyed) {
    typename Kind<TypeParam>::template Learner<Diagonal> learner(4, 4);
    for (int k = 0; k < 100; ++k) {
        EXPECT_EQ(learner.begin(state_id(0)), action_id(0));
        EXPECT_EQ(learner.step(0.0, state_id(2)), action_id(2));
        EXPECT_EQ(learner.best(state_id(3)), action_id(3));
        learner.end(1.0, state_id(1), true);
    }
}

TYPED_TEST(LearnerOwnLegalActions, ThatAllowNothingAreRuntimeErrorsAndChangeNothing) {
    typename Kind<TypeParam>::template Learner<Diagonal> learner(4, 2);
    EXPECT_THROW((void)learner.begin(state_id(2)), std::runtime_error);
    EXPECT_FALSE(learner.running());
    EXPECT_THROW((void)learner.best(state_id(3)), std::runtime_error);
    (void)learner.begin(state_id(0));
    EXPECT_THROW((void)learner.step(1.0, state_id(2)), std::runtime_error);
    EXPECT_THROW(learner.end(1.0, state_id(2), false), std::runtime_error) << "its future value needs an action";
    EXPECT_THROW(learner.observe(state_id(0), action_id(0), 1.0, state_id(3), false), std::runtime_error);
    EXPECT_EQ(learner.visits()(state_id(0), action_id(0)), 0u);
    EXPECT_TRUE(learner.running());
    EXPECT_EQ(learner.state(), state_id(0));
    EXPECT_NO_THROW(learner.end(1.0, state_id(2), true)) << "a terminal state needs no action";
}

TYPED_TEST(LearnerOwnLegalActions, ThatAllowNothingAddNoState) {
    typename Kind<TypeParam>::template Learner<Diagonal> learner(StateCount::growing(), 2);
    learner.grow(2);
    EXPECT_THROW((void)learner.begin(state_id(2)), std::runtime_error);
    (void)learner.begin(state_id(1));
    EXPECT_THROW((void)learner.step(1.0, state_id(2)), std::runtime_error);
    EXPECT_EQ(learner.states(), 2u);
}

TYPED_TEST(LearnerOwnLegalActions, ThatKeepMasksAreCheckedToo) {
    typename Kind<TypeParam>::template Learner<OneMask> learner(4, 2);
    EXPECT_THROW((void)learner.begin(state_id(0)), std::runtime_error);
    EXPECT_FALSE(learner.running());
    learner.set_legal_actions(state_id(3), ActionSet::of(2, {action_id(1)}));
    EXPECT_EQ(learner.begin(state_id(0)), action_id(1));
}

TYPED_TEST(LearnerOwnLegalActions, AllActionsActsLikeATableWithoutMasks) {
    TypeParam table(Room::states, Room::actions, {}, 4);
    typename Kind<TypeParam>::template Learner<AllActions> all(Room::states, Room::actions, {}, 4);
    Room room(4, 0.1);
    Room same(4, 0.1);
    for (int k = 0; k < 10; ++k) {
        EXPECT_EQ(walk(table, room, Room::at(0, 0), Room::at(4, 4)), walk(all, same, Room::at(0, 0), Room::at(4, 4)));
    }
    EXPECT_EQ(table.q().matrix(), all.q().matrix());
}
