// SPDX-License-Identifier: MIT
// What only the kinematic backend promises; backends_test.cpp has the rest.
#include <sspql/sim/kinematic_backend.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>

namespace sim = sspql::sim;
using sim::Pose;
using sim::PusherParams;
using sim::Stop;

TEST(KinematicBackend, AmountsAreExactInFreeSpace) {
    sim::KinematicBackend backend;
    backend.reset({-1.0, 0.0, 0.0}, {}, {1.3, 0.0});
    EXPECT_EQ(backend.translate(0.3, 0.0).amount, 0.3);
    EXPECT_EQ(backend.robot().x_m, -1.0 + 0.3);
    EXPECT_EQ(backend.rotate(0.25).amount, 0.25);
    EXPECT_EQ(backend.robot().heading_rad, 0.25);
    EXPECT_EQ(backend.translate(-0.2, 0.0).amount, -0.2);
    EXPECT_NEAR(backend.robot().y_m, -0.2 * std::sin(0.25), 1e-15);
}

TEST(KinematicBackend, FenceIsExact) {
    sim::KinematicBackend backend;
    backend.reset({-1.0, 0.6, sim::pi / 2.0}, {}, {1.3, 0.0});
    const sim::Move move = backend.translate(0.3, 0.0);
    EXPECT_EQ(move.stop, Stop::fence);
    EXPECT_NEAR(sim::distance_m(sim::position(backend.robot()), {}), 1.3, 1e-12);
}

TEST(KinematicBackend, TheBoxIsAWallWithoutTheGuard) {
    PusherParams params;
    params.guard = false;
    sim::KinematicBackend backend(params);
    backend.reset({-0.6, 0.0, 0.0}, {}, {1.3, 0.0});
    const sim::Move move = backend.translate(0.5, 0.0);  // gap 0.25
    EXPECT_EQ(move.stop, Stop::contact);
    EXPECT_NEAR(move.amount, 0.25, 0.002);
    EXPECT_LE(move.amount, 0.25);
    EXPECT_EQ(backend.translate(0.1, 0.0).amount, 0.0);
    EXPECT_EQ(backend.translate(-0.1, 0.0).stop, Stop::done);
    EXPECT_TRUE(backend.box() == Pose{});
}

TEST(KinematicBackend, AStoppedDriftIsInProportion) {
    PusherParams params;
    params.guard = false;
    sim::KinematicBackend backend(params);
    backend.reset({-0.6, 0.0, 0.0}, {}, {1.3, 0.0});
    const sim::Move move = backend.translate(0.5, 0.1);
    EXPECT_NEAR(backend.robot().heading_rad, 0.1 * move.amount / 0.5, 1e-12);
}

TEST(KinematicBackend, NeverOverlapsAnythingAndKeepsTheFence) {
    for (const bool guard : {true, false}) {
        PusherParams params;
        params.guard = guard;
        sim::KinematicBackend backend(params);
        const Pose box{0.1, -0.2, 0.7};
        const sim::Square square = sim::square_at(box, params.box_side_m);
        backend.reset({-0.6, 0.0, 0.0}, box, {1.3, 0.0});
        sspql::Random random(5);
        int touches = 0;
        for (int i = 0; i < 5000; ++i) {
            const double amount = random.uniform(-0.5, 0.5);
            const double drift = random.uniform(-0.2, 0.2);
            if (random.chance(0.3)) backend.rotate(4.0 * amount);
            if (backend.translate(amount, drift).stop == Stop::contact) ++touches;
            const Pose& robot = backend.robot();
            ASSERT_GE(sim::box_gap_m(params.body, robot, square), 0.0) << i;
            ASSERT_GE(sim::wall_gap_m(params.body, robot, params.arena_half_side_m), 0.0) << i;
            ASSERT_LE(sim::distance_m(sim::position(robot), sim::position(box)), params.fence_radius_m + 1e-9) << i;
        }
        EXPECT_GT(touches, guard ? 0 : 100);  // with the guard: corners between its rays
    }
}
