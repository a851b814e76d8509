// SPDX-License-Identifier: MIT
// Eq. 8: a = argmax_a [w_Q Q(s,a) + w_SSP Q_SSP(s,a) + w_EXP Q_EXP(s,a) + eps]
#include <sspql/learn/action_selector.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/learn/sspql.hpp>
#include <sspql/spaces/action_set.hpp>

using sspql::action_id;
using sspql::ActionId;
using sspql::ActionSelector;
using sspql::ActionSet;
using sspql::Random;
using sspql::StateId;

namespace {

constexpr ActionId a0{0}, a1{1}, a2{2};
constexpr StateId s0{0}, s1{1};

using Scores = std::array<double, 4>;

ActionId select(const Scores& scores, const ActionSet& allowed, Random& random, double noise = 0.01) {
    return ActionSelector(noise)(
        4, allowed, [&](ActionId a) { return scores[index(a)]; }, random);
}

}  // namespace

// Gaps of 0.02 and more: no noise below 0.01 can turn them round.
TEST(Eq8Selection, IsTheArgmaxOnceGapsExceedTheNoise) {
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
        Random random(seed);
        EXPECT_EQ(select({0.1, 0.14, 0.12, -3.0}, ActionSet::all(4), random), a1) << "seed " << seed;
    }
}

// The formula itself: one draw for each action in the order of ids, added to its score.
TEST(Eq8Selection, IsTheArgmaxOfScorePlusUniformNoise) {
    const Scores scores{0.100, 0.102, 0.098, 0.104};
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
        Random random(seed), same(seed);
        std::size_t expected = 0;
        double best = -1.0;
        for (std::size_t a = 0; a < 4; ++a) {
            const double sum = scores[a] + 0.01 * same.uniform();
            if (sum > best) {
                best = sum;
                expected = a;
            }
        }
        EXPECT_EQ(index(select(scores, ActionSet::all(4), random)), expected) << "seed " << seed;
        EXPECT_EQ(random.state(), same.state());
    }
}

// 4000 selections among 4 equals: 1000 each, standard deviation sqrt(4000 x 1/4 x 3/4) = 27.4; 5 of them are 137.
TEST(Eq8Selection, ChoosesUniformlyAmongTies) {
    std::array<int, 4> chosen{};
    for (std::uint64_t seed = 0; seed < 4000; ++seed) {
        Random random(seed);
        ++chosen[index(select({1.0, 1.0, 1.0, 1.0}, ActionSet::all(4), random))];
    }
    for (const int times : chosen) EXPECT_NEAR(times, 1000, 137);
}

// Two uniform noises on [0, 1) and a lead of 1/2: the weaker one wins with probability (1/2)^2 / 2 = 1/8.
// Of 4000: 500, standard deviation sqrt(4000 x 1/8 x 7/8) = 20.9; 5 of them are 105.
TEST(Eq8Selection, ASmallLeadWinsMoreOften) {
    int weaker = 0;
    for (std::uint64_t seed = 0; seed < 4000; ++seed) {
        Random random(seed);
        if (select({0.5, 0.0, 0.0, 0.0}, ActionSet::of(4, {a0, a1}), random, 1.0) == a1) ++weaker;
    }
    EXPECT_NEAR(weaker, 500, 105);
}

TEST(Eq8Selection, ChoosesAllowedActionsOnlyAndDrawsForThemOnly) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        Random random(seed), same(seed);
        EXPECT_EQ(select({9.0, 0.0, 1.0, 9.0}, ActionSet::of(4, {a1, a2}), random), a2);
        static_cast<void>(same.bits());
        static_cast<void>(same.bits());
        EXPECT_EQ(random.state(), same.state());
    }
}

TEST(Eq8Selection, NeedsNoise) {
    for (const double bad :
         {0.0, -0.01, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        EXPECT_THROW(ActionSelector{bad}, std::invalid_argument);
    }
    EXPECT_EQ(ActionSelector().noise(), 0.01);
}

// One step 0 -> 1 that ended with reward 1, alpha = 0.8, taken twice: Q = 0.96, N = 2, H = 0.
//   w_Q Q = 2 x 0.96 = 1.92;  w_SSP N^-2 Q_SSP = 0.5 x 1/4 x 1 = 0.125;  w_EXP / 3^1.5 = 0.1 / 5.196152 = 0.019245
// and for the action never tried: 0, 0 and 0.1.
TEST(Eq8Terms, AreTheWeightedValuesAndTheirSum) {
    sspql::SspqlParams<> params;
    params.w_q = 2.0;
    params.w_ssp = 0.5;
    sspql::Sspql<> learner(2, 2, params);
    for (int i = 0; i < 2; ++i) learner.observe(s0, a1, 1.0, s1, true);
    const sspql::ActionTerms tried = learner.terms(s0, a1);
    EXPECT_DOUBLE_EQ(tried.q, 1.92);
    EXPECT_DOUBLE_EQ(tried.ssp, 0.125);
    EXPECT_NEAR(tried.exploration, 0.019245, 1e-6);
    EXPECT_EQ(tried.n, 2.0);
    EXPECT_DOUBLE_EQ(tried.sum(), tried.q + tried.ssp + tried.exploration);
    const sspql::ActionTerms untried = learner.terms(s0, a0);
    EXPECT_EQ(untried.q, 0.0);
    EXPECT_EQ(untried.ssp, 0.0);
    EXPECT_DOUBLE_EQ(untried.exploration, 0.1);
    EXPECT_EQ(untried.n, 0.0);
    EXPECT_THROW(static_cast<void>(learner.terms(StateId{2}, a0)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(learner.terms(s0, a2)), std::invalid_argument);
}

// What the learner does is what its terms say: where their sums differ by more than the noise, it takes the largest.
TEST(Eq8Terms, ExplainWhatIsChosen) {
    sspql::Sspql<> learner(12, 3, {}, 5);
    Random world(5);
    int clear = 0;
    sspql::StateId s = s0;
    for (int i = 0; i < 3000; ++i) {
        if (!learner.running()) static_cast<void>(learner.begin(s0));
        s = learner.state();
        const ActionId chosen = learner.action();
        double best = -1.0, second = -1.0;
        std::size_t expected = 0;
        for (std::size_t a = 0; a < 3; ++a) {
            const double sum = learner.terms(s, action_id(a)).sum();
            if (sum > best) {
                second = best;
                best = sum;
                expected = a;
            } else if (sum > second) {
                second = sum;
            }
        }
        if (best - second > 0.01) {
            ++clear;
            ASSERT_EQ(index(chosen), expected) << "step " << i;
        }
        const std::size_t next = world.chance(0.7) ? (index(s) + index(chosen)) % 12 : world.below(12);
        if (next == 11) {
            learner.end(1.0, sspql::state_id(next), true);
        } else {
            static_cast<void>(learner.step(0.0, sspql::state_id(next)));
        }
    }
    EXPECT_GT(clear, 1000) << "else this test says nothing";
}
