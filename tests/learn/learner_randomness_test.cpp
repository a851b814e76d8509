// SPDX-License-Identifier: MIT
#include <sspql/learn/learner.hpp>

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "learn/learner_testing.hpp"

using namespace sspql;
using namespace sspql::testing;

namespace {

template <class L>
std::vector<ActionId> life(L& learner, std::uint64_t world, int episodes = 8) {
    Room room(world, 0.1);
    std::vector<ActionId> chosen;
    for (int k = 0; k < episodes; ++k) {
        const auto episode = walk(learner, room, Room::at(0, 0), Room::at(4, 4));
        chosen.insert(chosen.end(), episode.begin(), episode.end());
    }
    return chosen;
}

}  // namespace

template <class L>
class LearnerRandomness : public ::testing::Test {};
TYPED_TEST_SUITE(LearnerRandomness, AllLearners, LearnerNames);

TYPED_TEST(LearnerRandomness, SameSeedSameBits) {
    TypeParam a(Room::states, Room::actions, {}, 11);
    TypeParam b(Room::states, Room::actions, {}, 11);
    EXPECT_EQ(life(a, 1), life(b, 1));
    EXPECT_EQ(fingerprint(a), fingerprint(b));
}

TYPED_TEST(LearnerRandomness, AnotherSeedChoosesOtherwise) {
    TypeParam a(Room::states, Room::actions, {}, 11);
    TypeParam b(Room::states, Room::actions, {}, 12);
    EXPECT_NE(life(a, 1), life(b, 1));
}

TYPED_TEST(LearnerRandomness, ACopyIsIndependent) {
    TypeParam original(Room::states, Room::actions, {}, 11);
    (void)life(original, 1);
    TypeParam copy = original;
    TypeParam untouched = original;
    const auto before = fingerprint(original);
    const auto chosen = life(copy, 2, 20);
    EXPECT_EQ(fingerprint(original), before) << "the copy learns for itself";
    EXPECT_EQ(life(original, 2, 20), chosen) << "and forks the random sequence";
    copy = untouched;
    EXPECT_EQ(fingerprint(copy), before);
    EXPECT_EQ(life(copy, 2, 20), chosen);
}

TYPED_TEST(LearnerRandomness, AMovedLearnerGoesOn) {
    TypeParam original(Room::states, Room::actions, {}, 11);
    (void)life(original, 1);
    TypeParam twin = original;
    TypeParam moved = std::move(original);
    EXPECT_EQ(life(moved, 2), life(twin, 2));
    EXPECT_EQ(fingerprint(moved), fingerprint(twin));
}

TYPED_TEST(LearnerRandomness, BestIsDeterministicAndLearnsNothing) {
    TypeParam learner(Room::states, Room::actions, {}, 11);
    (void)life(learner, 1);
    TypeParam twin = learner;
    const auto before = fingerprint(learner);
    for (std::size_t s = 0; s < Room::states; ++s) {
        const ActionId best = learner.best(state_id(s));
        for (int k = 0; k < 20; ++k) EXPECT_EQ(learner.best(state_id(s)), best);
        const auto worth = [&](std::size_t a) {
            const auto terms = learner.terms(state_id(s), action_id(a));
            const bool hope = std::is_same_v<TypeParam, AdaptiveSspql<>> && terms.n == 0.0;
            return hope ? -1e300 : terms.q + terms.ssp;  // what was never tried is not the best known
        };
        double most = -infinity;
        for (std::size_t a = 0; a < Room::actions; ++a) most = std::max(most, worth(a));
        EXPECT_EQ(worth(index(best)), most) << "no bonus, no noise";
        for (std::size_t a = 0; a < index(best); ++a) EXPECT_LT(worth(a), most) << "the least id on ties";
    }
    EXPECT_EQ(fingerprint(learner), before);
    EXPECT_EQ(life(learner, 3), life(twin, 3)) << "best() draws no random number";
}

template <class L>
class ValueLearnerRandomness : public ::testing::Test {};
TYPED_TEST_SUITE(ValueLearnerRandomness, ValueLearners, LearnerNames);

TYPED_TEST(ValueLearnerRandomness, TermsOfAFreshLearner) {
    typename TypeParam::Params params;
    params.initial_q = 0.5;
    params.w_exp = 0.1;
    const TypeParam learner(4, 2, params);
    const ActionTerms terms = learner.terms(state_id(1), action_id(1));
    EXPECT_EQ(terms.q, 0.5);
    EXPECT_EQ(terms.ssp, 0.0);
    EXPECT_EQ(terms.exploration, 0.1);
    EXPECT_EQ(terms.n, 0.0);
    EXPECT_EQ(terms.sum(), 0.6);
    EXPECT_EQ(learner.best(state_id(1)), action_id(0));
}
