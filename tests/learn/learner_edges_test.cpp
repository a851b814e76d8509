// SPDX-License-Identifier: MIT
// Learners at the ends of the ranges: rewards of 1e100 and 1e-300, weights of 1e-30 and 1e30, one state, no states.
#include <sspql/learn/learner.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <sspql/core/serialization.hpp>
#include <sspql/learn/visit_counts.hpp>

#include "learn/learner_testing.hpp"

using namespace sspql;
using namespace sspql::testing;

namespace {

/// Whether all that enters a choice is a number.
template <class L>
bool is_finite(const L& learner) {
    for (std::size_t s = 0; s < learner.states(); ++s) {
        for (std::size_t a = 0; a < learner.actions(); ++a) {
            const ActionTerms terms = learner.terms(state_id(s), action_id(a));
            if (!std::isfinite(learner.q()(state_id(s), action_id(a))) || !std::isfinite(terms.sum())) return false;
        }
    }
    return true;
}

/// 40 episodes; `reward(home, step)` and `weight(step)` say what a step brings.
template <class L, class Reward, class Weight>
void live(L& learner, Reward reward, Weight weight) {
    Room room(2, 0.1);
    for (int episode = 0; episode < 40; ++episode) {
        StateId s = Room::at(0, 0);
        (void)learner.begin(s);
        for (int i = 0;; ++i) {
            s = room.step(s, learner.action());
            const bool home = s == Room::at(4, 4);
            if (home || i == 300) {
                learner.end(reward(home, i), s, home, weight(i));
                break;
            }
            (void)learner.step(reward(false, i), s, weight(i));
        }
        ASSERT_TRUE(is_finite(learner)) << "episode " << episode;
    }
}

constexpr auto weight_1 = [](int) { return 1.0; };

}  // namespace

template <class L>
class LearnerEdges : public ::testing::Test {};
TYPED_TEST_SUITE(LearnerEdges, AllLearners, LearnerNames);

TYPED_TEST(LearnerEdges, HugeRewardsStayNumbers) {
    for (const double huge : {max_reward, -max_reward}) {
        SCOPED_TRACE(huge);
        TypeParam at_goal(Room::states, Room::actions, {}, 2);
        live(
            at_goal, [&](bool home, int) { return home ? huge : 0.0; }, weight_1);
        TypeParam everywhere(Room::states, Room::actions, {}, 2);
        live(
            everywhere, [&](bool home, int i) { return home         ? huge
                                                       : i % 2 == 0 ? -huge
                                                                    : huge / 2.0; }, weight_1);
    }
}

TYPED_TEST(LearnerEdges, LargerOnesAreRefused) {
    TypeParam learner(2, 1);
    (void)learner.begin(state_id(0));
    for (const double larger : {std::nextafter(max_reward, infinity), -1.7e308}) {
        EXPECT_THROW((void)learner.step(larger, state_id(1)), std::invalid_argument) << larger;
        EXPECT_THROW(learner.observe(state_id(0), action_id(0), larger, state_id(1), false), std::invalid_argument);
    }
    EXPECT_EQ(learner.visits()(state_id(0), action_id(0)), 0u);
}

TYPED_TEST(LearnerEdges, TinyRewardsStayNumbers) {
    for (const double tiny : {1e-300, -1e-300}) {
        SCOPED_TRACE(tiny);
        TypeParam learner(Room::states, Room::actions, {}, 2);
        live(
            learner, [&](bool home, int) { return home ? tiny : 0.0; }, weight_1);
    }
}

TYPED_TEST(LearnerEdges, TheLeastAndTheGreatestWeightsStayNumbers) {
    TypeParam learner(Room::states, Room::actions, {}, 2);
    live(
        learner, [](bool home, int) { return home ? 1.0 : 0.0; },
        [](int i) { return i % 3 == 0   ? 1e-30
                           : i % 3 == 1 ? 1e30
                                        : 1.0; });
}

TYPED_TEST(LearnerEdges, OneStateAndOneActionAreEnough) {
    TypeParam learner(1, 1);
    for (int episode = 0; episode < 20; ++episode) {
        EXPECT_EQ(learner.begin(state_id(0)), action_id(0));
        EXPECT_EQ(learner.step(-0.5, state_id(0)), action_id(0));
        learner.end(1.0, state_id(0), true);
        EXPECT_EQ(learner.best(state_id(0)), action_id(0));
    }
    EXPECT_TRUE(is_finite(learner));
    learner.set_goals({{state_id(0), 0.0}});
    EXPECT_EQ(learner.begin(state_id(0)), action_id(0));
    learner.end(0.0, state_id(0), false);
    EXPECT_TRUE(is_finite(learner));
}

TYPED_TEST(LearnerEdges, WithoutStatesThereIsNothingToChoose) {
    TypeParam learner(StateCount::growing(), 2);
    EXPECT_THROW((void)learner.best(state_id(0)), std::invalid_argument);
    EXPECT_THROW((void)learner.terms(state_id(0), action_id(0)), std::invalid_argument);
    EXPECT_THROW((void)learner.begin(state_id(1)), std::invalid_argument);
    learner.set_goals({});
    learner.abort();
    EXPECT_EQ(learner.states(), 0u);
    (void)learner.begin(state_id(0));
    EXPECT_EQ(learner.states(), 1u);
    EXPECT_TRUE(is_finite(learner));
}

TYPED_TEST(LearnerEdges, AMaskWithoutActionsIsRefused) {
    TypeParam learner(3, 2);
    try {
        learner.set_legal_actions(state_id(1), ActionSet::none(2));
        ADD_FAILURE() << "not refused";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "mask of state 1 must allow an action; actions, got 0");
    }
    EXPECT_TRUE(learner.legal_actions().allowed(state_id(1)).contains(action_id(1)));
}

// 2^32 - 1 visits are as many as are counted.
TEST(VisitCountsEdges, StopAtTheLargestNumber) {
    struct NearTheEnd {
        void fixed(std::vector<std::uint32_t>& visits) { visits.assign(visits.size(), 0xFFFFFFFEu); }
    } near_the_end;
    VisitCounts visits(1, 1);
    SerializationAccess::serialize(visits, near_the_end);
    visits.add(state_id(0), action_id(0));
    EXPECT_EQ(visits(state_id(0), action_id(0)), 0xFFFFFFFFu);
    visits.add(state_id(0), action_id(0));
    EXPECT_EQ(visits(state_id(0), action_id(0)), 0xFFFFFFFFu);
}
