// SPDX-License-Identifier: MIT
#include <sspql/spaces/uniform_grid.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Core>

using sspql::GridAxis;
using sspql::index;
using sspql::state_id;
using sspql::UniformGrid;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::size_t cell(const UniformGrid<1>& grid, double x) { return index(grid.encode(std::array{x})); }

UniformGrid<1> one_axis(const GridAxis& axis) { return UniformGrid<1>({axis}); }

}  // namespace

static_assert(sspql::is_state_policy_v<UniformGrid<2>, std::array<double, 2>>);
static_assert(sspql::is_state_policy_v<UniformGrid<2>, std::vector<float>>);
static_assert(sspql::is_state_policy_v<UniformGrid<2>, int[2]>);
static_assert(!sspql::is_state_policy_v<UniformGrid<2>, double>);
static_assert(!sspql::grows_v<UniformGrid<2>>);

TEST(UniformGrid, CellsAreClosedBelowAndOpenAbove) {
    const auto grid = one_axis({0.0, 2.0, 4});
    EXPECT_EQ(grid.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        const double edge = 0.5 * static_cast<double>(i);
        EXPECT_EQ(cell(grid, edge), i);
        EXPECT_EQ(cell(grid, std::nextafter(edge + 0.5, 0.0)), i);
    }
}

TEST(UniformGrid, ClampsWhatLiesOutside) {
    const auto grid = one_axis({-1.0, 1.0, 5});
    EXPECT_EQ(cell(grid, -1.0), 0u);
    EXPECT_EQ(cell(grid, -1e300), 0u);
    EXPECT_EQ(cell(grid, 1.0), 4u);
    EXPECT_EQ(cell(grid, 1.7e308), 4u);
}

TEST(UniformGrid, PeriodicAxesComeRound) {
    const auto grid = one_axis({0.0, 360.0, 12, true});
    for (const double turns : {-3.0, -1.0, 0.0, 1.0, 1000.0}) {
        EXPECT_EQ(cell(grid, 360.0 * turns), 0u);
        EXPECT_EQ(cell(grid, 360.0 * turns + 45.0), 1u);
        EXPECT_EQ(cell(grid, 360.0 * turns - 1.0), 11u);
    }
    const auto shifted = one_axis({-180.0, 180.0, 4, true});
    EXPECT_EQ(cell(shifted, 180.0), 0u);
    EXPECT_EQ(cell(shifted, -180.0), 0u);
    EXPECT_EQ(cell(shifted, 179.0), 3u);
    EXPECT_LT(cell(grid, -1e-300), 12u) << "rounding to a whole period";
    EXPECT_LT(cell(grid, std::nextafter(360.0, 0.0)), 12u);
}

TEST(UniformGrid, RefusesNaNAndInfinity) {
    const UniformGrid<2> grid({{{0.0, 1.0, 2}, {0.0, 1.0, 2, true}}});
    for (const double bad : {not_a_number, infinity, -infinity}) {
        EXPECT_THROW((void)grid.encode(std::array{bad, 0.5}), std::invalid_argument);
        EXPECT_THROW((void)grid.encode(std::array{0.5, bad}), std::invalid_argument);
    }
}

TEST(UniformGrid, RefusesAVectorThatIsTooShort) {
    const UniformGrid<2> grid({{{0.0, 1.0, 2}, {0.0, 1.0, 2}}});
    EXPECT_THROW((void)grid.encode(std::vector<double>{0.5}), std::invalid_argument);
    EXPECT_THROW((void)grid.encode(std::vector<double>{}), std::invalid_argument);
    EXPECT_THROW((void)grid.encode(Eigen::VectorXd(1)), std::invalid_argument);
}

TEST(UniformGrid, TakesAnythingWithAnIndexOperator) {
    const UniformGrid<2> grid({{{0.0, 4.0, 4}, {0.0, 3.0, 3}}});
    const int plain[2] = {2, 1};
    EXPECT_EQ(index(grid.encode(plain)), 7u);
    EXPECT_EQ(index(grid.encode(std::array<float, 2>{2.5f, 1.5f})), 7u);
    EXPECT_EQ(index(grid.encode(std::vector<double>{2.5, 1.5})), 7u);
    EXPECT_EQ(index(grid.encode(Eigen::Vector2d(2.5, 1.5))), 7u);
}

TEST(UniformGrid, LastDimensionVariesFastest) {
    const UniformGrid<3> grid({{{0, 2, 2}, {0, 3, 3}, {0, 5, 5}}});
    EXPECT_EQ(grid.size(), 30u);
    std::size_t id = 0;
    for (int x = 0; x < 2; ++x) {
        for (int y = 0; y < 3; ++y) {
            for (int z = 0; z < 5; ++z) EXPECT_EQ(index(grid.encode(std::array{x, y, z})), id++);
        }
    }
}

TEST(UniformGrid, CentersEncodeToTheirState) {
    const UniformGrid<3> grid({{{-1.0, 1.0, 7}, {0.1, 0.4, 3, true}, {-1e6, 1e-6, 11}}});
    for (std::size_t s = 0; s < grid.size(); ++s) {
        EXPECT_EQ(index(grid.encode(grid.center(state_id(s)))), s);
    }
    const auto fine = one_axis({0.0, 0.1, 100000});
    for (std::size_t s = 0; s < fine.size(); ++s) ASSERT_EQ(index(fine.encode(fine.center(state_id(s)))), s);
}

TEST(UniformGrid, DescribesItsBoxes) {
    const UniformGrid<2> grid({{{0.0, 1.0, 2}, {0.0, 12.0, 4}}});
    EXPECT_EQ(grid.describe(state_id(0)), "[0, 0.5) x [0, 3)");
    EXPECT_EQ(grid.describe(state_id(7)), "[0.5, 1) x [9, 12)");
    EXPECT_THROW((void)grid.describe(state_id(8)), std::invalid_argument);
    EXPECT_THROW((void)grid.center(sspql::no_state), std::invalid_argument);
}

TEST(UniformGrid, RefusesAxesThatMakeNoSense) {
    EXPECT_THROW(one_axis({1.0, 1.0, 2}), std::invalid_argument);
    EXPECT_THROW(one_axis({1.0, 0.0, 2}), std::invalid_argument);
    EXPECT_THROW(one_axis({0.0, 1.0, 0}), std::invalid_argument);
    EXPECT_THROW(one_axis({not_a_number, 1.0, 2}), std::invalid_argument);
    EXPECT_THROW(one_axis({0.0, infinity, 2}), std::invalid_argument);
    EXPECT_THROW(one_axis({-1.7e308, 1.7e308, 2}), std::invalid_argument) << "the range is infinite";
}

TEST(UniformGrid, RefusesMoreBoxesThanThereAreIds) {
    EXPECT_THROW((UniformGrid<2>({{{0, 1, 65536}, {0, 1, 65536}}})), std::invalid_argument);
    EXPECT_THROW((UniformGrid<3>({{{0, 1, 4294967294u}, {0, 1, 4294967294u}, {0, 1, 2}}})), std::invalid_argument);
    EXPECT_THROW((UniformGrid<2>({{{0, 1, 65535}, {0, 1, 65537}}})), std::invalid_argument) << "2^32 - 1";
    EXPECT_EQ((UniformGrid<2>({{{0, 1, 2}, {0, 1, 2147483647}}}).size()), 4294967294u);
}
