// SPDX-License-Identifier: MIT
#include <sspql/learn/reward_model.hpp>

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/spaces/legal_actions.hpp>

namespace sspql_reward_model_test {

using namespace sspql;

namespace {

constexpr StateId s0{0}, s1{1}, s2{2}, s3{3};
constexpr ActionId a0{0}, a1{1};

using Model = RewardModel<FadingCell>;
using Params = ModelParams<ModelPolicies>;

/// A cell of one's own: it need only keep rewards and fade.
struct OwnCell : FadingCell {};

/// Twice on to 1 with rewards 1 and 2, once to the end in 2 with reward 3.
Model three_outcomes(std::size_t actions = 2) {
    Model model(4, actions);
    const Params params;
    model.observe({s0, a0, 1.0, s1, false, 1.0}, params);
    model.observe({s0, a0, 2.0, s1, false, 1.0}, params);
    model.observe({s0, a0, 3.0, s2, true, 1.0}, params);
    return model;
}

}  // namespace

// (1 + 2 + 3 + 2 x 0.5 x 10) / 3 with Q(1,a1) = 10; whatever 2 is worth, nothing follows its end.
TEST(RewardModel, ABackupIsTheMeanOverOutcomes) {
    for (const std::size_t actions : {std::size_t{2}, std::size_t{20}}) {  // dense cells and sparse ones
        Model model = three_outcomes(actions);
        QTable q(4, actions);
        q(s1, a1) = 10.0;
        q(s2, a0) = 1000.0;
        Params params;
        params.gamma = 0.5;
        EXPECT_DOUBLE_EQ(model.backup(s0, a0, q, params, AllActions{}), 16.0 / 3.0);
        params.kappa = 1.0;
        params.unknown_value = 8.0;
        EXPECT_DOUBLE_EQ(model.backup(s0, a0, q, params, AllActions{}), (16.0 + 8.0) / 4.0);
    }
}

TEST(RewardModel, ABackupLooksAtLegalActionsOnly) {
    Model model = three_outcomes();
    QTable q(4, 2);
    q(s1, a0) = 100.0;
    q(s1, a1) = 10.0;
    LegalActionTable legal;
    legal.set(s1, ActionSet::of(2, {a1}));
    Params params;
    params.gamma = 0.5;
    EXPECT_DOUBLE_EQ(model.backup(s0, a0, q, params, legal), 16.0 / 3.0);
}

TEST(RewardModel, SamplesComeAsOftenAsTheyWereSeenWithTheMeanReward) {
    for (const std::size_t actions : {std::size_t{2}, std::size_t{20}}) {
        Model model = three_outcomes(actions);
        model.observe({s0, a1, 7.0, s3, true, 1.0}, Params{});  // another action of the same state is not drawn
        Random random(1);
        int ends = 0;
        for (int k = 0; k < 3000; ++k) {
            const Transition t = model.sample(s0, a0, random);
            EXPECT_EQ(t.state, s0);
            EXPECT_EQ(t.action, a0);
            EXPECT_EQ(t.next, t.terminated ? s2 : s1);
            EXPECT_DOUBLE_EQ(t.reward, t.terminated ? 3.0 : 1.5);
            ends += t.terminated ? 1 : 0;
        }
        EXPECT_NEAR(ends, 1000, 104) << "4 standard deviations";
    }
}

// A cap of 4 and outcomes to 1 only, then to 2: N stays 4, and the share of 2 is 1/4, 1 - (3/4)^2, ...
TEST(RewardModel, AtTheCapTheNewestCountsOneInCap) {
    Model model(4, 2);
    Params params;
    params.cap = 4.0;
    for (int k = 0; k < 10; ++k) model.observe({s0, a0, 1.0, s1, false, 1.0}, params);
    EXPECT_DOUBLE_EQ(model.counts().n(s0, a0), 4.0);
    double old_share = 1.0;
    for (int k = 0; k < 8; ++k) {
        model.observe({s0, a0, 5.0, s2, false, 1.0}, params);
        old_share *= 0.75;
        EXPECT_NEAR(model.counts().n(s0, a0), 4.0, 1e-12);
        EXPECT_NEAR(model.counts().n(s0, a0, s1), 4.0 * old_share, 1e-12);
        EXPECT_NEAR(model.counts().cell(s0, a0, s1)->mean_reward(), 1.0, 1e-12) << "rewards fade with their counts";
    }
    EXPECT_EQ(model.counts().n(s0, a1), 0.0);
}

// 4 (3/4)^k < 0.5 from k = 8 on; then the edge is gone and so is its place.
TEST(RewardModel, WhatFadedBelowTheLeastCountIsForgotten) {
    Model model(4, 2);
    Params params;
    params.cap = 4.0;
    params.least_count = 0.5;
    for (int k = 0; k < 4; ++k) model.observe({s0, a0, 1.0, s1, false, 1.0}, params);
    for (int k = 0; k < 7; ++k) model.observe({s0, a0, 5.0, s2, false, 1.0}, params);
    EXPECT_EQ(model.counts().pairs(), 2u);
    model.observe({s0, a0, 5.0, s2, false, 1.0}, params);
    EXPECT_EQ(model.counts().pairs(), 1u);
    EXPECT_EQ(model.counts().in_degree(s1), 0u);
    EXPECT_LT(model.counts().n(s0, a0), 4.0) << "what was forgotten is no longer part of the sum";
    QTable q(4, 2);
    EXPECT_DOUBLE_EQ(model.backup(s0, a0, q, params, AllActions{}), 5.0);
}

TEST(RewardModel, ACapNeedNotBeAWholeNumber) {
    Model model(4, 2);
    Params params;
    params.cap = 2.5;
    for (int k = 0; k < 50; ++k) model.observe({s0, a0, 1.0, k % 2 == 0 ? s1 : s2, false, 1.0}, params);
    EXPECT_NEAR(model.counts().n(s0, a0), 2.5, 1e-12);
}

TEST(RewardModel, GrowsAndCountsItsOperations) {
    Model model(0, 2);
    EXPECT_EQ(model.operations(), 0u);
    model.reserve(4, 16);
    model.grow(4);
    const Params params;
    model.observe({s0, a0, 0.0, s3, false, 1.0}, params);
    model.observe({s0, a0, 0.0, s2, false, 1.0}, params);
    EXPECT_EQ(model.operations(), 2u);
    const QTable q(4, 2);
    (void)model.backup(s0, a0, q, params, AllActions{});
    EXPECT_EQ(model.operations(), 4u) << "two edges";
    Random random(1);
    (void)model.sample(s0, a0, random);
    model.count_operation();
    EXPECT_EQ(model.operations(), 6u);
    EXPECT_TRUE(model.counts().dirty().empty()) << "nobody here waits for dirty states";
}

TEST(ModelParams, RefuseWhatIsOutOfRange) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const auto refused = [](auto&& change) {
        Params params;
        change(params);
        EXPECT_THROW(params.validate(), std::invalid_argument);
    };
    for (const double bad : {-1.0, 0.5, 1e10, nan}) refused([&](Params& p) { p.cap = bad; });
    for (const double bad : {-0.1, 0.6, nan}) refused([&](Params& p) { p.least_count = bad; });
    for (const double bad : {-0.1, nan}) refused([&](Params& p) { p.kappa = bad; });
    refused([&](Params& p) { p.unknown_value = nan; });
    EXPECT_NO_THROW(Params{}.validate());
}

}  // namespace sspql_reward_model_test

// Every member compiles.
template class sspql::RewardModel<sspql::FadingCell>;
template class sspql::RewardModel<sspql_reward_model_test::OwnCell>;
