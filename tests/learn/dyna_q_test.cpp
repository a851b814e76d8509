// SPDX-License-Identifier: MIT
#include <sspql/learn/dyna_q.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <stdexcept>

#include <gtest/gtest.h>

#include <sspql/learn/action_selector.hpp>

namespace sspql_dyna_q_test {

using namespace sspql;

namespace {

constexpr StateId s0{0}, s1{1}, s2{2};
constexpr ActionId a0{0}, a1{1};

struct GreedyEverywhere : ModelPolicies {
    using Selector = EpsilonGreedy;
    using LegalActions = AllActions;
};

/// alpha 1/2, gamma 0.8, k planning steps.
DynaQParams<> planning(std::size_t k, Replay replay = Replay::from_counts) {
    DynaQParams<> params;
    params.alpha = 0.5;
    params.planning_steps = k;
    params.replay = replay;
    return params;
}

/// How often Q(0,a0) ends up at which value, over 1000 seeds.
std::map<double, int> values(const DynaQParams<>& params, const std::function<void(DynaQ<>&)>& lesson) {
    std::map<double, int> seen;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        DynaQ<> learner(4, 2, params, seed);
        lesson(learner);
        ++seen[learner.q()(s0, a0)];
    }
    return seen;
}

/// a0 in 0 ends the episode: with reward 1 in state 1, then with reward 0 in state 2.
void end_well_then_badly(DynaQ<>& learner) {
    learner.observe(s0, a0, 1.0, s1, true);
    learner.observe(s0, a0, 0.0, s2, true);
}

}  // namespace

// Four updates towards 1, each half of the way: 1 - 1/2^4.
TEST(DynaQ, PlansKTimesAfterEachStep) {
    DynaQ<> learner(2, 1, planning(3));
    learner.observe(s0, a0, 1.0, s1, true);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.9375);
    EXPECT_EQ(learner.visits()(s0, a0), 1u) << "planning steps are no visits";
    EXPECT_EQ(learner.model_operations(), 4u) << "a record, three looks";
    DynaQ<> unplanned(2, 1, planning(0));
    unplanned.observe(s0, a0, 1.0, s1, true);
    EXPECT_DOUBLE_EQ(unplanned.q()(s0, a0), 0.5);
}

// 0 -a0-> 1 -a0-> 2 (end, 1): Q(1) = 1 of rate 1, and planning takes it back to 0: 0.8.
TEST(DynaQ, PlanningCarriesValuesBack) {
    DynaQParams<> params = planning(30);
    params.alpha = 1.0;
    DynaQ<> learner(3, 1, params, 1);
    learner.observe(s0, a0, 0.0, s1, false);
    learner.observe(s1, a0, 1.0, s2, true);
    EXPECT_DOUBLE_EQ(learner.q()(s1, a0), 1.0);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.8);
}

// (0,a0), (0,a1), then (0,a0) again, k = 0 but for the last: its one planning step goes to either pair.
TEST(DynaQ, PlansForTriedPairsUniformly) {
    const auto seen = values(planning(1), [](DynaQ<>& learner) {
        learner.observe(s0, a1, 0.0, s1, true);
        learner.observe(s0, a0, 1.0, s1, true);
    });
    ASSERT_EQ(seen.size(), 2u);
    EXPECT_EQ(seen.begin()->first, 0.5) << "(0,a1) was planned";
    EXPECT_EQ(seen.rbegin()->first, 0.75) << "(0,a0) was planned";
    EXPECT_NEAR(seen.at(0.75), 500, 60);  // 4 standard deviations
}

// 0.5, 0.75; the second outcome: 0.375; planning repeats that: 0.1875.
TEST(DynaQ, LastOutcomeRepeatsWhatHappenedLast) {
    const auto seen = values(planning(1, Replay::last_outcome), end_well_then_badly);
    EXPECT_EQ(seen, (std::map<double, int>{{0.1875, 1000}}));
}

// 0.375 as above; then either outcome: 0.1875 or 0.5 x 0.375 + 0.5.
TEST(DynaQ, CountsGiveEachOutcomeItsShare) {
    auto seen = values(planning(1), end_well_then_badly);
    ASSERT_EQ(seen.size(), 2u);
    EXPECT_EQ(seen.begin()->first, 0.1875);
    EXPECT_EQ(seen.rbegin()->first, 0.6875);
    EXPECT_NEAR(seen[0.6875], 500, 60);
    // Three good ones more make it 4 of 5. Rate 1: the last update decides.
    DynaQParams<> sure = planning(1);
    sure.alpha = 1.0;
    seen = values(sure, [](DynaQ<>& learner) {
        end_well_then_badly(learner);
        for (int k = 0; k < 3; ++k) learner.observe(s0, a0, 1.0, s1, true);
    });
    EXPECT_NEAR(seen[1.0], 800, 50);
    EXPECT_EQ(seen[1.0] + seen[0.0], 1000);
}

// Rewards 1 and 3 on the same way: 0.5, 0.75, 1.875; counts then plan with the mean 2, the last outcome with 3.
TEST(DynaQ, CountsReplayTheMeanReward) {
    const auto lesson = [](DynaQ<>& learner) {
        learner.observe(s0, a0, 1.0, s1, true);
        learner.observe(s0, a0, 3.0, s1, true);
    };
    EXPECT_EQ(values(planning(1), lesson), (std::map<double, int>{{1.9375, 1000}}));
    EXPECT_EQ(values(planning(1, Replay::last_outcome), lesson), (std::map<double, int>{{2.4375, 1000}}));
}

// kappa 1 beside one observation of reward 0: in half of the cases an end with the unknown value.
TEST(DynaQ, APseudoCountIsDrawnAsOftenAsItCounts) {
    DynaQParams<> params = planning(1);
    params.kappa = 1.0;
    params.unknown_value = 7.0;
    const auto lesson = [](DynaQ<>& learner) { learner.observe(s0, a0, 0.0, s1, true); };
    auto seen = values(params, lesson);
    EXPECT_NEAR(seen[3.5], 500, 60);
    EXPECT_EQ(seen[3.5] + seen[0.0], 1000);
    params.kappa = 3.0;  // 3 of 4
    seen = values(params, lesson);
    EXPECT_NEAR(seen[3.5], 750, 55);
}

TEST(DynaQ, ACapForgetsOldOutcomes) {
    DynaQParams<> params = planning(1);
    params.cap = 1.0;
    EXPECT_EQ(values(params, end_well_then_badly), (std::map<double, int>{{0.1875, 1000}}))
        << "the last one alone counts";
    DynaQ<> learner(4, 2, params);
    end_well_then_badly(learner);
    EXPECT_EQ(learner.counts().n(s0, a0), 1.0);
    EXPECT_EQ(learner.counts().n(s0, a0, s1), 0.0);
    EXPECT_EQ(learner.visits()(s0, a0), 2u) << "visits do not fade";
}

// a0 of state 1 is worth 1 and illegal: planned on, but never the best of state 1.
TEST(DynaQ, PlanningTakesTheBestOfLegalActions) {
    for (const Replay replay : {Replay::from_counts, Replay::last_outcome}) {
        DynaQ<> learner(3, 2, planning(50, replay), 1);
        learner.set_legal_actions(s1, ActionSet::of(2, {a1}));
        learner.observe(s1, a0, 1.0, s2, true);
        learner.observe(s0, a0, 0.0, s1, false);
        EXPECT_GT(learner.q()(s1, a0), 0.99);
        EXPECT_EQ(learner.q()(s0, a0), 0.0);
        learner.observe(s1, a1, 0.25, s2, true);
        for (int k = 0; k < 4; ++k) learner.observe(s1, a1, 0.25, s2, true);
        EXPECT_NEAR(learner.q()(s0, a0), 0.2, 1e-9);
    }
}

TEST(DynaQ, RefusesWhatIsOutOfRange) {
    const auto refused = [](auto&& change) {
        DynaQParams<> params;
        change(params);
        EXPECT_THROW(DynaQ<>(2, 2, params), std::invalid_argument);
    };
    refused([](auto& p) { p.cap = 0.5; });
    refused([](auto& p) { p.kappa = -1.0; });
    refused([](auto& p) { p.least_count = 0.6; });
    refused([](auto& p) { p.alpha = 1.5; });
    refused([](auto& p) { p.gamma = 1.1; });
    EXPECT_NO_THROW((DynaQ<GreedyEverywhere>(2, 2)));
}

}  // namespace sspql_dyna_q_test

// Every member compiles.
template class sspql::DynaQ<>;
template class sspql::DynaQ<sspql_dyna_q_test::GreedyEverywhere>;
