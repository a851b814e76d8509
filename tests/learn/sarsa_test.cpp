// SPDX-License-Identifier: MIT
#include <sspql/learn/sarsa.hpp>

#include <cmath>
#include <cstddef>
#include <deque>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/learn/action_selector.hpp>

namespace sspql_sarsa_test {

using namespace sspql;

namespace {

constexpr StateId s0{0}, s1{1}, s2{2};
constexpr ActionId a0{0}, a1{1};

/// Chooses what the script says.
struct Scripted {
    std::shared_ptr<std::deque<ActionId>> script = std::make_shared<std::deque<ActionId>>();

    template <class Allowed, class Score>
    ActionId operator()(std::size_t, const Allowed&, const Score&, Random&) const {
        const ActionId next = script->at(0);
        script->pop_front();
        return next;
    }
};

template <class S>
struct Choosing : ValuePolicies {
    using Selector = S;
};

/// alpha 1/2, gamma 0.8.
template <class Policies>
SarsaParams<Policies> half_way(typename Policies::Selector selector = typename Policies::Selector{}) {
    SarsaParams<Policies> params;
    params.alpha = 0.5;
    params.selector = std::move(selector);
    return params;
}

/// Q(1,a0) = 0.5 and Q(1,a1) = 0.1: both actions end the episode, with rewards 1 and 0.2.
///
///     0 --a0, 0.1--> 1 --a0, 1--> 2 (end)
///                      --a1, 0.2--> 2 (end)
template <class Learner>
void learn_state_1(Learner& learner) {
    learner.observe(s1, a0, 1.0, s2, true);
    learner.observe(s1, a1, 0.2, s2, true);
    ASSERT_DOUBLE_EQ(learner.q()(s1, a0), 0.5);
    ASSERT_DOUBLE_EQ(learner.q()(s1, a1), 0.1);
}

/// Q(0,a0) after 0 -a0-> 1, by expected Sarsa.
template <class S>
double expected_backup(S selector) {
    auto params = half_way<Choosing<S>>(selector);
    params.expected = true;
    Sarsa<Choosing<S>> learner(3, 2, params);
    learn_state_1(learner);
    learner.observe(s0, a0, 0.1, s1, false);
    return learner.q()(s0, a0);
}

}  // namespace

// 0.5 (0.1 + 0.8 x 0.1) = 0.09 for the a1 it takes; Q-learning would back up 0.5: 0.25.
TEST(Sarsa, BacksUpTheActionItTakesNext) {
    const Scripted selector;
    Sarsa<Choosing<Scripted>> learner(3, 2, half_way<Choosing<Scripted>>(selector));
    learn_state_1(learner);
    *selector.script = {a0, a1};
    EXPECT_EQ(learner.begin(s0), a0);
    EXPECT_EQ(learner.step(0.1, s1), a1);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.09);
    EXPECT_EQ(learner.best(s1), a0);
    EXPECT_TRUE(selector.script->empty()) << "one choice a step, for the update and the robot alike";
    learner.end(0.2, s2, true);  // Q(1,a1) = 0.1 + 0.5 (0.2 - 0.1)
    EXPECT_DOUBLE_EQ(learner.q()(s1, a1), 0.15);
    EXPECT_EQ(learner.visits()(s1, a1), 2u);
}

TEST(Sarsa, DrawsAnActionForTheUpdateWhereNobodyChoosesNext) {
    const Scripted selector;
    Sarsa<Choosing<Scripted>> learner(3, 2, half_way<Choosing<Scripted>>(selector));
    learn_state_1(learner);
    *selector.script = {a1};
    learner.observe(s0, a0, 0.1, s1, false);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.09) << "observe";
    *selector.script = {a1, a0};
    EXPECT_EQ(learner.begin(s0), a1);
    learner.end(0.1, s1, false);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a1), 0.25) << "an episode cut short: 0.5 (0.1 + 0.8 x 0.5)";
    EXPECT_TRUE(selector.script->empty());
}

TEST(Sarsa, LearnsAboutTheActionThatReplacedItsOwn) {
    const Scripted selector;
    Sarsa<Choosing<Scripted>> learner(3, 2, half_way<Choosing<Scripted>>(selector));
    *selector.script = {a0};
    EXPECT_EQ(learner.begin(s1), a0);
    learner.replace_action(a1);
    learner.end(1.0, s2, true);
    EXPECT_DOUBLE_EQ(learner.q()(s1, a1), 0.5);
    EXPECT_DOUBLE_EQ(learner.q()(s1, a0), 0.0);
    *selector.script = {a0};
    EXPECT_EQ(learner.begin(s1), a0);
    learner.abort();
    EXPECT_DOUBLE_EQ(learner.q()(s1, a0), 0.0);
}

// Half the time either, else a0: 0.5 x 0.3 + 0.5 x 0.5 = 0.4; 0.5 (0.1 + 0.8 x 0.4) = 0.21.
TEST(ExpectedSarsa, BacksUpTheMeanOfEpsilonGreedy) { EXPECT_DOUBLE_EQ(expected_backup(EpsilonGreedy(0.5)), 0.21); }

// e^{0.4 / T} = 3 for T = 0.4 / ln 3: a0 in 3 of 4 cases, 0.75 x 0.5 + 0.25 x 0.1 = 0.4.
TEST(ExpectedSarsa, BacksUpTheMeanOfBoltzmann) {
    EXPECT_NEAR(expected_backup(Boltzmann(0.4 / std::log(3.0))), 0.21, 1e-15);
}

// Noise below 0.8: a1 wins if its noise exceeds a0's by half of that: 1/2 (1/2)^2 = 1/8 of the cases.
// 7/8 x 0.5 + 1/8 x 0.1 = 0.45; 0.5 (0.1 + 0.8 x 0.45) = 0.23.
TEST(ExpectedSarsa, BacksUpTheMeanOfNoisySelection) { EXPECT_NEAR(expected_backup(ActionSelector(0.8)), 0.23, 1e-15); }

TEST(ExpectedSarsa, TheMeanIsOverLegalActionsAndBonusesAndHintsCount) {
    using P = Choosing<EpsilonGreedy>;
    auto params = half_way<P>(EpsilonGreedy(0.0));
    params.expected = true;
    Sarsa<P> plain(3, 2, params);
    learn_state_1(plain);
    Sarsa<P> masked = plain;
    masked.set_legal_actions(s1, ActionSet::of(2, {a1}));
    Sarsa<P> told = plain;
    told.teach(s1, a1);
    plain.observe(s0, a0, 0.1, s1, false);
    masked.observe(s0, a0, 0.1, s1, false);
    told.observe(s0, a0, 0.1, s1, false);
    EXPECT_DOUBLE_EQ(plain.q()(s0, a0), 0.25);
    EXPECT_DOUBLE_EQ(masked.q()(s0, a0), 0.09);
    EXPECT_DOUBLE_EQ(told.q()(s0, a0), 0.09) << "it will follow the hint, which itself is no reward";

    // Eq. 7's bonus of an action never tried, 2, outweighs 0.5 + 2/2^1.5 = 1.21: the third action's value 0 is backed
    // up.
    params.w_exp = 2.0;
    Sarsa<P> curious(3, 3, params);
    learn_state_1(curious);
    curious.observe(s0, a0, 0.1, s1, false);
    EXPECT_DOUBLE_EQ(curious.q()(s0, a0), 0.05);
}

TEST(ExpectedSarsa, LearnsTheSameWhicheverActionComesNext) {
    using P = Choosing<EpsilonGreedy>;
    auto params = half_way<P>(EpsilonGreedy(0.5));
    params.expected = true;
    bool other = false;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Sarsa<P> learner(3, 2, params, seed);
        learn_state_1(learner);
        (void)learner.begin(s0);
        learner.replace_action(a0);
        const ActionId next = learner.step(0.1, s1);
        other = other || next != a0;
        EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.21) << "seed " << seed;
    }
    EXPECT_TRUE(other);
}

TEST(ExpectedSarsa, NeedsASelectorWithAnExpectation) {
    static_assert(has_expectation_v<ActionSelector> && has_expectation_v<EpsilonGreedy> &&
                  has_expectation_v<Boltzmann>);
    static_assert(!has_expectation_v<Scripted>);
    SarsaParams<Choosing<Scripted>> params;
    params.expected = true;
    EXPECT_THROW(Sarsa<Choosing<Scripted>>(3, 2, params), std::invalid_argument);
}

}  // namespace sspql_sarsa_test

// Every member compiles.
template class sspql::Sarsa<>;
template class sspql::Sarsa<sspql_sarsa_test::Choosing<sspql_sarsa_test::Scripted>>;
