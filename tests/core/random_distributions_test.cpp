// SPDX-License-Identifier: MIT
#include <sspql/core/random.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

using sspql::Random;

namespace {

/// Chi-square of `draws` values of below(n) against the uniform distribution, in standard deviations from its mean.
double chi_square_deviations(std::uint64_t seed, std::size_t n, std::size_t draws) {
    Random random(seed);
    std::vector<double> seen(n, 0.0);
    for (std::size_t i = 0; i < draws; ++i) ++seen[random.below(n)];
    const double expected = static_cast<double>(draws) / static_cast<double>(n);
    double chi = 0.0;
    for (const double count : seen) chi += (count - expected) * (count - expected) / expected;
    const auto freedom = static_cast<double>(n - 1);
    return (chi - freedom) / std::sqrt(2.0 * freedom);
}

}  // namespace

TEST(RandomUniform, LiesInTheHalfOpenInterval) {
    Random random(1);
    double least = 1.0;
    double most = 0.0;
    double sum = 0.0;
    constexpr int draws = 200000;
    for (int i = 0; i < draws; ++i) {
        const double u = random.uniform();
        ASSERT_GE(u, 0.0);
        ASSERT_LT(u, 1.0);
        ASSERT_EQ(std::ldexp(u, 53), std::floor(std::ldexp(u, 53))) << "a multiple of 2^-53";
        least = std::min(least, u);
        most = std::max(most, u);
        sum += u;
    }
    EXPECT_LT(least, 1e-4);
    EXPECT_GT(most, 1.0 - 1e-4);
    EXPECT_NEAR(sum / draws, 0.5, 4.0 / std::sqrt(12.0 * draws));
}

TEST(RandomUniform, RangeExcludesItsUpperEnd) {
    Random random(2);
    const double high = std::nextafter(1.0, 2.0);
    for (int i = 0; i < 1000; ++i) {
        EXPECT_EQ(random.uniform(1.0, high), 1.0) << "no number lies between; rounding must not reach high";
        const double x = random.uniform(-3.0, -1.5);
        EXPECT_GE(x, -3.0);
        EXPECT_LT(x, -1.5);
        EXPECT_EQ(random.uniform(2.5, 2.5), 2.5);
    }
}

TEST(RandomUniform, ChanceOfZeroNeverAndOfOneAlwaysHappens) {
    Random random(3);
    int hits = 0;
    for (int i = 0; i < 10000; ++i) {
        EXPECT_FALSE(random.chance(0.0));
        EXPECT_FALSE(random.chance(-1.0));
        EXPECT_TRUE(random.chance(1.0));
        hits += random.chance(0.3) ? 1 : 0;
    }
    EXPECT_NEAR(hits, 3000, 4.0 * std::sqrt(10000 * 0.3 * 0.7));
}

TEST(RandomBelow, OneHasOneValue) {
    Random random(4);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(random.below(1), 0u);
}

TEST(RandomBelow, IsUniform) {
    for (const std::size_t n : {2u, 3u, 4u, 7u, 10u, 64u, 1000u}) {
        for (const std::uint64_t seed : {1u, 2u, 3u}) {
            EXPECT_LT(std::fabs(chi_square_deviations(seed, n, 200000)), 4.5) << "n " << n << ", seed " << seed;
        }
    }
}

TEST(RandomBelow, IsUniformWhereScalingAloneWouldNotBe) {
    // 3 * 2^62 values: scaling 64 bits without rejection gives every third value twice as often.
    const auto n = static_cast<std::size_t>(std::uint64_t{3} << 62);
    Random random(5);
    std::array<double, 3> residue{};
    for (int i = 0; i < 30000; ++i) {
        const std::size_t value = random.below(n);
        ASSERT_LT(value, n);
        ++residue[value % 3];
    }
    for (const double count : residue) EXPECT_NEAR(count, 10000, 4.0 * std::sqrt(30000 * 2.0 / 9.0));
}

TEST(RandomNormal, HasTheMomentsOfTheNormalDistribution) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        Random random(seed);
        constexpr int n = 400000;
        std::array<double, 5> moment{};
        for (int i = 0; i < n; ++i) {
            const double x = random.normal();
            double power = 1.0;
            for (double& m : moment) {
                m += power / n;
                power *= x;
            }
        }
        const double error = 4.5 / std::sqrt(static_cast<double>(n));
        EXPECT_NEAR(moment[1], 0.0, error) << "seed " << seed;
        EXPECT_NEAR(moment[2], 1.0, error * std::sqrt(2.0)) << "seed " << seed;
        EXPECT_NEAR(moment[3], 0.0, error * std::sqrt(15.0)) << "seed " << seed;
        EXPECT_NEAR(moment[4], 3.0, error * std::sqrt(96.0)) << "seed " << seed;
    }
}

TEST(RandomNormal, HasTheTailsOfTheNormalDistribution) {
    Random random(4);
    constexpr int n = 1000000;
    const std::array<double, 4> bounds{1.0, 2.0, 3.0, 4.0};
    std::array<int, 4> beyond{};
    double greatest = 0.0;
    for (int i = 0; i < n; ++i) {
        const double x = std::fabs(random.normal());
        greatest = std::max(greatest, x);
        for (std::size_t b = 0; b < bounds.size(); ++b) beyond[b] += x > bounds[b] ? 1 : 0;
    }
    for (std::size_t b = 0; b < bounds.size(); ++b) {
        const double p = std::erfc(bounds[b] / std::sqrt(2.0));
        EXPECT_NEAR(beyond[b], n * p, 4.5 * std::sqrt(n * p)) << "beyond " << bounds[b];
    }
    EXPECT_GT(greatest, 4.3);
    EXPECT_LT(greatest, 6.5);
}

TEST(RandomNormal, TakesMeanAndDeviation) {
    Random plain(6);
    Random scaled(6);
    for (int i = 0; i < 100; ++i) {
        const double x = plain.normal();
        EXPECT_EQ(scaled.normal(3.0, 2.0), 3.0 + 2.0 * x);
    }
    EXPECT_EQ(scaled.normal(5.0, 0.0), 5.0);
}
