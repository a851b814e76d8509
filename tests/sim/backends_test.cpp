// SPDX-License-Identifier: MIT
// What every PusherBackend must do: the same tests for both.
#include <sspql/sim/backend.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/sim/box2d_backend.hpp>
#include <sspql/sim/kinematic_backend.hpp>

namespace sim = sspql::sim;
using sim::Pose;
using sim::PusherParams;
using sim::Stop;

namespace {

template <class Backend>
class PusherBackend : public testing::Test {
protected:
    /// How far from the exact place a stop may be: a time step's way, or a leap.
    static constexpr double slack_m = 0.008;

    static PusherParams without_safety() {
        PusherParams params;
        params.guard = false;
        params.fence = false;
        return params;
    }
};

using Backends = testing::Types<sim::KinematicBackend, sim::Box2dBackend>;
TYPED_TEST_SUITE(PusherBackend, Backends, );

/// FNV-1a over the bits of a pose.
void mix(std::uint64_t& hash, const Pose& pose) {
    for (const double value : {pose.x_m, pose.y_m, pose.heading_rad}) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        for (int byte = 0; byte < 8; ++byte) hash = (hash ^ ((bits >> (8 * byte)) & 0xFFu)) * 0x100000001B3ull;
    }
}

/// 60 random moves near the box, contacts included.
template <class Backend>
std::uint64_t hash_of_moves(Backend& backend, std::uint64_t seed) {
    sspql::Random random(seed);
    std::uint64_t hash = 0xCBF29CE484222325ull;
    backend.reset({-0.5, 0.1, 0.0}, {0.0, 0.0, 0.2}, {1.3, 0.0});
    for (int i = 0; i < 60; ++i) {
        const double amount = random.uniform(-0.3, 0.3);
        const double drift = random.uniform(-0.1, 0.1);
        if (random.chance(0.3)) {
            backend.rotate(3.0 * amount);
        } else {
            backend.translate(amount, drift);
        }
        mix(hash, backend.robot());
        mix(hash, backend.box());
    }
    return hash;
}

}  // namespace

TYPED_TEST(PusherBackend, DrivesForwardAndBackInFreeSpace) {
    TypeParam backend{PusherParams{}};
    backend.reset({-1.0, -0.5, sim::pi / 2.0}, {0.0, 0.0, 0.0}, {1.3, 0.0});
    const sim::Move out = backend.translate(0.3, 0.0);
    EXPECT_EQ(out.stop, Stop::done);
    EXPECT_NEAR(out.amount, 0.3, 0.0021);
    EXPECT_NEAR(backend.robot().x_m, -1.0, 1e-3);
    EXPECT_NEAR(backend.robot().y_m, -0.2, 0.0021);
    const sim::Move back = backend.translate(-0.2, 0.0);
    EXPECT_EQ(back.stop, Stop::done);
    EXPECT_NEAR(back.amount, -0.2, 0.0021);
    EXPECT_NEAR(backend.robot().y_m, -0.4, 0.0042);
    EXPECT_NEAR(backend.robot().heading_rad, sim::pi / 2.0, 1e-3);
    EXPECT_TRUE(backend.box() == (Pose{0.0, 0.0, 0.0}));
    EXPECT_TRUE(backend.goal() == (sim::Point{1.3, 0.0}));
}

TYPED_TEST(PusherBackend, TurnsOnTheSpotBothWays) {
    TypeParam backend{PusherParams{}};
    backend.reset({-1.0, 0.0, 3.0}, {0.0, 0.0, 0.0}, {1.3, 0.0});
    const double step = sim::from_degrees(30.0);
    EXPECT_NEAR(backend.rotate(step).amount, step, 0.0031);
    EXPECT_NEAR(backend.robot().heading_rad, 3.0 + step - 2.0 * sim::pi, 0.0031);  // wrapped
    EXPECT_NEAR(backend.rotate(-step).amount, -step, 0.0031);
    EXPECT_NEAR(backend.robot().heading_rad, 3.0, 0.0062);
    EXPECT_NEAR(backend.robot().x_m, -1.0, 1e-4);
    EXPECT_NEAR(backend.robot().y_m, 0.0, 1e-4);
}

TYPED_TEST(PusherBackend, DriftBendsTheWay) {
    TypeParam backend{PusherParams{}};
    backend.reset({-1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {1.3, 0.0});
    backend.translate(0.3, 0.2);
    // An arc of 0.3 m over 0.2 rad ends 0.3 * 0.1 (half the angle) = 0.03 to the left.
    EXPECT_NEAR(backend.robot().heading_rad, 0.2, 0.01);
    EXPECT_NEAR(backend.robot().y_m, 0.03, 0.003);
    EXPECT_NEAR(backend.robot().x_m, -0.7, 0.006);
}

TYPED_TEST(PusherBackend, GuardStopsBeforeTheBoxAndTheBoxStays) {
    TypeParam backend{PusherParams{}};
    for (const bool forward : {true, false}) {
        backend.reset({-0.55, 0.0, forward ? 0.0 : sim::pi}, {0.0, 0.0, 0.0}, {1.3, 0.0});
        // Gap to the box 0.55 - 0.2 - 0.15 = 0.2; stop at 0.06, after 0.14.
        const sim::Move move = backend.translate(forward ? 0.3 : -0.3, 0.0);
        EXPECT_EQ(move.stop, Stop::guard);
        EXPECT_NEAR(std::fabs(move.amount), 0.14, this->slack_m);
        EXPECT_NEAR(backend.robot().x_m, -0.41, this->slack_m);
        EXPECT_LT(std::fabs(backend.box().x_m) + std::fabs(backend.box().y_m), 1e-12);
        // Standing there, the same action does nothing at all: a self-loop.
        const Pose here = backend.robot();
        const sim::Move again = backend.translate(forward ? 0.3 : -0.3, 0.1);
        EXPECT_EQ(again.stop, Stop::guard);
        EXPECT_EQ(again.amount, 0.0);
        EXPECT_TRUE(backend.robot() == here);
        // And away is free.
        EXPECT_EQ(backend.translate(forward ? -0.2 : 0.2, 0.0).stop, Stop::done);
    }
}

TYPED_TEST(PusherBackend, GuardStopsBeforeTheWall) {
    PusherParams params;
    params.fence = false;
    TypeParam backend{params};
    backend.reset({2.1, 0.0, 0.0}, {0.0, 0.0, 0.0}, {1.3, 0.0});
    const sim::Move move = backend.translate(0.3, 0.0);  // gap 2.5 - 2.1 - 0.2 = 0.2
    EXPECT_EQ(move.stop, Stop::guard);
    EXPECT_NEAR(move.amount, 0.14, this->slack_m);
}

TYPED_TEST(PusherBackend, FenceStopsTheWayOutAndLetsBackIn) {
    PusherParams params;
    TypeParam backend{params};
    backend.reset({-1.1, 0.0, sim::pi}, {0.0, 0.0, 0.0}, {1.3, 0.0});
    const sim::Move out = backend.translate(0.3, 0.0);
    EXPECT_EQ(out.stop, Stop::fence);
    EXPECT_NEAR(out.amount, 0.2, 0.0021);
    EXPECT_LE(sim::distance_m(sim::position(backend.robot()), {}), 1.3 + 1e-4);
    EXPECT_NEAR(backend.translate(0.3, 0.0).amount, 0.0, 0.0021);
    EXPECT_EQ(backend.translate(-0.2, 0.0).stop, Stop::done);
    // Outside: away is refused, back is free.
    backend.reset({-1.8, 0.0, sim::pi}, {0.0, 0.0, 0.0}, {1.3, 0.0});
    const sim::Move away = backend.translate(0.3, 0.0);
    EXPECT_EQ(away.stop, Stop::fence);
    EXPECT_EQ(away.amount, 0.0);
    EXPECT_EQ(backend.translate(-0.2, 0.0).stop, Stop::done);
    EXPECT_NEAR(backend.robot().x_m, -1.6, 0.0021);
}

TYPED_TEST(PusherBackend, WallsHoldWithoutGuardAndFence) {
    TypeParam backend{this->without_safety()};
    const Pose starts[] = {
        {2.1, 1.0, 0.0}, {1.0, 2.1, sim::pi / 2.0}, {-2.1, 1.0, sim::pi}, {1.0, -2.1, -sim::pi / 2.0}};
    for (const Pose& start : starts) {
        backend.reset(start, {0.0, 0.0, 0.0}, {1.3, 0.0});
        const sim::Move move = backend.translate(0.5, 0.0);  // gap 0.2
        EXPECT_NE(move.stop, Stop::done) << start.x_m << " " << start.y_m;
        EXPECT_NEAR(move.amount, 0.2, 0.012) << start.x_m << " " << start.y_m;
        EXPECT_EQ(backend.translate(-0.2, 0.0).stop, Stop::done);
    }
}

TYPED_TEST(PusherBackend, SameMovesSameBitsReusedOrRebuilt) {
    TypeParam reused{this->without_safety()};
    TypeParam guarded{PusherParams{}};
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        TypeParam rebuilt{this->without_safety()};
        EXPECT_EQ(hash_of_moves(reused, seed), hash_of_moves(rebuilt, seed)) << seed;
    }
    EXPECT_NE(hash_of_moves(reused, 1), hash_of_moves(reused, 2));
    EXPECT_NE(hash_of_moves(reused, 1), hash_of_moves(guarded, 1));
}

TYPED_TEST(PusherBackend, MovesWithItsWorld) {
    static_assert(std::is_move_constructible_v<TypeParam> && std::is_move_assignable_v<TypeParam>);
    TypeParam first{PusherParams{}};
    first.reset({-1.0, 0.2, 0.5}, {0.0, 0.0, 0.0}, {1.3, 0.0});
    const Pose before = first.robot();
    TypeParam second(std::move(first));
    EXPECT_TRUE(second.robot() == before);
    TypeParam third{PusherParams{}};
    third = std::move(second);
    EXPECT_TRUE(third.robot() == before);
    EXPECT_EQ(third.translate(0.1, 0.0).stop, Stop::done);
}

TYPED_TEST(PusherBackend, RecordsThePathOnlyWhenAsked) {
    TypeParam backend{PusherParams{}};
    backend.reset({-1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {1.3, 0.0});
    backend.translate(0.1, 0.0);
    EXPECT_TRUE(backend.path().empty());
    backend.set_path_recording(true);
    backend.translate(0.1, 0.0);
    ASSERT_GE(backend.path().size(), 2u);
    EXPECT_NEAR(backend.path().front().x_m, -0.9, 0.0021);
    EXPECT_TRUE(backend.path().back() == backend.robot());
    backend.reset({-1.2, 0.0, 0.0}, {0.0, 0.0, 0.0}, {1.3, 0.0});
    EXPECT_EQ(backend.path().size(), 1u);
}

TYPED_TEST(PusherBackend, NothingAskedNothingDone) {
    TypeParam backend{PusherParams{}};
    backend.reset({-1.0, 0.0, 0.5}, {0.0, 0.0, 0.0}, {1.3, 0.0});
    const Pose before = backend.robot();
    EXPECT_EQ(backend.translate(0.0, 0.3).amount, 0.0);
    EXPECT_EQ(backend.rotate(0.0).amount, 0.0);
    EXPECT_TRUE(backend.robot() == before);
}

TYPED_TEST(PusherBackend, RefusesImpossibleInput) {
    PusherParams negative;
    negative.body.radius_m = -0.2;
    EXPECT_THROW(TypeParam{negative}, std::invalid_argument);
    TypeParam backend{PusherParams{}};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(backend.reset({nan, 0.0, 0.0}, {}, {1.3, 0.0}), std::invalid_argument);
    EXPECT_THROW(backend.reset({-1.0, 0.0, 0.0}, {0.0, nan, 0.0}, {1.3, 0.0}), std::invalid_argument);
    EXPECT_THROW(backend.reset({-1.0, 0.0, 0.0}, {}, {nan, 0.0}), std::invalid_argument);
    EXPECT_THROW(backend.reset({0.1, 0.0, 0.0}, {}, {1.3, 0.0}), std::invalid_argument);  // on the box
    EXPECT_THROW(backend.reset({2.4, 0.0, 0.0}, {}, {1.3, 0.0}), std::invalid_argument);  // in the wall
    EXPECT_THROW(backend.reset({0.0, 0.0, 0.0}, {2.4, 0.0, 0.0}, {1.3, 0.0}),
                 std::invalid_argument);  // box in the wall
    backend.reset({-1.0, 0.0, 0.0}, {}, {1.3, 0.0});
    const Pose before = backend.robot();
    EXPECT_THROW(backend.translate(nan, 0.0), std::invalid_argument);
    EXPECT_THROW(backend.translate(0.1, nan), std::invalid_argument);
    EXPECT_THROW(backend.rotate(nan), std::invalid_argument);
    EXPECT_TRUE(backend.robot() == before);
}
