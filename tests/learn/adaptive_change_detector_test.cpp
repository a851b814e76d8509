// SPDX-License-Identifier: MIT
#include <sspql/learn/adaptive/change_detector.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/learn/adaptive/forgetting_model.hpp>

namespace sspql_adaptive_change_detector_test {

using namespace sspql;

namespace {

constexpr StateId s0{0}, s1{1}, s2{2}, s3{3};
constexpr ActionId a0{0}, a1{1};

ChangeParams by_hand() {
    ChangeParams params;
    params.drift = 0.5;
    params.threshold = 2.0;
    params.log_offset = 3.5;
    params.fast = 0.5;
    params.kept = 2.0;
    params.least_count = 0.02;
    return params;
}

/// What AdaptiveSspql uses, of one (s,a), without a task around it.
struct Watched {
    explicit Watched(const ChangeParams& change, double cap = 50.0, std::size_t states = 8)
        : model(states, 2, trust(cap), change) {}
    static TrustParams trust(double cap) {
        TrustParams params;
        params.cap = cap;
        return params;
    }
    void see(StateId next, double reward = 0.0) { model.observe({s0, a0, reward, next, false, 1.0}); }
    [[nodiscard]] std::uint64_t alarms() const { return model.detector().alarms(); }

    ForgettingModel model;
};

}  // namespace

TEST(ChangeDetector, ScoresByHandOfACertainOutcome) {
    TransitionCounts<FadingCell> counts(4, 2);
    for (int k = 0; k < 4; ++k) counts.record(s0, a0, s1);
    ChangeDetector detector(4, 2, by_hand());
    EXPECT_EQ(detector.judge(counts, s0, a0, s1).score, 0.0) << "never below 0";
    const double surprise = std::log(4.5 / 0.5) - 0.5;
    auto judged = detector.judge(counts, s0, a0, s2);
    EXPECT_NEAR(judged.score, surprise, 1e-6);
    EXPECT_EQ(judged.likelihood, 0.0);
    EXPECT_EQ(judged.outcomes, 1u);
    EXPECT_NEAR(detector.judge(counts, s0, a0, s3).score, 2.0 * surprise, 1e-6) << "they add up";
    judged = detector.judge(counts, s0, a0, s1);
    EXPECT_NEAR(judged.score, 2.0 * surprise - 0.5, 1e-6) << "and are forgiven";
    EXPECT_EQ(judged.likelihood, 1.0);
    EXPECT_NEAR(detector.score(s0, a0), judged.score, 0.0);
    EXPECT_EQ(detector.score(s0, a1), 0.0) << "each (s,a) by itself";
    EXPECT_EQ(detector.score(s1, a0), 0.0);
}

TEST(ChangeDetector, WhatIsUsualIsNoSurprise) {
    TransitionCounts<FadingCell> counts(4, 2);
    for (int k = 0; k < 3; ++k) counts.record(s0, a0, s1);
    counts.record(s0, a0, s2);
    counts.record(s0, a1, s3);  // another action's outcome
    const double usual = 0.25 * std::log(3.5 / 1.5);
    const auto score_after = [&](StateId next) {
        ChangeDetector detector(4, 2, by_hand());
        return detector.judge(counts, s0, a0, next).score;
    };
    EXPECT_EQ(score_after(s1), 0.0);
    EXPECT_NEAR(score_after(s2), std::log(3.5 / 1.5) - usual - 0.5, 1e-6);
    EXPECT_NEAR(score_after(s3), std::log(3.5 / 0.5) - usual - 0.5, 1e-6);
    ChangeDetector detector(4, 2, by_hand());
    EXPECT_EQ(detector.judge(counts, s0, a0, s2).likelihood, 0.25);
}

TEST(ChangeDetector, AlarmsAboveTheFloorAndAboveChance) {
    TransitionCounts<FadingCell> counts(4, 2);
    for (int k = 0; k < 4; ++k) counts.record(s0, a0, s1);
    ChangeDetector detector(4, 2, by_hand());
    detector.judge(counts, s0, a0, s2);
    EXPECT_FALSE(detector.alarmed(s0, a0, 1)) << "1.7, the floor is 2";
    detector.judge(counts, s0, a0, s2);
    EXPECT_TRUE(detector.alarmed(s0, a0, 1)) << "3.4";
    EXPECT_TRUE(detector.alarmed(s0, a0, 900)) << "ln 900 - 3.5 = 3.3";
    EXPECT_FALSE(detector.alarmed(s0, a0, 1100)) << "ln 1100 - 3.5 = 3.5";
    EXPECT_FALSE(detector.alarmed(s0, a1, 1));
    detector.forget(s0, a0);
    EXPECT_FALSE(detector.alarmed(s0, a0, 1));
}

TEST(ChangeDetector, ResetKeepsTheFastCountsAndMeanRewards) {
    TransitionCounts<FadingCell> counts(4, 2);
    ChangeDetector detector(4, 2, by_hand());
    const auto see = [&](StateId next, double reward) {
        counts.record(s0, a0, next, false, reward);
        detector.follow(counts, s0, a0, next);
    };
    see(s1, 1.0);
    see(s1, 3.0);
    see(s2, 5.0);
    counts.record(s0, a1, s3);
    EXPECT_FLOAT_EQ(counts.cell(s0, a0, s1)->fast, 0.75f) << "(1 x 0.5 + 1) x 0.5";
    EXPECT_FLOAT_EQ(counts.cell(s0, a0, s2)->fast, 1.0f);
    detector.reset(counts, s0, a0);  // 2 observations are left, 0.75 to 1
    EXPECT_NEAR(counts.n(s0, a0, s1), 2.0 * 0.75 / 1.75, 1e-6);
    EXPECT_NEAR(counts.n(s0, a0, s2), 2.0 * 1.00 / 1.75, 1e-6);
    EXPECT_NEAR(counts.n(s0, a0), 2.0, 1e-6);
    EXPECT_NEAR(counts.cell(s0, a0, s1)->mean_reward(), 2.0, 1e-12);
    EXPECT_NEAR(counts.cell(s0, a0, s2)->mean_reward(), 5.0, 1e-12);
    EXPECT_EQ(counts.n(s0, a1, s3), 1.0) << "the other action's";
    EXPECT_EQ(detector.score(s0, a0), 0.0);
    EXPECT_EQ(detector.alarms(), 1u);
}

TEST(ChangeDetector, ResetDropsWhatIsLongAgo) {
    TransitionCounts<FadingCell> counts(4, 2);
    ChangeDetector detector(4, 2, by_hand());
    const auto see = [&](StateId next) {
        counts.record(s0, a0, next);
        detector.follow(counts, s0, a0, next);
    };
    see(s1);
    for (int k = 0; k < 8; ++k) see(s2);
    detector.reset(counts, s0, a0);
    EXPECT_EQ(counts.cell(s0, a0, s1), nullptr) << "2 / 2 x 0.5^8 of it is left";
    EXPECT_EQ(counts.in_degree(s1), 0u) << "nor does s1 know of it";
    EXPECT_NEAR(counts.n(s0, a0, s2), 2.0, 0.01);
}

TEST(ChangeDetector, AChangedCertainOutcomeIsBelievedAfterThreeTries) {
    for (const int before : {1, 2, 3, 5, 20, 50, 1000}) {
        Watched watched(by_hand());
        for (int k = 0; k < before; ++k) watched.see(s1);
        EXPECT_EQ(watched.alarms(), 0u);
        for (int k = 0; k < 3; ++k) watched.see(s2);
        EXPECT_GE(watched.alarms(), before > 3 ? 1u : 0u) << "seen " << before << " times before";
        EXPECT_GE(watched.model.counts().n(s0, a0, s2), watched.model.counts().n(s0, a0, s1)) << before;
    }
}

// Half, a third and a quarter of the tries go where they usually go, as on ice; nothing ever changes.
TEST(ChangeDetector, StationaryNoiseHardlyEverAlarms) {
    constexpr int seeds = 30;
    constexpr int tries = 10000;
    for (const std::size_t ways : {2u, 3u, 4u}) {
        std::uint64_t alarms = 0;
        std::uint64_t without_floor = 0;
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            ChangeParams none = by_hand();
            none.threshold = 0.0;
            none.log_offset = 100.0;
            Watched watched(by_hand()), unguarded(none);
            Random random(seed, RandomStream::noise);
            for (int k = 0; k < tries; ++k) {
                const StateId next = state_id(1 + random.below(ways));
                watched.see(next);
                unguarded.see(next);
            }
            alarms += watched.alarms();
            without_floor += unguarded.alarms();
        }
        EXPECT_LE(alarms, 50u) << "of " << seeds * tries << " tries, " << ways << " ways";
        EXPECT_GE(without_floor, ways == 2 ? 60u : 12000u) << ways << " ways: the floor is what keeps it silent";
    }
}

TEST(ChangeDetector, RefusesParametersOutOfRange) {
    const auto with = [](double ChangeParams::*member, double value) {
        ChangeParams params;
        params.*member = value;
        return ChangeDetector(2, 2, params);
    };
    for (const auto member : {&ChangeParams::drift, &ChangeParams::threshold, &ChangeParams::fast, &ChangeParams::kept,
                              &ChangeParams::least_count}) {
        EXPECT_THROW((void)with(member, -0.1), std::invalid_argument);
        EXPECT_THROW((void)with(member, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
    }
    EXPECT_THROW((void)with(&ChangeParams::fast, 1.1), std::invalid_argument);
    EXPECT_THROW((void)with(&ChangeParams::kept, 0.0), std::invalid_argument);
    EXPECT_THROW((void)with(&ChangeParams::least_count, 0.1), std::invalid_argument) << "more than may be kept";
}

}  // namespace sspql_adaptive_change_detector_test
