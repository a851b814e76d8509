// SPDX-License-Identifier: MIT
// Both backends with the mission's robot: a rectangle, guard on and off, curves.
#include <cmath>
#include <cstdint>
#include <cstring>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/sim/box2d_backend.hpp>
#include <sspql/sim/kinematic_backend.hpp>
#include <sspql/sim/pusher_tasks.hpp>

namespace sim = sspql::sim;
using sim::Pose;
using sim::PusherParams;
using sim::Stop;

namespace {

PusherParams rectangular() {
    PusherParams params;
    params.body.shape = sim::BodyShape::rectangle;
    params.fence = false;
    return params;
}

template <class Backend>
class RectangularPusher : public testing::Test {};

using Backends = testing::Types<sim::KinematicBackend, sim::Box2dBackend>;
TYPED_TEST_SUITE(RectangularPusher, Backends, );

/// FNV-1a over the bits of numbers.
class Hash {
public:
    void add(const Pose& pose) {
        for (const double value : {pose.x_m, pose.y_m, pose.heading_rad}) {
            std::uint64_t bits = 0;
            std::memcpy(&bits, &value, sizeof bits);
            for (int byte = 0; byte < 8; ++byte) {
                value_ = (value_ ^ ((bits >> (8 * byte)) & 0xFFu)) * 0x100000001B3ull;
            }
        }
    }

    [[nodiscard]] std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0xCBF29CE484222325ull;
};

/// All transforms on the way: the robot's at every time step (or move), the box's after every move. The guard goes on
/// and off, so that the box is pushed, turned and left again.
template <class Backend>
std::uint64_t hash_of(Backend& backend, std::uint64_t seed) {
    sspql::Random random(seed);
    Hash hash;
    backend.set_guard(true);
    backend.set_path_recording(true);
    backend.reset({-0.6, 0.1, 0.0}, {0.0, 0.0, 0.2}, {1.3, 0.0});
    for (int i = 0; i < 80; ++i) {
        backend.set_guard(i % 10 < 3);
        const double amount = random.uniform(-0.1, 0.3);
        const double bend = random.uniform(-0.3, 0.3);
        if (random.chance(0.3)) {
            backend.rotate(3.0 * bend);
        } else {
            backend.translate(amount, bend);
        }
        hash.add(backend.box());
    }
    for (const Pose& pose : backend.path()) hash.add(pose);
    return hash.value();
}

}  // namespace

TYPED_TEST(RectangularPusher, SameSeedSameTransformsReusedOrRebuilt) {
    TypeParam reused{rectangular()};
    std::uint64_t first = 0;
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
        TypeParam rebuilt{rectangular()};
        const std::uint64_t hash = hash_of(reused, seed);
        EXPECT_EQ(hash, hash_of(rebuilt, seed)) << seed;
        EXPECT_EQ(hash, hash_of(reused, seed)) << seed;
        EXPECT_NE(hash, first) << seed;
        first = hash;
    }
}

TYPED_TEST(RectangularPusher, TheGuardStopsTheFrontAndCanBeSwitchedOff) {
    TypeParam backend{rectangular()};
    backend.reset({-0.6, 0.0, 0.0}, {0.0, 0.0, 0.0}, {1.3, 0.0});
    const sim::Move guarded = backend.translate(0.4, 0.0);  // gap 0.6 - 0.2 - 0.15 = 0.25
    EXPECT_EQ(guarded.stop, Stop::guard);
    EXPECT_NEAR(guarded.amount, 0.19, 0.008);
    backend.set_guard(false);
    const double before = backend.robot().x_m;
    backend.translate(0.1, 0.0);
    EXPECT_GT(backend.robot().x_m, before + 0.045);  // up to the box at least
    backend.set_guard(true);
    EXPECT_EQ(backend.translate(0.1, 0.0).amount, 0.0);
}

TYPED_TEST(RectangularPusher, ACurveIsACommand) {
    PusherParams params = rectangular();
    params.noise = 0.0;
    TypeParam backend{params};
    sim::NoisyActuator actuator(params);
    actuator.reset(1);
    backend.reset({-1.5, -1.0, 0.0}, {0.0, 0.0, 0.0}, {1.3, 0.0});
    actuator.execute(backend, {sim::Motion::translate, 0.3, 0.3});
    EXPECT_NEAR(backend.robot().heading_rad, 0.3, 0.02);
    EXPECT_NEAR(backend.robot().y_m, -1.0 + 0.3 * 0.15, 0.004);
}

TEST(RectangularPusher, Box2dPushesStraightWithAFlatFront) {
    PusherParams params = rectangular();
    params.guard = false;
    sim::Box2dBackend backend(params);
    backend.reset({-0.45, 0.03, 0.0}, {0.0, 0.0, 0.2}, {1.3, 0.0});
    for (int i = 0; i < 10; ++i) backend.translate(0.06, -backend.robot().heading_rad);
    EXPECT_NEAR(backend.box().x_m, backend.robot().x_m + 0.2 + 0.15, 0.03);
    EXPECT_GT(backend.box().x_m, 0.4);
    EXPECT_LT(std::fabs(backend.box().y_m), 0.06);
    // The box has turned until one of its sides lies against the front.
    const double turn = backend.box().heading_rad - backend.robot().heading_rad;
    EXPECT_NEAR(std::remainder(turn, sim::pi / 2.0), 0.0, 0.1);
}

TEST(RectangularPusher, KinematicTurnsEndWhereACornerTouches) {
    sim::KinematicBackend backend(rectangular());
    // Beside a wall, along it: 0.02 m of room at its side; the corner needs more to swing through.
    backend.reset({0.0, 2.5 - 0.172 - 0.02, 0.0}, {-1.5, 0.0, 0.0}, {1.3, 0.0});
    const sim::Move blocked = backend.rotate(1.0);
    EXPECT_EQ(blocked.stop, Stop::contact);
    // 0.2 sin a + 0.172 cos a = 0.192 at a = 0.1023.
    EXPECT_NEAR(blocked.amount, 0.1023, 0.01);
    EXPECT_NEAR(backend.rotate(-blocked.amount).amount, -blocked.amount, 1e-12);
    backend.reset({0.0, 2.0, 0.0}, {-1.5, 0.0, 0.0}, {1.3, 0.0});
    EXPECT_EQ(backend.rotate(1.0).stop, Stop::done);
}

TYPED_TEST(RectangularPusher, ApproachMayStartAnywhereInsideTheFence) {
    PusherParams params = rectangular();
    params.starts = sim::Starts::anywhere;
    sim::ApproachTask<TypeParam> task(params);
    bool sectors[12] = {};
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const sim::PusherObservation start = task.reset(seed);
        EXPECT_LE(sim::distance_m(sim::position(start.robot), {}), params.fence_radius_m + 1e-6);
        EXPECT_GT(sim::box_gap_m(params.body, start.robot, sim::square_at(start.box, 0.3)), 0.05);
        const Pose in_frame = sim::to_box_frame(start);
        EXPECT_FALSE(sim::in_push_sector(in_frame));
        sectors[sim::box_cell(in_frame).sector] = true;
    }
    for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(sectors[i], i != sim::push_sector) << i;
}
