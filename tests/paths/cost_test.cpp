// SPDX-License-Identifier: MIT
#include <sspql/paths/cost.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

using sspql::ExpectedTries;
using sspql::HopCount;
using sspql::LogRisk;
using sspql::RiskWeighted;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double e = 2.718281828459045;

}  // namespace

// 3 e^{-2 x 0.5} = 3 / e
TEST(RiskWeightedCost, IsWeightTimesExpOfMinusLambdaP) {
    EXPECT_EQ(RiskWeighted().lambda(), 2.0);
    EXPECT_DOUBLE_EQ(RiskWeighted()(3.0, 0.5), 3.0 / e);
    EXPECT_EQ(RiskWeighted(0.0)(3.0, 0.5), 3.0);
    EXPECT_DOUBLE_EQ(RiskWeighted(1.0)(1.0, 4.0), 1.0 / (e * e * e * e)) << "eq. 3 can exceed 1";
}

TEST(ExpectedTriesCost, IsWeightOverP) {
    EXPECT_EQ(ExpectedTries()(3.0, 0.25), 12.0);
    EXPECT_EQ(ExpectedTries()(3.0, 1.0), 3.0);
    EXPECT_EQ(ExpectedTries()(3.0, 2.5), 3.0) << "no cheaper than certain";
}

// 0.5 - 2 ln(1/e) = 2.5
TEST(LogRiskCost, IsWeightMinusLambdaLogP) {
    EXPECT_EQ(LogRisk().lambda(), 1.0);
    EXPECT_DOUBLE_EQ(LogRisk(2.0)(0.5, 1.0 / e), 2.5);
    EXPECT_EQ(LogRisk(2.0)(0.5, 1.0), 0.5);
    EXPECT_EQ(LogRisk(2.0)(0.5, 3.0), 0.5) << "never below the weight";
}

// Two halves in a row are as likely as a quarter: with a small weight both ways cost the same.
TEST(LogRiskCost, AddsUpToTheLogOfAPathsProbability) {
    const LogRisk cost(1.0);
    EXPECT_NEAR(cost(1e-30, 0.5) + cost(1e-30, 0.5), cost(1e-30, 0.25), 1e-15);
}

TEST(HopCountCost, IsOne) {
    EXPECT_EQ(HopCount()(1e30, 0.001), 1.0);
    EXPECT_EQ(HopCount()(1e-30, 1.0), 1.0);
}

TEST(CostPolicies, RefuseALambdaThatIsNegativeOrNotFinite) {
    for (const double bad : {-0.1, not_a_number, infinity, -infinity}) {
        EXPECT_THROW(RiskWeighted{bad}, std::invalid_argument);
        EXPECT_THROW(LogRisk{bad}, std::invalid_argument);
    }
    EXPECT_NO_THROW(RiskWeighted{0.0});
    EXPECT_NO_THROW(LogRisk{0.0});
}

TEST(CostPolicies, StayFiniteAndNotNegativeAtTheLimits) {
    for (const double weight : {1e-30, 1.0, 1e30}) {
        for (const double p : {1e-9, 0.5, 1.0, 40.0}) {
            for (const double cost : {RiskWeighted()(weight, p), ExpectedTries()(weight, p), LogRisk()(weight, p)}) {
                EXPECT_TRUE(std::isfinite(cost) && cost > 0.0) << weight << " " << p;
            }
        }
    }
}
