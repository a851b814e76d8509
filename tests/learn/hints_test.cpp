// SPDX-License-Identifier: MIT
#include <sspql/learn/hints.hpp>

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <sspql/learn/q_learning.hpp>
#include <sspql/learn/sspql.hpp>

namespace sspql_hints_test {

using namespace sspql;

namespace {

constexpr StateId s0{0}, s1{1}, s2{2};
constexpr ActionId a0{0}, a1{1};
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

template <class L>
void nothing_happens(L& learner, int times) {
    for (int k = 0; k < times; ++k) learner.observe(s0, a1, 0.0, s0, false);
}

}  // namespace

TEST(Hints, AreNothingUntilOneIsGiven) {
    Hints hints(2);
    EXPECT_TRUE(hints.empty());
    EXPECT_EQ(hints(s2, a1, 0, VisitDecay{}), 0.0);
    hints.set(s0, a1, 0.5, 0, 1);
    EXPECT_FALSE(hints.empty());
    EXPECT_EQ(hints(s0, a1, 0, VisitDecay{}), 0.5);
    EXPECT_EQ(hints(s0, a0, 0, VisitDecay{}), 0.0);
    EXPECT_EQ(hints(s2, a1, 0, VisitDecay{}), 0.0) << "a state added since";
    hints.clear();
    EXPECT_TRUE(hints.empty());
}

TEST(Hints, FadeWithTheVisitsSinceTheyWereGiven) {
    Hints hints(2);
    hints.set(s0, a0, 3.0, 10, 1);
    EXPECT_EQ(hints(s0, a0, 10, VisitDecay{}), 3.0);
    EXPECT_EQ(hints(s0, a0, 11, VisitDecay{}), 3.0);
    EXPECT_EQ(hints(s0, a0, 12, VisitDecay{}), 0.75);
    EXPECT_EQ(hints(s0, a0, 14, VisitDecay{}), 3.0 / 16.0);
    EXPECT_EQ(hints(s0, a0, 14, Constant{0.5}), 1.5);
    hints.set(s0, a0, -1.0, 14, 1);
    EXPECT_EQ(hints(s0, a0, 14, VisitDecay{}), -1.0) << "a new one replaces the old one";
}

template <class L>
class Teaching : public ::testing::Test {};
using Learners = ::testing::Types<QLearning<>, Sspql<>>;
TYPED_TEST_SUITE(Teaching, Learners);

TYPED_TEST(Teaching, AHintIsFollowedAndShowsInTheTerms) {
    TypeParam learner(3, 2, {}, 1);
    learner.teach(s0, a1);
    EXPECT_EQ(learner.terms(s0, a1).hint, 1.0);
    EXPECT_EQ(learner.terms(s0, a1).sum(), 1.0 + learner.terms(s0, a1).exploration);
    EXPECT_EQ(learner.terms(s0, a0).hint, 0.0);
    EXPECT_EQ(learner.begin(s0), a1);
    learner.abort();
    EXPECT_EQ(learner.best(s0), a0) << "best() is what was learnt, not what was told";
    EXPECT_EQ(learner.q()(s0, a1), 0.0);
}

// 1, 1, 1/4, 1/9: nothing came of it.
TYPED_TEST(Teaching, AHintFadesAsItIsTried) {
    TypeParam learner(3, 2);
    nothing_happens(learner, 7);  // visits before the hint do not count
    learner.teach(s0, a1);
    for (const double left : {1.0, 1.0, 0.25, 1.0 / 9.0}) {
        EXPECT_DOUBLE_EQ(learner.terms(s0, a1).hint, left);
        nothing_happens(learner, 1);
    }
    learner.teach(s0, a1, 0.5);
    EXPECT_EQ(learner.terms(s0, a1).hint, 0.5);
    learner.teach(s0, a1, 0.0);
    EXPECT_EQ(learner.terms(s0, a1).hint, 0.0);
}

TYPED_TEST(Teaching, AWarningLastsAsLongAsItIsHeeded) {
    typename TypeParam::Params params;
    params.w_exp = 0.0;
    TypeParam learner(3, 2, params, 1);
    learner.teach(s0, a1, -1.0);
    EXPECT_EQ(learner.begin(s0), a0);
    for (int k = 0; k < 1000; ++k) EXPECT_EQ(learner.step(0.0, s0), a0);
    EXPECT_EQ(learner.terms(s0, a1).hint, -1.0);
    nothing_happens(learner, 100);
    EXPECT_DOUBLE_EQ(learner.terms(s0, a1).hint, -1e-4) << "it fades only as it is ignored";
}

TYPED_TEST(Teaching, ADemonstrationTeachesItsActionAndWhatCameOfIt) {
    TypeParam shown(3, 2, {}, 1), told(3, 2, {}, 1);
    shown.demonstrate({s0, a1, 0.0, s1, false});
    shown.demonstrate({s1, a1, 1.0, s2, true}, 0.5);
    told.observe(s0, a1, 0.0, s1, false);
    told.teach(s0, a1);
    told.observe(s1, a1, 1.0, s2, true);
    told.teach(s1, a1, 0.5);
    for (const StateId s : {s0, s1}) {
        EXPECT_EQ(shown.terms(s, a1).sum(), told.terms(s, a1).sum());
        EXPECT_EQ(shown.terms(s, a1).n, 1.0);
        EXPECT_EQ(shown.begin(s), a1);
        shown.abort();
    }
    EXPECT_EQ(shown.terms(s0, a1).hint, 1.0) << "the demonstration itself does not count as a visit since";
    EXPECT_EQ(shown.terms(s1, a1).hint, 0.5);
    EXPECT_EQ(shown.q()(s1, a1), 0.8);
}

TYPED_TEST(Teaching, IllegalHintsAreNotFollowed) {
    TypeParam learner(3, 2, {}, 1);
    learner.teach(s0, a1);
    learner.set_legal_actions(s0, ActionSet::of(2, {a0}));
    EXPECT_EQ(learner.begin(s0), a0);
}

TYPED_TEST(Teaching, OtherGoalsTakeHintsBack) {
    TypeParam learner(3, 2);
    learner.teach(s0, a1);
    learner.set_goals({{s1}});
    EXPECT_EQ(learner.terms(s0, a1).hint, 0.0);
}

TYPED_TEST(Teaching, AHintMayComeBeforeItsState) {
    TypeParam learner(StateCount::growing(), 2);
    learner.teach(s0, a1);
    EXPECT_EQ(learner.states(), 1u);
    EXPECT_EQ(learner.begin(s0), a1);
    (void)learner.step(0.0, s1);
    learner.teach(s2, a1);
    EXPECT_EQ(learner.terms(s2, a1).hint, 1.0);
    EXPECT_EQ(learner.terms(s1, a1).hint, 0.0);
    EXPECT_THROW(learner.teach(StateId{4}, a1), std::invalid_argument) << "state 3 comes first";
}

TYPED_TEST(Teaching, WhatIsRefusedChangesNothing) {
    TypeParam learner(3, 2);
    EXPECT_THROW(learner.teach(StateId{3}, a0), std::invalid_argument);
    EXPECT_THROW(learner.teach(s0, ActionId{2}), std::invalid_argument);
    EXPECT_THROW(learner.teach(s0, a0, not_a_number), std::invalid_argument);
    EXPECT_THROW(learner.demonstrate({s0, a0, 1.0, s1, true}, not_a_number), std::invalid_argument);
    EXPECT_THROW(learner.demonstrate({s0, a0, not_a_number, s1, true}), std::invalid_argument);
    EXPECT_THROW(learner.demonstrate({s0, a0, 1.0, StateId{3}, true}), std::invalid_argument);
    EXPECT_EQ(learner.visits()(s0, a0), 0u);
    EXPECT_EQ(learner.terms(s0, a0).hint, 0.0);
}

}  // namespace sspql_hints_test
