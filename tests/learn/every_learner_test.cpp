// SPDX-License-Identifier: MIT
// What every learner of the interface keeps to, for those besides QLearning and Sspql.
#include <sspql/learn/learner.hpp>

#include <stdexcept>
#include <type_traits>

#include "learn/learner_testing.hpp"

#include <sspql/learn/dyna_q.hpp>
#include <sspql/learn/dyna_q_plus.hpp>
#include <sspql/learn/prioritized_sweeping.hpp>
#include <sspql/learn/r_max.hpp>
#include <sspql/learn/rtdp.hpp>
#include <sspql/learn/sarsa.hpp>

namespace sspql_every_learner_test {

using namespace sspql;
using namespace sspql::testing;

namespace {

/// A user's own rule: in the first half of the states only action 0 is legal.
struct FirstHalf {
    struct Allowed {
        bool all;
        [[nodiscard]] bool contains(ActionId a) const { return all || index(a) == 0; }
    };
    [[nodiscard]] Allowed allowed(StateId s) const { return {index(s) >= 13}; }
};
struct OwnValues : ValuePolicies {
    using Selector = Boltzmann;
    using LegalActions = FirstHalf;
};
struct OwnModels : ModelPolicies {
    using Selector = EpsilonGreedy;
    using LegalActions = FirstHalf;
};

using Rivals = ::testing::Types<Sarsa<>, DynaQ<>, DynaQPlus<>, PrioritizedSweeping<>, Rtdp<>, RMax<>>;
using OwnRivals = ::testing::Types<Sarsa<OwnValues>, DynaQ<OwnModels>, DynaQPlus<OwnValues>,
                                   PrioritizedSweeping<OwnModels>, Rtdp<OwnModels>, RMax<OwnModels>>;

constexpr ActionId a0{0}, a1{1};

}  // namespace

template <class L>
class EveryLearner : public ::testing::Test {};
TYPED_TEST_SUITE(EveryLearner, Rivals);

TYPED_TEST(EveryLearner, FindsAShortWayThroughTheRoom) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        TypeParam learner(Room::states, Room::actions, {}, seed);
        Room room(seed);
        for (int k = 0; k < 40; ++k) (void)walk(learner, room, Room::at(0, 0), Room::at(4, 4));
        EXPECT_LE(walk(learner, room, Room::at(0, 0), Room::at(4, 4)).size(), 12u) << "seed " << seed << "; 8 at best";
    }
}

TYPED_TEST(EveryLearner, TheSameSeedGivesTheSameBits) {
    TypeParam one(Room::states, Room::actions, {}, 3), two(Room::states, Room::actions, {}, 3);
    Room room(3, 0.2), same(3, 0.2);
    for (int k = 0; k < 20; ++k) {
        EXPECT_EQ(walk(one, room, Room::at(0, 0), Room::at(4, 4)), walk(two, same, Room::at(0, 0), Room::at(4, 4)));
    }
    EXPECT_EQ(fingerprint(one), fingerprint(two));
    TypeParam copy = one;
    EXPECT_EQ(walk(one, room, Room::at(0, 0), Room::at(4, 4)), walk(copy, same, Room::at(0, 0), Room::at(4, 4)));
}

TYPED_TEST(EveryLearner, LearnsTheSameWithStatesMetOneByOneAndWithReservedOnes) {
    TypeParam fixed(Room::states, Room::actions, {}, 4), growing(StateCount::growing(), Room::actions, {}, 4);
    TypeParam reserved(Room::states, Room::actions, {}, 4);
    reserved.reserve(Room::states);
    growing.reserve(3);
    Room room(4, 0.1), same(4, 0.1), again(4, 0.1);
    for (std::size_t n = 1; n <= Room::states; ++n) {
        if (n % 2 == 0) growing.grow(n);  // else teach admits it
        growing.teach(state_id(n - 1), a0, 0.0);
        fixed.teach(state_id(n - 1), a0, 0.0);
        EXPECT_EQ(growing.states(), n);
    }
    for (int k = 0; k < 20; ++k) {
        const auto chosen = walk(fixed, room, Room::at(0, 0), Room::at(4, 4));
        EXPECT_EQ(chosen, walk(growing, same, Room::at(0, 0), Room::at(4, 4)));
        EXPECT_EQ(chosen, walk(reserved, again, Room::at(0, 0), Room::at(4, 4)));
    }
    EXPECT_EQ(fingerprint(fixed), fingerprint(growing));
    EXPECT_EQ(fingerprint(fixed), fingerprint(reserved));
    EXPECT_THROW((void)growing.begin(state_id(Room::states + 1)), std::invalid_argument);
    EXPECT_TRUE(growing.grows() && !fixed.grows());
}

TYPED_TEST(EveryLearner, MeetsNewStatesInTheMiddleOfAnEpisode) {
    TypeParam learner(StateCount::growing(), 2, {}, 5);
    (void)learner.begin(state_id(0));
    for (std::size_t s = 1; s < 200; ++s) (void)learner.step(0.0, state_id(s));
    learner.end(1.0, state_id(200), true);
    learner.observe(state_id(201), a1, 0.5, state_id(202), true);
    EXPECT_EQ(learner.states(), 203u);
    for (std::size_t s = 0; s < 203; ++s) EXPECT_NO_THROW((void)learner.terms(state_id(s), a1));
}

TYPED_TEST(EveryLearner, ChoosesLegalActionsOnly) {
    TypeParam learner(Room::states, Room::actions, {}, 6);
    for (std::size_t s = 0; s < Room::states; ++s) {
        learner.set_legal_actions(state_id(s), ActionSet::of(4, {action_id(s % 2), action_id(2)}));
    }
    Random world(6);
    StateId s = state_id(0);
    ActionId a = learner.begin(s);
    for (int k = 0; k < 3000; ++k) {
        ASSERT_TRUE(index(a) == index(s) % 2 || index(a) == 2) << "step " << k;
        const ActionId best = learner.best(s);
        ASSERT_TRUE(index(best) == index(s) % 2 || index(best) == 2);
        s = state_id(world.below(Room::states));
        a = learner.step(world.uniform(-1.0, 1.0), s);
    }
}

TYPED_TEST(EveryLearner, AReplacedActionIsTheOneLearntAbout) {
    TypeParam learner(3, 2, {}, 7);
    const ActionId chosen = learner.begin(state_id(0));
    const ActionId other = chosen == a0 ? a1 : a0;
    learner.replace_action(other);
    EXPECT_EQ(learner.action(), other);
    learner.end(1.0, state_id(1), true);
    EXPECT_EQ(learner.visits()(state_id(0), other), 1u);
    EXPECT_EQ(learner.visits()(state_id(0), chosen), 0u);
}

TYPED_TEST(EveryLearner, AnAbortedEpisodeLeavesNothingPending) {
    TypeParam learner(3, 2, {}, 8);
    (void)learner.begin(state_id(0));
    (void)learner.step(0.5, state_id(1));
    const auto q = learner.q().matrix().eval();
    learner.abort();
    EXPECT_FALSE(learner.running());
    EXPECT_EQ(learner.q().matrix(), q);
    EXPECT_THROW((void)learner.step(0.0, state_id(1)), std::logic_error);
    EXPECT_NO_THROW((void)learner.begin(state_id(2)));
}

TYPED_TEST(EveryLearner, OtherGoalsResetValuesVisitsAndHints) {
    TypeParam learner(Room::states, Room::actions, {}, 9);
    Room room(9);
    for (int k = 0; k < 5; ++k) (void)walk(learner, room, Room::at(0, 0), Room::at(4, 4));
    learner.teach(state_id(0), a1);
    learner.set_goals({{state_id(3)}});
    for (std::size_t s = 0; s < Room::states; ++s) {
        for (std::size_t a = 0; a < Room::actions; ++a) {
            EXPECT_EQ(learner.q()(state_id(s), action_id(a)), learner.params().initial_q);
            EXPECT_EQ(learner.visits()(state_id(s), action_id(a)), 0u);
        }
    }
    EXPECT_EQ(learner.terms(state_id(0), a1).hint, 0.0);
    for (int k = 0; k < 60; ++k) (void)walk(learner, room, Room::at(4, 4), Room::at(0, 4));
    EXPECT_LE(walk(learner, room, Room::at(4, 4), Room::at(0, 4)).size(), 12u) << "and learns the way to another one";
}

TYPED_TEST(EveryLearner, RefusedOutcomesChangeNothing) {
    TypeParam learner(3, 2, {}, 10);
    (void)learner.begin(state_id(0));
    const auto before = fingerprint(learner);
    for (const double bad : bad_rewards) EXPECT_THROW((void)learner.step(bad, state_id(1)), std::invalid_argument);
    for (const double bad : bad_weights) EXPECT_THROW(learner.end(0.0, state_id(1), true, bad), std::invalid_argument);
    EXPECT_THROW((void)learner.step(0.0, state_id(3)), std::invalid_argument);
    EXPECT_THROW(learner.observe(state_id(0), ActionId{2}, 0.0, state_id(1), false), std::invalid_argument);
    EXPECT_THROW((void)learner.begin(state_id(0)), std::logic_error);
    EXPECT_EQ(fingerprint(learner), before);
}

template <class L>
class EveryLearnerOfOnesOwn : public ::testing::Test {};
TYPED_TEST_SUITE(EveryLearnerOfOnesOwn, OwnRivals);

TYPED_TEST(EveryLearnerOfOnesOwn, KeepsToTheUsersLegalActions) {
    TypeParam learner(Room::states, Room::actions, {}, 11);
    learner.reserve(Room::states);
    Room room(11, 0.3);
    for (int k = 0; k < 20; ++k) (void)walk(learner, room, Room::at(2, 4), Room::at(4, 4), 200);
    for (std::size_t s = 0; s < 13; ++s) {
        for (std::size_t a = 1; a < Room::actions; ++a) EXPECT_EQ(learner.visits()(state_id(s), action_id(a)), 0u);
        EXPECT_EQ(learner.best(state_id(s)), a0);
    }
}

}  // namespace sspql_every_learner_test
