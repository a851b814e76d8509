// SPDX-License-Identifier: MIT
#include <sspql/learn/exploration_bonus.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace sspql_exploration_bonus_test {

using sspql::ExplorationBonus;

TEST(ExplorationBonus, IsEq7InsideAndBeyondTheTable) {
    for (const double eta : {0.0, 0.5, 1.0, 1.5, 4.0}) {
        const ExplorationBonus bonus(eta);
        EXPECT_EQ(bonus.eta(), eta);
        EXPECT_EQ(bonus(0), 1.0);
        for (const std::uint64_t n :
             {1ull, 2ull, 3ull, 99ull, 1022ull, 1023ull, 1024ull, 1025ull, 5000000ull, 1ull << 50}) {
            EXPECT_EQ(bonus(n), std::pow(static_cast<double>(n) + 1.0, -eta)) << eta << ", " << n;
        }
    }
}

TEST(ExplorationBonus, FallsTowardsZero) {
    const ExplorationBonus bonus;
    EXPECT_EQ(bonus.eta(), 1.5);
    for (std::uint64_t n = 0; n < 3000; ++n) EXPECT_GT(bonus(n), bonus(n + 1));
    EXPECT_LT(bonus(std::uint64_t{1} << 40), 1e-17);
}

TEST(ExplorationBonus, RefusesEtaOutside) {
    EXPECT_THROW(ExplorationBonus{-0.1}, std::invalid_argument);
    EXPECT_THROW(ExplorationBonus{std::numeric_limits<double>::quiet_NaN()}, std::invalid_argument);
    EXPECT_THROW(ExplorationBonus{std::numeric_limits<double>::infinity()}, std::invalid_argument);
}

}  // namespace sspql_exploration_bonus_test
