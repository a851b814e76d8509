// SPDX-License-Identifier: MIT
#include <sspql/learn/adaptive/forgetting_model.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>

namespace sspql_adaptive_forgetting_model_test {

using namespace sspql;

namespace {

constexpr StateId s0{0}, s1{1}, s2{2};
constexpr ActionId a0{0}, a1{1};

TrustParams by_hand() {
    TrustParams params;
    params.cap = 50.0;
    params.kappa_noise = 0.4;
    params.kappa_least = 0.01;
    params.tau = 0.0;
    return params;
}

/// A detector that never alarms: what is tested is the rest.
ChangeParams silent() {
    ChangeParams params;
    params.threshold = 1e9;
    return params;
}

bool see(ForgettingModel& model, StateId s, ActionId a, StateId next, double reward = 0.0) {
    return model.observe({s, a, reward, next, false, 1.0});
}

}  // namespace

TEST(ForgettingModel, CountsStepsAndPairs) {
    ForgettingModel model(3, 2, by_hand(), silent());
    EXPECT_FALSE(model.tried(s0, a0));
    EXPECT_TRUE(see(model, s0, a0, s1));
    EXPECT_FALSE(see(model, s0, a0, s2)) << "only the first time is the first";
    EXPECT_TRUE(see(model, s0, a1, s1));
    EXPECT_TRUE(model.tried(s0, a0));
    EXPECT_FALSE(model.tried(s1, a0));
    EXPECT_EQ(model.pairs_tried(), 2u);
    EXPECT_EQ(model.steps(), 3u);
    EXPECT_EQ(model.counts().n(s0, a0), 2.0);
}

TEST(ForgettingModel, NoiseByHand) {
    ForgettingModel model(3, 2, by_hand(), silent());
    EXPECT_EQ(model.kappa(), 0.01);
    see(model, s0, a0, s1);  // a first try says nothing
    EXPECT_EQ(model.noise(), 0.0);
    see(model, s0, a0, s1);  // weight 1/3, no surprise
    EXPECT_EQ(model.noise(), 0.0);
    EXPECT_EQ(model.kappa(), 0.01) << "the least";
    see(model, s0, a0, s2);  // weight 2/3 of 1, over 1 + 1/3
    EXPECT_NEAR(model.noise(), 0.5, 1e-12);
    EXPECT_NEAR(model.kappa(), 0.2, 1e-12);
    see(model, s0, a0, s1);  // weight 1 of 1/3 - 0.5, over 1 + 1
    EXPECT_NEAR(model.noise(), 0.5 - (0.5 - 1.0 / 3.0) / 2.0, 1e-12);
    EXPECT_NEAR(model.kappa(), 0.4 * model.noise(), 1e-12);
    EXPECT_EQ(model.kappa(s0, a0), model.kappa()) << "one for all where tau is 0";
    EXPECT_EQ(model.kappa(s2, a1), model.kappa());
}

TEST(ForgettingModel, NoiseTendsToTheRateOfSurprises) {
    ForgettingModel model(3, 1, by_hand(), silent());
    Random random(1);
    for (int k = 0; k < 4000; ++k) see(model, s0, a0, random.chance(0.8) ? s1 : s2);
    EXPECT_NEAR(model.noise(), 2.0 * 0.8 * 0.2, 0.05) << "1 - 0.8^2 - 0.2^2";
    for (int k = 0; k < 8000; ++k) see(model, s1, a0, s2);
    EXPECT_LT(model.noise(), 0.01) << "and follows if it becomes quiet";
}

TEST(ForgettingModel, AtMostTheCapCounts) {
    TrustParams params = by_hand();
    params.cap = 2.0;
    ForgettingModel model(3, 1, params, silent());
    see(model, s0, a0, s1, 4.0);
    see(model, s0, a0, s1, 4.0);
    EXPECT_EQ(model.counts().n(s0, a0), 2.0);
    see(model, s0, a0, s2);
    EXPECT_NEAR(model.counts().n(s0, a0, s1), 2.0 * 2.0 / 3.0, 1e-12);
    EXPECT_NEAR(model.counts().cell(s0, a0, s1)->mean_reward(), 4.0, 1e-12) << "rewards fade along";
    EXPECT_EQ(model.counts().n(s0, a0, s2), 1.0);
    see(model, s0, a0, s2);
    EXPECT_NEAR(model.counts().n(s0, a0, s1), 0.8, 1e-12) << "4/3 x 2 / (7/3 + 1)";
    EXPECT_NEAR(model.counts().n(s0, a0, s2), 1.6, 1e-12);
    for (int k = 0; k < 100; ++k) see(model, s0, a0, s2);
    EXPECT_EQ(model.counts().cell(s0, a0, s1), nullptr) << "forgotten";
    EXPECT_LT(model.counts().n(s0, a0), 2.5);
}

TEST(ForgettingModel, WithoutACapAllCount) {
    TrustParams params = by_hand();
    params.cap = 0.0;
    ForgettingModel model(3, 1, params, silent());
    for (int k = 0; k < 500; ++k) see(model, s0, a0, k % 2 == 0 ? s1 : s2);
    EXPECT_EQ(model.counts().n(s0, a0), 500.0);
    EXPECT_EQ(model.counts().n(s0, a0, s1), 250.0);
}

TEST(ForgettingModel, AnAlarmForgetsOnlyWhatChanged) {
    ChangeParams change;
    change.threshold = 2.0;
    change.kept = 1.0;
    ForgettingModel model(3, 2, by_hand(), change);
    for (int k = 0; k < 20; ++k) {
        see(model, s0, a0, s1);
        see(model, s0, a1, s1);
        see(model, s1, a0, s2);
    }
    for (int k = 0; k < 4; ++k) see(model, s0, a0, s0);
    EXPECT_GE(model.detector().alarms(), 1u);
    EXPECT_LT(model.counts().n(s0, a0, s1), 1.0) << "of 20";
    EXPECT_EQ(model.counts().n(s0, a1, s1), 20.0);
    EXPECT_EQ(model.counts().n(s1, a0, s2), 20.0);
    EXPECT_EQ(model.pairs_tried(), 3u) << "it stays tried";
}

TEST(ForgettingModel, DoubtGrowsWithTheTimeSinceTheLastTry) {
    TrustParams params = by_hand();
    params.tau = 2.0;
    ForgettingModel model(3, 2, params, silent());
    for (int k = 0; k < 3; ++k) see(model, s0, a0, s1);
    EXPECT_EQ(model.kappa(s0, a0), model.kappa()) << "just tried";
    for (int k = 0; k < 5; ++k) see(model, s1, a1, s2);
    EXPECT_NEAR(model.kappa(s0, a0), model.kappa() + 3.0 * (1.0 - std::exp(-5.0 / (2.0 * 2.0))), 1e-12)
        << "5 steps ago, tau 2, two (s,a) tried";
    EXPECT_EQ(model.kappa(s1, a1), model.kappa());
    EXPECT_EQ(model.kappa(s2, a0), model.kappa()) << "never tried: nothing to doubt";
    for (int k = 0; k < 10000; ++k) see(model, s1, a1, s2);
    EXPECT_NEAR(model.kappa(s0, a0), model.kappa() + 3.0, 1e-9);
    see(model, s0, a0, s1);
    EXPECT_EQ(model.kappa(s0, a0), model.kappa());
}

TEST(ForgettingModel, FewOutcomesAreDoubtedOnceThatIsAskedFor) {
    TrustParams params = by_hand();
    params.kappa_few = 0.5;
    ForgettingModel model(3, 2, params, silent());
    see(model, s0, a0, s1);
    for (int k = 0; k < 4; ++k) see(model, s0, a1, s1);
    EXPECT_EQ(model.kappa(s0, a0), 0.01);
    model.doubt_few();
    EXPECT_NEAR(model.kappa(s0, a0), 0.01 * 1.5, 1e-15) << "one outcome";
    EXPECT_NEAR(model.kappa(s0, a1), 0.01 * 1.25, 1e-15) << "four: half of that";
    EXPECT_EQ(model.kappa(), 0.01) << "many";
}

TEST(ForgettingModel, GrowsWithItsStates) {
    TrustParams params = by_hand();
    params.tau = 5.0;
    ForgettingModel model(0, 2, params, silent());
    for (std::size_t s = 0; s < 100; ++s) {
        model.grow(s + 2);
        see(model, state_id(s), a1, state_id(s + 1));
    }
    EXPECT_EQ(model.pairs_tried(), 100u);
    EXPECT_EQ(model.counts().states(), 101u);
    EXPECT_GT(model.kappa(s0, a1), model.kappa(state_id(99), a1));
}

TEST(ForgettingModel, RefusesParametersOutOfRange) {
    const auto with = [](double TrustParams::*member, double value) {
        TrustParams params;
        params.*member = value;
        return ForgettingModel(2, 2, params, {});
    };
    EXPECT_THROW((void)with(&TrustParams::cap, 0.5), std::invalid_argument);
    EXPECT_NO_THROW((void)with(&TrustParams::cap, 0.0)) << "no cap";
    EXPECT_THROW((void)with(&TrustParams::kappa_least, 0.0), std::invalid_argument);
    EXPECT_THROW((void)with(&TrustParams::kappa_noise, -1.0), std::invalid_argument);
    EXPECT_THROW((void)with(&TrustParams::tau, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
    EXPECT_THROW((ForgettingModel(2, 0, {}, {})), std::invalid_argument);
}

}  // namespace sspql_adaptive_forgetting_model_test
