// SPDX-License-Identifier: MIT
// Algorithm 2, stepped by hand on a chain 0 - 1 - 2 with the goal 2; a0 leads on, a1 back. Defaults: alpha = gamma =
// 0.8, lambda = 2, w_Q = 1, w_SSP = min(1, N^-2), w_EXP = 0.1, eta = 1.5, noise below 0.01.
#include <sspql/learn/sspql.hpp>

#include <cstdint>

#include <gtest/gtest.h>

using sspql::ActionId;
using sspql::ActionTerms;
using sspql::no_action;
using sspql::Sspql;
using sspql::StateId;

namespace {

constexpr ActionId a0{0}, a1{1};
constexpr StateId s0{0}, s1{1}, s2{2};

void expect_terms(const ActionTerms& terms, double q, double ssp, double exploration, double n) {
    EXPECT_NEAR(terms.q, q, 1e-6);
    EXPECT_NEAR(terms.ssp, ssp, 1e-6);
    EXPECT_NEAR(terms.exploration, exploration, 1e-6);
    EXPECT_EQ(terms.n, n);
}

/// First episode: 0 -a0-> 1 -a0-> 2. All scores are equal, so the actions are given.
Sspql<> after_first_episode(std::uint64_t seed) {
    Sspql<> learner(3, 2, {}, seed);
    static_cast<void>(learner.begin(s0));
    learner.replace_action(a0);
    static_cast<void>(learner.step(0.0, s1));
    learner.replace_action(a0);
    learner.end(1.0, s2, true);
    return learner;
}

}  // namespace

TEST(Algorithm2, StartsWithTheExplorationBonusAlone) {
    const Sspql<> learner(3, 2);
    for (const StateId s : {s0, s1, s2}) {
        for (const ActionId a : {a0, a1}) expect_terms(learner.terms(s, a), 0.0, 0.0, 0.1, 0.0);
    }
}

// Lines 3 to 8: the model and Q change at once, the SSP values do not: there is no goal yet.
//   Q(0,a0) = 0 + 0.8 (0 + 0.8 x 0 - 0) = 0;  N = 1: bonus 0.1 / 2^1.5 = 0.035355
TEST(Algorithm2, RecordsAndUpdatesQAtEveryStep) {
    Sspql<> learner(3, 2);
    static_cast<void>(learner.begin(s0));
    learner.replace_action(a0);
    static_cast<void>(learner.step(0.0, s1));
    EXPECT_EQ(learner.counts().n(s0, a0, s1), 1u);
    expect_terms(learner.terms(s0, a0), 0.0, 0.0, 0.035355, 1.0);
    EXPECT_EQ(learner.state(), s1);
    EXPECT_TRUE(learner.goals().empty());
}

// Lines 9 and 10: reaching the goal ends the episode and updates the SSP values.
//   Q(1,a0) = 0 + 0.8 (1 + 0 - 0) = 0.8. Tree: 0 -> 1 -> 2, both certain: Q_SSP = e^0 = 1, N = 1: w_SSP = 1.
TEST(Algorithm2, UpdatesSspValuesWhenTheGoalIsReached) {
    const Sspql<> learner = after_first_episode(0);
    EXPECT_FALSE(learner.running());
    EXPECT_EQ(learner.tree().next[0], s1);
    EXPECT_EQ(learner.tree().next[1], s2);
    expect_terms(learner.terms(s0, a0), 0.0, 1.0, 0.035355, 1.0);
    expect_terms(learner.terms(s0, a1), 0.0, 0.0, 0.1, 0.0);
    expect_terms(learner.terms(s1, a0), 0.8, 1.0, 0.035355, 1.0);
    expect_terms(learner.terms(s1, a1), 0.0, 0.0, 0.1, 0.0);
    EXPECT_TRUE(learner.counts().cell(s1, a0, s2)->terminal());
}

// Second episode. All gaps below exceed the noise, so every seed acts alike.
TEST(Algorithm2, SecondEpisodeGoesByTheSumOfTheThreeTerms) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Sspql<> learner = after_first_episode(seed);

        // 0 + 1 + 0.035355 against 0.1.
        EXPECT_EQ(learner.begin(s0), a0);

        // The step slips, the robot stays in 0. Q(0,a0) = 0 + 0.8 (0 + 0.8 x 0 - 0) = 0; N = 2: w_SSP = 1/4, bonus
        // 0.1 / 3^1.5 = 0.019245. Q_SSP is still 1: it is renewed at the end. 0.25 + 0.019245 against 0.1.
        EXPECT_EQ(learner.step(0.0, s0), a0);
        expect_terms(learner.terms(s0, a0), 0.0, 0.25, 0.019245, 2.0);
        EXPECT_EQ(learner.ssp_values()(s0, a0), 1.0);

        // Now it works. Q(0,a0) = 0 + 0.8 (0 + 0.8 x 0.8 - 0) = 0.512; N = 3: 1/9 and 0.1 / 4^1.5 = 0.0125.
        // In 1: 0.8 + 1 + 0.035355 against 0.1.
        EXPECT_EQ(learner.step(0.0, s1), a0);
        expect_terms(learner.terms(s0, a0), 0.512, 1.0 / 9.0, 0.0125, 3.0);

        // Q(1,a0) = 0.8 + 0.8 (1 - 0.8) = 0.96. P(1|0,a0) = 2/3 now: H = 2/3 ln 3/2 + 1/3 ln 3 = 0.636514,
        // Q_SSP = 0.529134, weighted by 1/9: 0.058793.
        learner.end(1.0, s2, true);
        expect_terms(learner.terms(s0, a0), 0.512, 0.058793, 0.0125, 3.0);
        EXPECT_NEAR(learner.ssp_values()(s0, a0), 0.529134, 1e-6);
        expect_terms(learner.terms(s1, a0), 0.96, 0.25, 0.019245, 2.0);
        EXPECT_EQ(learner.best(s0), a0);
        EXPECT_EQ(learner.best(s1), a0);
    }
}

// An episode somebody cut short ends, too: the values are renewed, the last state keeps its future value and is no
// goal.
//   Q(1,a1) = 0 + 0.8 (0 + 0.8 x 0 - 0) = 0;  Q(0,a0) = 0.512 as above, with Q(1,a0) = 0.8.
TEST(Algorithm2, ATruncatedEpisodeRenewsTheTreeButMakesNoGoal) {
    Sspql<> learner = after_first_episode(0);
    static_cast<void>(learner.begin(s0));
    learner.replace_action(a0);
    learner.end(0.0, s1, false);
    ASSERT_EQ(learner.goals().size(), 1u);
    EXPECT_EQ(learner.goals().front().state, s2);
    EXPECT_NEAR(learner.q()(s0, a0), 0.512, 1e-12);
    EXPECT_EQ(learner.counts().n(s0, a0), 2u);
    EXPECT_TRUE(learner.counts().dirty().empty()) << "published";
}

// A step of cost 4 to the goal: EC(1,2) = 4 e^{-2} = 0.541341.
TEST(Algorithm2, TakesTheWeightOfAStepIntoTheModel) {
    Sspql<> learner(3, 2);
    static_cast<void>(learner.begin(s1));
    learner.replace_action(a0);
    learner.end(1.0, s2, true, 4.0);
    EXPECT_NEAR(learner.tree().distance[1], 0.541341, 1e-6);
}
