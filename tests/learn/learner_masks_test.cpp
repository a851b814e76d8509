// SPDX-License-Identifier: MIT
#include <sspql/spaces/legal_actions.hpp>

#include <stdexcept>

#include "learn/learner_testing.hpp"

using namespace sspql;
using namespace sspql::testing;

namespace {

/// Each state allows some of the actions, a pattern of its own.
ActionSet pattern(std::size_t s, std::size_t actions) {
    ActionSet mask = ActionSet::none(actions);
    for (std::size_t a = 0; a < actions; ++a) {
        if ((s * 7 + a * 5) % 3 == 0) mask.insert(action_id(a));
    }
    if (mask.is_empty()) mask.insert(action_id(s % actions));
    return mask;
}

}  // namespace

template <class L>
class LearnerMasks : public ::testing::Test {};
TYPED_TEST_SUITE(LearnerMasks, AllLearners, LearnerNames);

TYPED_TEST(LearnerMasks, IllegalActionsAreNeverChosen) {
    for (const std::size_t actions : {3u, 64u, 100u}) {
        constexpr std::size_t states = 20;
        TypeParam learner(states, actions, {}, 3);
        Random world(3);
        for (std::size_t s = 0; s < states; ++s) learner.set_legal_actions(state_id(s), pattern(s, actions));
        std::size_t s = 0;
        ActionId a = learner.begin(state_id(0));
        for (int k = 0; k < 5000; ++k) {
            ASSERT_TRUE(pattern(s, actions).contains(a)) << actions << " actions, state " << s << ", step " << k;
            ASSERT_TRUE(pattern(s, actions).contains(learner.best(state_id(s))));
            const bool end = world.chance(0.05);
            s = (s * 3 + index(a) + world.below(2)) % states;
            const double reward = world.uniform(-1.0, 1.0);
            if (end) {
                learner.end(reward, state_id(s), true);
                s = world.below(states);
                a = learner.begin(state_id(s));
            } else {
                a = learner.step(reward, state_id(s));
            }
        }
    }
}

template <class L>
class ValueLearnerMasks : public ::testing::Test {};
TYPED_TEST_SUITE(ValueLearnerMasks, ValueLearners, LearnerNames);

TYPED_TEST(ValueLearnerMasks, BackupsMaximiseOverLegalActionsOnly) {
    TypeParam learner(4, 2, {}, 1);
    for (int k = 0; k < 20; ++k) {
        learner.observe(state_id(1), action_id(0), 10.0, state_id(2), true);
        learner.observe(state_id(1), action_id(1), 1.0, state_id(2), true);
    }
    TypeParam masked = learner;
    masked.set_legal_actions(state_id(1), ActionSet::of(2, {action_id(1)}));
    for (int k = 0; k < 20; ++k) {
        learner.observe(state_id(0), action_id(0), 0.0, state_id(1), false);
        masked.observe(state_id(0), action_id(0), 0.0, state_id(1), false);
    }
    EXPECT_NEAR(learner.q()(state_id(0), action_id(0)), 8.0, 1e-3);
    EXPECT_NEAR(masked.q()(state_id(0), action_id(0)), 0.8, 1e-3);
    EXPECT_EQ(learner.best(state_id(1)), action_id(0));
    EXPECT_EQ(masked.best(state_id(1)), action_id(1));
}

TYPED_TEST(LearnerMasks, TheLastMaskHolds) {
    TypeParam learner(4, 3, {}, 1);
    learner.set_legal_actions(state_id(0), ActionSet::of(3, {action_id(2)}));
    EXPECT_EQ(learner.begin(state_id(0)), action_id(2));
    learner.abort();
    learner.set_legal_actions(state_id(0), ActionSet::of(3, {action_id(1)}));
    EXPECT_EQ(learner.begin(state_id(0)), action_id(1));
}

TYPED_TEST(LearnerMasks, BadMasksAreRefusedAndChangeNothing) {
    TypeParam learner(4, 3, {}, 1);
    learner.set_legal_actions(state_id(0), ActionSet::of(3, {action_id(2)}));
    const auto before = fingerprint(learner);
    EXPECT_THROW(learner.set_legal_actions(state_id(0), ActionSet::none(3)), std::invalid_argument);
    EXPECT_THROW(learner.set_legal_actions(state_id(0), ActionSet::all(2)), std::invalid_argument);
    EXPECT_THROW(learner.set_legal_actions(state_id(0), ActionSet::all(4)), std::invalid_argument);
    EXPECT_THROW(learner.set_legal_actions(state_id(4), ActionSet::all(3)), std::invalid_argument);
    EXPECT_EQ(fingerprint(learner), before);
}

TYPED_TEST(LearnerMasks, MasksCanBeGivenWithTheParameters) {
    typename TypeParam::Params params;
    params.legal_actions.set(state_id(1), ActionSet::of(3, {action_id(2)}));
    TypeParam learner(4, 3, params, 1);
    EXPECT_EQ(learner.begin(state_id(1)), action_id(2));
    TypeParam second(4, 3, learner.params(), 2);
    EXPECT_EQ(second.begin(state_id(1)), action_id(2)) << "params() are those it was made with";
    EXPECT_THROW(TypeParam(4, 2, params), std::invalid_argument) << "masks of another number of actions";
    EXPECT_THROW(TypeParam(4, 100, params), std::invalid_argument);
}

TEST(SspqlMasks, PathsAvoidWhatBecameIllegal) {
    Sspql<> learner(3, 2);
    learner.observe(state_id(0), action_id(0), 0.0, state_id(1), false);
    learner.observe(state_id(0), action_id(1), 0.0, state_id(1), false);
    learner.observe(state_id(1), action_id(0), 1.0, state_id(2), true);
    EXPECT_EQ(learner.ssp_values().action(state_id(0)), action_id(0));
    learner.set_legal_actions(state_id(0), ActionSet::of(2, {action_id(1)}));
    learner.update_paths();
    EXPECT_EQ(learner.ssp_values().action(state_id(0)), action_id(1));
}

#if SSPQL_ENABLE_ASSERTIONS && GTEST_HAS_DEATH_TEST
namespace {

struct Stubborn {  // does not look at the mask
    template <class Allowed, class Score>
    ActionId operator()(std::size_t, const Allowed&, const Score&, Random&) const {
        return action_id(0);
    }
};
struct StubbornPolicies : SspqlPolicies {
    using Selector = Stubborn;
};

}  // namespace

TEST(SelectorDeathTest, AnIllegalChoiceIsAsserted) {
    Sspql<StubbornPolicies> learner(3, 2);
    EXPECT_EQ(learner.begin(state_id(1)), action_id(0));
    learner.abort();
    learner.set_legal_actions(state_id(0), ActionSet::of(2, {action_id(1)}));
    EXPECT_DEATH((void)learner.begin(state_id(0)), "a Selector chooses an allowed action");
}
#endif
