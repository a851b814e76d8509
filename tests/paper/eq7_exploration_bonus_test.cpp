// SPDX-License-Identifier: MIT
// Eq. 7: Q_EXP(s,a) = 1 / (N(s,a) + 1)^eta
#include <sspql/learn/exploration_bonus.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

using sspql::ExplorationBonus;

// eta = 1.5: N = 0: 1; N = 3: 1 / 4^1.5 = 1/8; N = 8: 1 / 9^1.5 = 1/27; N = 99: 1 / 100^1.5 = 1/1000
TEST(Eq7ExplorationBonus, IsOneOverNPlusOneToTheEta) {
    const ExplorationBonus bonus;
    EXPECT_EQ(bonus.eta(), 1.5) << "the paper's";
    EXPECT_EQ(bonus(0), 1.0);
    EXPECT_DOUBLE_EQ(bonus(1), 0.35355339059327373);
    EXPECT_DOUBLE_EQ(bonus(3), 0.125);
    EXPECT_DOUBLE_EQ(bonus(8), 1.0 / 27.0);
    EXPECT_DOUBLE_EQ(bonus(99), 0.001);
}

TEST(Eq7ExplorationBonus, OfEtaOneIsTheReciprocalAndOfEtaZeroConstant) {
    const ExplorationBonus reciprocal(1.0), constant(0.0);
    EXPECT_EQ(reciprocal(0), 1.0);
    EXPECT_DOUBLE_EQ(reciprocal(4), 0.2);
    EXPECT_EQ(constant(0), 1.0);
    EXPECT_EQ(constant(1000000), 1.0);
}

// The values up to 1023 come from a table, the others do not: 1024^-1.5 = 2^-15, 4096^-1.5 = 2^-18.
TEST(Eq7ExplorationBonus, HasNoSeamWhereTheTableEnds) {
    const ExplorationBonus bonus;
    EXPECT_DOUBLE_EQ(bonus(1023), std::pow(2.0, -15));
    EXPECT_DOUBLE_EQ(bonus(1024), std::pow(1025.0, -1.5));
    EXPECT_DOUBLE_EQ(bonus(4095), std::pow(2.0, -18));
    for (std::uint64_t n = 1; n < 3000; ++n) ASSERT_LT(bonus(n), bonus(n - 1)) << "n " << n;
}

TEST(Eq7ExplorationBonus, ApproachesZero) {
    const ExplorationBonus bonus;
    EXPECT_LT(bonus(std::numeric_limits<std::uint32_t>::max()), 1e-14);
    EXPECT_GE(bonus(std::numeric_limits<std::uint64_t>::max()), 0.0);
}

TEST(Eq7ExplorationBonus, RefusesAnEtaThatIsNegativeOrNotFinite) {
    for (const double bad : {-0.5, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        EXPECT_THROW(ExplorationBonus{bad}, std::invalid_argument);
    }
}
