// SPDX-License-Identifier: MIT
// Limits of the paper's method: stated, not hidden.
#include <sspql/learn/sspql.hpp>

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include <sspql/model/probability.hpp>
#include <sspql/paths/cost.hpp>

using sspql::ActionId;
using sspql::Sspql;
using sspql::SspqlParams;
using sspql::state_id;
using sspql::StateId;

namespace {

constexpr ActionId a0{0}, a1{1};
constexpr StateId s0{0}, s1{1}, s2{2}, s3{3};

/// 0 -a0-> 9 (goal) once, and around it 0 -a1-> 1 -a0-> 2 ... 8 -a0-> 9: nine certain steps.
template <class Learner>
void teach_doorway_and_detour(Learner& learner) {
    learner.observe(s0, a1, 0.0, s1, false);
    for (std::size_t s = 1; s < 9; ++s) learner.observe(state_id(s), a0, s == 8 ? 1.0 : 0.0, state_id(s + 1), s == 8);
    learner.observe(s0, a0, 1.0, state_id(9), true);
}

struct TryUntilItWorks : sspql::SspqlPolicies {
    using Cost = sspql::ExpectedTries;
    using Probability = sspql::BestAction;
};

}  // namespace

// The doorway closes: a0 fails n times. EC(0,9) = e^{-2/(n+1)} < 1, the detour costs 9 e^{-2} = 1.218: for ever dearer.
TEST(KnownLimits, ABlockedEdgeIsNeverDropped) {
    Sspql<> learner(10, 2);
    teach_doorway_and_detour(learner);
    for (int n = 0; n < 10000; ++n) learner.observe(s0, a0, 0.0, s0, false);
    learner.update_paths();
    EXPECT_EQ(learner.tree().next[0], state_id(9)) << "after ten thousand failures";
    EXPECT_LT(learner.tree().distance[0], 1.0);
    EXPECT_GT(learner.ssp_values()(s0, a0), 0.99) << "and the failure is certain, so eq. 5 values it highly";
}

// Another cost policy drops it: weight / P = n + 1 exceeds 9 after nine failures.
TEST(KnownLimits, ExpectedTriesDropsIt) {
    Sspql<TryUntilItWorks> learner(10, 2);
    teach_doorway_and_detour(learner);
    for (int n = 0; n < 7; ++n) learner.observe(s0, a0, 0.0, s0, false);
    learner.update_paths();
    EXPECT_EQ(learner.tree().next[0], state_id(9)) << "8 expected tries, 9 steps around";
    for (int n = 0; n < 2; ++n) learner.observe(s0, a0, 0.0, s0, false);
    learner.update_paths();
    EXPECT_EQ(learner.tree().next[0], s1) << "10 expected tries";
}

// 0 -a0-> 2 (goal) and 0 -a1-> 1 -a0-> 2 are known. The direct way fails 500 times within one episode: 2 e^{-2} = 0.271
// is far less than e^{-2/501} = 0.996, but nobody looks before the episode ends.
TEST(KnownLimits, TheTreeIsRenewedOnlyWhenAnEpisodeEnds) {
    Sspql<> learner(3, 2);
    learner.observe(s0, a1, 0.0, s1, false);
    learner.observe(s1, a0, 1.0, s2, true);
    learner.observe(s0, a0, 1.0, s2, true);
    const double before = learner.tree().distance[0];
    EXPECT_DOUBLE_EQ(before, std::exp(-2.0));
    static_cast<void>(learner.begin(s0));
    for (int n = 0; n < 500; ++n) {
        learner.replace_action(a0);
        static_cast<void>(learner.step(0.0, s0));
        ASSERT_EQ(learner.tree().next[0], s2);
        ASSERT_EQ(learner.tree().distance[0], before);
        ASSERT_EQ(learner.ssp_values().action(s0), a0);
    }
    learner.end(0.0, s0, false);
    EXPECT_EQ(learner.tree().next[0], s1);
    EXPECT_EQ(learner.ssp_values().action(s0), a1);
}

// a0 leads to the goal 2 in seven tries of ten, else into the hazard 3; the detour over 1 is certain and costs
// 2 e^{-2} = 0.271. e^{-2 x 0.7} = 0.247: the path takes the risk, and it would cost the same if the other three tries
// had only stayed in 0.
TEST(KnownLimits, AHazardBesideThePathCostsNothing) {
    const auto taught = [](bool hazard) {
        Sspql<> learner(4, 2);
        learner.observe(s0, a1, 0.0, s1, false);
        learner.observe(s1, a0, 1.0, s2, true);
        for (int n = 0; n < 10; ++n) {
            if (n < 7) {
                learner.observe(s0, a0, 1.0, s2, true);
            } else {
                learner.observe(s0, a0, 0.0, hazard ? s3 : s0, hazard);
            }
        }
        learner.update_paths();
        return learner;
    };
    const Sspql<> deadly = taught(true), harmless = taught(false);
    EXPECT_EQ(deadly.tree().next[0], s2);
    EXPECT_NEAR(deadly.tree().distance[0], 0.246597, 1e-6);
    EXPECT_EQ(deadly.tree().distance[0], harmless.tree().distance[0]);
    EXPECT_EQ(deadly.ssp_values()(s0, a0), harmless.ssp_values()(s0, a0));
}

// With constant w_SSP the blocked action's score is at least 1 for ever, no other's exceeds the noise: it is repeated
// without end. With N^-2 it falls below the noise after some ten tries. The way round is 0 -a1-> 1 -a0-> 2.
TEST(KnownLimits, AConstantWeightLivelocksWhereTheDecayingOneDoesNot) {
    const auto steps_to_goal = [](const SspqlParams<>& params, std::uint64_t seed) {
        Sspql<> learner(3, 2, params, seed);
        learner.observe(s0, a0, 1.0, s2, true);
        ActionId a = learner.begin(s0);
        int steps = 0;
        StateId s = s0;
        for (; steps < 3000; ++steps) {
            if (s == s1 && a == a0) {
                learner.end(1.0, s2, true);
                return steps + 1;
            }
            s = s == s0 && a == a1 ? s1 : s0;
            a = learner.step(0.0, s);
        }
        return steps;
    };
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        EXPECT_EQ(steps_to_goal(SspqlParams<>::constant_weight(), seed), 3000) << "seed " << seed;
        EXPECT_LT(steps_to_goal(SspqlParams<>::without_bonus(), seed), 100) << "seed " << seed;
    }
}
