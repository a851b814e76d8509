// SPDX-License-Identifier: MIT
#include <sspql/learn/r_max.hpp>

#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include <gtest/gtest.h>

#include <sspql/learn/action_selector.hpp>

namespace sspql_r_max_test {

using namespace sspql;

namespace {

constexpr StateId s0{0}, s1{1}, s2{2};
constexpr ActionId a0{0}, a1{1};

struct GreedyEverywhere : ModelPolicies {
    using Selector = EpsilonGreedy;
    using LegalActions = AllActions;
};

RMaxParams<> known_after(std::size_t m) {
    RMaxParams<> params;
    params.known_after = m;
    params.threshold = 1e-12;
    return params;
}

}  // namespace

TEST(RMax, WhatWasTriedLessThanMTimesIsWorthTheMost) {
    RMax<> learner(3, 2, known_after(2));
    EXPECT_EQ(learner.q()(s0, a0), 1.0);
    learner.observe(s0, a0, 0.25, s2, true);
    EXPECT_FALSE(learner.known(s0, a0));
    EXPECT_EQ(learner.q()(s0, a0), 1.0);
    EXPECT_EQ(learner.backups(), 0u);
    learner.observe(s0, a0, 0.75, s2, true);
    EXPECT_TRUE(learner.known(s0, a0));
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.5) << "the mean";
    EXPECT_FALSE(learner.known(s0, a1));
    EXPECT_THROW((void)learner.known(s0, ActionId{2}), std::invalid_argument);
    EXPECT_THROW((void)learner.known(StateId{3}, a0), std::invalid_argument);
}

TEST(RMax, TheFirstMOutcomesAreTheModelForGood) {
    RMax<> learner(3, 2, known_after(2));
    for (int k = 0; k < 2; ++k) learner.observe(s0, a0, 0.5, s2, true);
    const auto operations = learner.model_operations();
    for (int k = 0; k < 100; ++k) learner.observe(s0, a0, 0.0, s1, true);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.5);
    EXPECT_EQ(learner.counts().n(s0, a0), 2.0);
    EXPECT_EQ(learner.visits()(s0, a0), 102u);
    EXPECT_EQ(learner.model_operations(), operations);
}

// A cap of 10 keeps the model open: (0.5 + 0.5 + 0.2) / 3.
TEST(RMax, WithACapTheModelGoesOnLearning) {
    RMaxParams<> params = known_after(2);
    params.cap = 10.0;
    RMax<> learner(3, 2, params);
    for (int k = 0; k < 2; ++k) learner.observe(s0, a0, 0.5, s2, true);
    learner.observe(s0, a0, 0.2, s1, true);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.4);
    for (int k = 0; k < 100; ++k) learner.observe(s0, a0, 0.2, s1, true);
    EXPECT_NEAR(learner.q()(s0, a0), 0.2, 1e-6);
    EXPECT_NEAR(learner.counts().n(s0, a0), 10.0, 0.03);
}

// One action, m = 1: 0 -> 1 -> 2 (end, 0.5). 0.8 while 1 is unknown, then 0.5 and 0.4 at once.
TEST(RMax, PlansToTheEndWhenSomethingBecomesKnown) {
    RMax<> learner(3, 1, known_after(1));
    learner.observe(s0, a0, 0.0, s1, false);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.8);
    learner.observe(s1, a0, 0.5, s2, true);
    EXPECT_DOUBLE_EQ(learner.q()(s1, a0), 0.5);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.4);
    // Half of the time it stays: Q = 0.25 + 0.4 Q, all the sweeps in one call.
    RMax<> looping(3, 1, known_after(2));
    looping.observe(s0, a0, 0.0, s0, false);
    looping.observe(s0, a0, 0.5, s2, true);
    EXPECT_NEAR(looping.q()(s0, a0), 0.25 / 0.6, 1e-11);
}

TEST(RMax, UnknownPairsAreNotPlannedWith) {
    RMax<> learner(3, 1, known_after(2));
    learner.observe(s0, a0, 0.0, s1, false);
    for (int k = 0; k < 2; ++k) learner.observe(s1, a0, 0.0, s2, true);
    EXPECT_EQ(learner.q()(s1, a0), 0.0);
    EXPECT_EQ(learner.q()(s0, a0), 1.0) << "tried once, and it is known where to: still the most there is";
    learner.observe(s0, a0, 0.0, s1, false);
    EXPECT_EQ(learner.q()(s0, a0), 0.0);
}

TEST(RMax, IllegalActionsAreNotTheBest) {
    RMax<> learner(3, 2, known_after(1));
    learner.set_legal_actions(s1, ActionSet::of(2, {a1}));
    learner.observe(s0, a0, 0.0, s1, false);
    learner.observe(s1, a1, 0.5, s2, true);
    EXPECT_DOUBLE_EQ(learner.q()(s1, a0), 1.0) << "unknown, but no way out";
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.4);
}

// A ring of 6 states, one action on and one that ends the episode with 0.1: greedy, yet it tries all.
TEST(RMax, TriesEveryPairMTimesWithoutAnyNoiseToSpeakOf) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        RMaxParams<> params = known_after(3);
        params.selector = ActionSelector(1e-9);
        params.gamma = 0.9;
        RMax<> learner(7, 2, params, seed);
        int episodes = 0;
        const auto all_known = [&] {
            for (std::size_t s = 0; s < 6; ++s) {
                if (!learner.known(state_id(s), a0) || !learner.known(state_id(s), a1)) return false;
            }
            return true;
        };
        while (!all_known() && episodes++ < 100) {
            std::size_t s = 0;
            ActionId a = learner.begin(s0);
            for (; a == a0; a = learner.step(0.0, state_id(s))) s = (s + 1) % 6;
            learner.end(0.1, state_id(6), true);
        }
        EXPECT_LE(episodes, 19) << "seed " << seed << ": six endings, three times each, and a walk around the ring";
    }
}

TEST(RMax, OtherGoalsMakeEverythingUnknown) {
    RMax<> learner(3, 2, known_after(1));
    learner.observe(s0, a0, 0.5, s2, true);
    learner.set_goals({{s1}});
    EXPECT_FALSE(learner.known(s0, a0));
    EXPECT_EQ(learner.q()(s0, a0), 1.0);
    learner.observe(s0, a0, 0.0, s2, false);  // 2 pays and ends no longer: what it paid is forgotten
    EXPECT_EQ(learner.counts().n(s0, a0), 1.0);
    EXPECT_DOUBLE_EQ(learner.q()(s0, a0), 0.8) << "leads to where nothing is known";
}

TEST(RMax, RefusesWhatWouldNeverEnd) {
    const auto refused = [](auto&& change) {
        RMaxParams<> params;
        change(params);
        EXPECT_THROW(RMax<>(2, 2, params), std::invalid_argument);
    };
    refused([](auto& p) { p.known_after = 0; });
    refused([](auto& p) { p.threshold = 0.0; });
    refused([](auto& p) { p.gamma = 1.0; });
    EXPECT_NO_THROW((RMax<GreedyEverywhere>(2, 2)));
}

}  // namespace sspql_r_max_test

// Every member compiles.
template class sspql::RMax<>;
template class sspql::RMax<sspql_r_max_test::GreedyEverywhere>;
