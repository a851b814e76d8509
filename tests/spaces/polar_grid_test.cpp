// SPDX-License-Identifier: MIT
#include <sspql/spaces/polar_grid.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

using sspql::index;
using sspql::PolarGrid;
using sspql::state_id;

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::array<double, 2> at(double degrees, double distance) {
    return {distance * std::cos(degrees * pi / 180.0), distance * std::sin(degrees * pi / 180.0)};
}

}  // namespace

static_assert(sspql::is_state_policy_v<PolarGrid, std::array<double, 2>>);
static_assert(!sspql::is_state_policy_v<PolarGrid, double>);

TEST(PolarGrid, IsThePushersGrid) {
    const PolarGrid grid(12, {0.7, 1.0});  // Fig. 7(a): 12 sectors, 3 rings
    EXPECT_EQ(grid.size(), 36u);
    EXPECT_EQ(grid.sectors(), 12u);
    EXPECT_EQ(grid.rings(), 3u);
    const std::array<double, 3> distances{0.5, 0.85, 3.0};
    for (std::size_t ring = 0; ring < 3; ++ring) {
        for (std::size_t sector = 0; sector < 12; ++sector) {
            const double degrees = 30.0 * static_cast<double>(sector);
            for (const double off : {-14.9, 0.0, 14.9}) {
                EXPECT_EQ(index(grid.encode(at(degrees + off, distances[ring]))), ring * 12 + sector)
                    << degrees + off << " deg";
            }
        }
    }
}

TEST(PolarGrid, SectorsAreCentredOnTheirAngle) {
    const PolarGrid grid(4, {});
    EXPECT_EQ(grid.rings(), 1u);
    EXPECT_EQ(index(grid.encode(std::array{1.0, 0.0})), 0u);
    EXPECT_EQ(index(grid.encode(std::array{0.0, 1.0})), 1u);
    EXPECT_EQ(index(grid.encode(std::array{-1.0, 0.0})), 2u);
    EXPECT_EQ(index(grid.encode(std::array{-1.0, -0.0})), 2u) << "atan2 gives -pi here";
    EXPECT_EQ(index(grid.encode(std::array{0.0, -1.0})), 3u);
    EXPECT_EQ(index(grid.encode(std::array{1.0, -0.9})), 0u);
    EXPECT_EQ(index(grid.encode(std::array{1.0, -1.1})), 3u);
    EXPECT_EQ(index(PolarGrid(1, {}).encode(at(200.0, 1.0))), 0u);
}

TEST(PolarGrid, AnglesComeRound) {
    const PolarGrid grid(12, {});
    for (int sector = 0; sector < 12; ++sector) {
        const double angle = sector * pi / 6.0;
        for (const int turns : {-5, -1, 0, 1, 7}) {
            EXPECT_EQ(grid.sector_of(angle + 2.0 * pi * turns), static_cast<std::size_t>(sector));
        }
    }
    EXPECT_EQ(grid.sector_of(-1e-300), 0u);
    EXPECT_EQ(grid.sector_of(-0.1), 0u);
    EXPECT_EQ(grid.sector_of(-0.3), 11u);
}

TEST(PolarGrid, RingsAreClosedBelowAndOpenAbove) {
    const PolarGrid grid(12, {0.5, 2.0});
    EXPECT_EQ(grid.ring_of(0.0), 0u);
    EXPECT_EQ(grid.ring_of(std::nextafter(0.5, 0.0)), 0u);
    EXPECT_EQ(grid.ring_of(0.5), 1u);
    EXPECT_EQ(grid.ring_of(std::nextafter(2.0, 0.0)), 1u);
    EXPECT_EQ(grid.ring_of(2.0), 2u);
    EXPECT_EQ(grid.ring_of(1e300), 2u);
    EXPECT_EQ(index(grid.encode(std::array{0.5, 0.0})), 12u);
    EXPECT_EQ(index(grid.encode(std::array{1e308, 1e308})), 2u * 12u + 2u)
        << "the distance overflows: 45 deg rounds up";
}

TEST(PolarGrid, OriginIsSectorZeroOfTheInnermostRing) {
    const PolarGrid grid(12, {0.7, 1.0});
    EXPECT_EQ(index(grid.encode(std::array{0.0, 0.0})), 0u);
    EXPECT_EQ(index(grid.encode(std::array{0.0, -0.0})), 0u);
}

TEST(PolarGrid, RefusesBrokenNumbers) {
    const PolarGrid grid(12, {0.7});
    for (const double bad : {not_a_number, infinity, -infinity}) {
        EXPECT_THROW((void)grid.encode(std::array{bad, 0.0}), std::invalid_argument);
        EXPECT_THROW((void)grid.encode(std::array{0.0, bad}), std::invalid_argument);
    }
    EXPECT_THROW((void)grid.encode(std::vector<double>{1.0}), std::invalid_argument);
}

TEST(PolarGrid, RefusesRingsAndSectorsThatMakeNoSense) {
    EXPECT_THROW(PolarGrid(0, {}), std::invalid_argument);
    EXPECT_THROW(PolarGrid(12, {0.0}), std::invalid_argument);
    EXPECT_THROW(PolarGrid(12, {-1.0}), std::invalid_argument);
    EXPECT_THROW(PolarGrid(12, {1.0, 1.0}), std::invalid_argument);
    EXPECT_THROW(PolarGrid(12, {1.0, 0.5}), std::invalid_argument);
    EXPECT_THROW(PolarGrid(12, {not_a_number}), std::invalid_argument);
    EXPECT_THROW(PolarGrid(12, {infinity}), std::invalid_argument);
    EXPECT_THROW(PolarGrid(2147483648u, {1.0}), std::invalid_argument);
}

TEST(PolarGrid, DescribesItsCells) {
    const PolarGrid grid(12, {0.7, 1.0});
    EXPECT_EQ(grid.describe(state_id(6)), "sector 6 (180 deg), ring 0 (< 0.7)");
    EXPECT_EQ(grid.describe(state_id(13)), "sector 1 (30 deg), ring 1 (0.7 to 1)");
    EXPECT_EQ(grid.describe(state_id(35)), "sector 11 (330 deg), ring 2 (>= 1)");
    EXPECT_EQ(PolarGrid(8, {}).describe(state_id(1)), "sector 1 (45 deg), ring 0 (any distance)");
    EXPECT_THROW((void)grid.describe(state_id(36)), std::invalid_argument);
}
