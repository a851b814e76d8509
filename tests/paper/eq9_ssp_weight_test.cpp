// SPDX-License-Identifier: MIT
// Eq. 9: 0 <= w_SSP(s,a) <= 1, tending to 0; for instance [N(s,a)]^-t
#include <sspql/learn/schedule.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <sspql/learn/sspql.hpp>

using sspql::ActionId;
using sspql::Constant;
using sspql::ExponentialDecay;
using sspql::Schedule;
using sspql::Sspql;
using sspql::SspqlParams;
using sspql::StateId;
using sspql::VisitDecay;

namespace {

constexpr ActionId a0{0};
constexpr StateId s0{0}, s1{1};

}  // namespace

// p = 2: 1 for N = 0 and 1, then 1/4, 1/9, 1/16; N = 100: 1/10000.
TEST(Eq9Weight, IsTheLesserOfOneAndNToTheMinusP) {
    const Schedule weight = VisitDecay{};
    EXPECT_EQ(weight(0), 1.0);
    EXPECT_EQ(weight(1), 1.0);
    EXPECT_DOUBLE_EQ(weight(2), 1.0 / 4.0);
    EXPECT_DOUBLE_EQ(weight(3), 1.0 / 9.0);
    EXPECT_DOUBLE_EQ(weight(4), 1.0 / 16.0);
    EXPECT_DOUBLE_EQ(weight(100), 1e-4);
}

// Deviation: t is an exponent, not time. p = 1/2: 4^{-1/2} = 1/2; p = 0 is the constant 1.
TEST(Eq9Weight, HasAnyExponentFromZero) {
    EXPECT_DOUBLE_EQ(Schedule(VisitDecay{0.5})(4), 0.5);
    EXPECT_DOUBLE_EQ(Schedule(VisitDecay{1.0})(7), 1.0 / 7.0);
    EXPECT_EQ(Schedule(VisitDecay{0.0})(1000000), 1.0);
    EXPECT_THROW(Schedule(VisitDecay{-1.0}), std::invalid_argument);
    EXPECT_THROW(Schedule(VisitDecay{std::numeric_limits<double>::quiet_NaN()}), std::invalid_argument);
}

// The table ends at 1023: 1024^-2 = 2^-20.
TEST(Eq9Weight, HasNoSeamWhereTheTableEnds) {
    const Schedule weight = VisitDecay{};
    EXPECT_DOUBLE_EQ(weight(1024), std::pow(2.0, -20));
    for (std::uint64_t n = 2; n < 3000; ++n) ASSERT_LT(weight(n), weight(n - 1)) << "n " << n;
}

TEST(Eq9Weight, TendsToZero) {
    EXPECT_LT(Schedule(VisitDecay{})(1u << 31), 1e-18);
    EXPECT_LT(Schedule(ExponentialDecay{1.0, 0.01, 0.0})(10000), 1e-40);
}

// start 0.9, floor 0.1, rate ln 2: 0.1 + 0.8 / 2^N.
TEST(Eq9Weight, MayDecayExponentially) {
    const Schedule weight = ExponentialDecay{0.9, std::log(2.0), 0.1};
    EXPECT_DOUBLE_EQ(weight(0), 0.9);
    EXPECT_DOUBLE_EQ(weight(1), 0.5);
    EXPECT_DOUBLE_EQ(weight(3), 0.2);
}

// A learner refuses what breaks the equation's first half: a weight above 1.
TEST(Eq9Weight, AboveOneIsRefusedByTheLearner) {
    SspqlParams<> params;
    params.ssp_decay = Constant{1.5};
    EXPECT_THROW(Sspql<>(2, 2, params), std::invalid_argument);
    params.ssp_decay = ExponentialDecay{2.0, 0.1, 0.0};
    EXPECT_THROW(Sspql<>(2, 2, params), std::invalid_argument);
    params.ssp_decay = Constant{1.0};
    EXPECT_NO_THROW(Sspql<>(2, 2, params));
}

// In the learner: N = 1, 2, 3 of a certain step to the goal weigh Q_SSP = 1 by 1, 1/4, 1/9.
TEST(Eq9Weight, CountsVisitsOfTheStateAndAction) {
    Sspql<> learner(3, 2);
    for (const double expected : {1.0, 1.0 / 4.0, 1.0 / 9.0}) {
        learner.observe(s0, a0, 1.0, s1, true);
        EXPECT_DOUBLE_EQ(learner.terms(s0, a0).ssp, expected);
        EXPECT_EQ(learner.terms(s0, ActionId{1}).ssp, 0.0);
    }
}

// Deviation: visits are counted since the goals were set, so that another goal is followed at once.
TEST(Eq9Weight, StartsAnewWithOtherGoals) {
    Sspql<> learner(3, 2);
    for (int i = 0; i < 10; ++i) learner.observe(s0, a0, 1.0, s1, true);
    EXPECT_DOUBLE_EQ(learner.terms(s0, a0).ssp, 0.01);
    learner.set_goals({{s1, 0.0}});
    EXPECT_EQ(learner.terms(s0, a0).ssp, 1.0);
    EXPECT_EQ(learner.terms(s0, a0).n, 10.0) << "the model stays";
}
