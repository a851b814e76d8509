// SPDX-License-Identifier: MIT
#include <sspql/spaces/product_state.hpp>

#include <array>
#include <cstddef>
#include <stdexcept>

#include <gtest/gtest.h>

#include <sspql/spaces/enum_state.hpp>
#include <sspql/spaces/hashed_state.hpp>
#include <sspql/spaces/polar_grid.hpp>
#include <sspql/spaces/uniform_grid.hpp>

using sspql::EnumState;
using sspql::GridAxis;
using sspql::index;
using sspql::PolarGrid;
using sspql::ProductState;
using sspql::ProjectedState;
using sspql::state_id;
using sspql::UniformGrid;

namespace {

struct Scan {
    double x = 0.0;
    double y = 0.0;
    double heading_deg = 0.0;
    bool holding = false;
};

/// Position x heading x gripper, as a robot would write it.
auto robot_state() {
    return ProductState(ProjectedState(PolarGrid(12, {0.7, 1.0}),
                                       [](const Scan& scan) {
                                           return std::array{scan.x, scan.y};
                                       }),
                        ProjectedState(UniformGrid<1>({GridAxis{0.0, 360.0, 12, true}}),
                                       [](const Scan& scan) { return std::array{scan.heading_deg}; }),
                        ProjectedState(EnumState<bool>(2), [](const Scan& scan) { return scan.holding; }));
}

}  // namespace

TEST(ProductState, LastFactorVariesFastest) {
    auto state = robot_state();
    EXPECT_EQ(state.size(), 36u * 12u * 2u);
    EXPECT_EQ(index(state.encode(Scan{0.5, 0.0, 0.0, false})), 0u);
    EXPECT_EQ(index(state.encode(Scan{0.5, 0.0, 0.0, true})), 1u);
    EXPECT_EQ(index(state.encode(Scan{0.5, 0.0, 30.0, false})), 2u);
    EXPECT_EQ(index(state.encode(Scan{2.0, 0.0, 359.0, true})), (24u * 12u + 11u) * 2u + 1u);
}

TEST(ProductState, EveryIdComesBack) {
    ProductState state(
        ProjectedState(EnumState<std::size_t>(3), [](const std::array<std::size_t, 3>& o) { return o[0]; }),
        ProjectedState(EnumState<std::size_t>(5), [](const std::array<std::size_t, 3>& o) { return o[1]; }),
        ProjectedState(EnumState<std::size_t>(7), [](const std::array<std::size_t, 3>& o) { return o[2]; }));
    ASSERT_EQ(state.size(), 105u);
    for (std::size_t id = 0; id < state.size(); ++id) {
        const std::array<std::size_t, 3> observation{id / 35, id / 7 % 5, id % 7};
        EXPECT_EQ(index(state.encode(observation)), id);
        EXPECT_EQ(state.describe(state_id(id)), std::to_string(observation[0]) + "; " + std::to_string(observation[1]) +
                                                    "; " + std::to_string(observation[2]));
    }
}

TEST(ProductState, DescribesEachFactor) {
    auto state = robot_state();
    EXPECT_EQ(state.describe(state.encode(Scan{0.8, 0.0, 45.0, true})),
              "sector 0 (0 deg), ring 1 (0.7 to 1); [30, 60); 1");
    EXPECT_THROW((void)state.describe(state_id(state.size())), std::invalid_argument);
}

TEST(ProductState, PassesOnWhatAFactorRefuses) {
    auto state = robot_state();
    EXPECT_THROW((void)state.encode(Scan{1.0 / 0.0, 0.0, 0.0, false}), std::invalid_argument);
}

TEST(ProductState, RefusesMoreStatesThanThereAreIds) {
    using Big = EnumState<std::size_t>;
    EXPECT_THROW((ProductState(Big(65536), Big(65536))), std::invalid_argument);
    EXPECT_THROW((ProductState(Big(4294967294u), Big(4294967294u), Big(4294967294u))), std::invalid_argument);
    EXPECT_EQ((ProductState(Big(2), Big(2147483647)).size()), 4294967294u);
}

TEST(ProductState, GivesItsFactors) {
    const auto state = robot_state();
    EXPECT_EQ(state.factor<0>().policy().rings(), 3u);
    EXPECT_EQ(state.factor<1>().size(), 12u);
}

TEST(ProjectedState, ShowsAPartOfTheObservation) {
    ProjectedState state(UniformGrid<2>({{{0, 4, 4}, {0, 4, 4}}}), [](const Scan& s) { return std::array{s.x, s.y}; });
    EXPECT_EQ(state.size(), 16u);
    EXPECT_EQ(index(state.encode(Scan{1.5, 2.5})), 6u);
    EXPECT_EQ(state.describe(state_id(6)), "[1, 2) x [2, 3)");
    EXPECT_EQ(state.policy().axes()[0].cells, 4u);
    static_assert(!sspql::grows_v<decltype(state)>);
}

TEST(ProjectedState, GrowsWithAPolicyThatGrows) {
    ProjectedState state(sspql::HashedState<int>{}, [](const Scan& scan) { return static_cast<int>(scan.x); });
    static_assert(sspql::grows_v<decltype(state)>);
    EXPECT_EQ(index(state.encode(Scan{5.2})), 0u);
    EXPECT_EQ(index(state.encode(Scan{7.2})), 1u);
    EXPECT_EQ(index(state.encode(Scan{5.9})), 0u);
    EXPECT_EQ(state.size(), 2u);
}
