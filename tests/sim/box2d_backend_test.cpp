// SPDX-License-Identifier: MIT
// What only the Box2D backend can: push. backends_test.cpp has the rest.
#include <sspql/sim/box2d_backend.hpp>

#include <array>
#include <cmath>
#include <thread>
#include <type_traits>

#include <gtest/gtest.h>

#include <sspql/sim/geometry.hpp>

namespace sim = sspql::sim;
using sim::Pose;
using sim::PusherParams;
using sim::Stop;

namespace {

PusherParams unguarded() {
    PusherParams params;
    params.guard = false;
    params.fence = false;
    return params;
}

}  // namespace

TEST(Box2dBackend, PushesTheBoxAndLeavesItAtRest) {
    sim::Box2dBackend backend(unguarded());
    backend.reset({-0.6, 0.0, 0.0}, {}, {1.3, 0.0});
    const sim::Move move = backend.translate(0.55, 0.0);  // 0.25 to the box, 0.3 with it
    EXPECT_EQ(move.stop, Stop::done);
    EXPECT_NEAR(backend.box().x_m, 0.3, 0.02);
    EXPECT_NEAR(backend.box().y_m, 0.0, 0.02);
    const Pose pushed = backend.box();
    EXPECT_EQ(backend.translate(-0.3, 0.0).stop, Stop::done);
    EXPECT_NEAR(backend.box().x_m, pushed.x_m, 1e-3);  // it does not roll on and does not stick to the robot
    backend.rotate(1.0);
    EXPECT_NEAR(backend.box().x_m, pushed.x_m, 1e-3);
}

TEST(Box2dBackend, AnUntouchedBoxDoesNotMoveAtAll) {
    sim::Box2dBackend backend;
    const Pose box{0.1, 0.2, 0.3};
    backend.reset({-0.8, 0.0, 0.0}, box, {1.3, 0.0});
    const Pose before = backend.box();
    for (int i = 0; i < 12; ++i) {
        backend.translate(0.1, 0.0);
        backend.rotate(sim::from_degrees(30.0));
    }
    EXPECT_TRUE(backend.box() == before);
    EXPECT_NEAR(before.x_m, box.x_m, 1e-7);
    EXPECT_NEAR(before.heading_rad, box.heading_rad, 1e-7);
}

TEST(Box2dBackend, OffCentrePushTurnsTheBox) {
    sim::Box2dBackend backend(unguarded());
    backend.reset({-0.6, 0.1, 0.0}, {}, {1.3, 0.0});
    backend.translate(0.5, 0.0);
    EXPECT_GT(backend.box().x_m, 0.05);
    EXPECT_LT(backend.box().heading_rad, -0.05);  // pushed left of its centre: turns to the right
}

TEST(Box2dBackend, StallsAgainstAHeavyBoxAndReportsTheWayItWent) {
    PusherParams params = unguarded();
    params.box_mass_kg = 200.0;  // floor friction 981 N against a drive of 60 N
    sim::Box2dBackend backend(params);
    backend.reset({-0.6, 0.0, 0.0}, {}, {1.3, 0.0});
    backend.set_path_recording(true);
    const sim::Move move = backend.translate(0.5, 0.0);
    EXPECT_EQ(move.stop, Stop::stall);
    // 0.25 m at 0.4 m/s are 38 time steps, some more to get going and to settle, and 12 to know that it is stuck.
    EXPECT_LT(backend.path().size(), 70u);
    EXPECT_NEAR(move.amount, 0.25, 0.015);
    EXPECT_NEAR(backend.robot().x_m, -0.6 + move.amount, 1e-4);
    EXPECT_NEAR(backend.box().x_m, 0.0, 0.01);
}

TEST(Box2dBackend, ADriveTooWeakForTheFloorFrictionStalls) {
    PusherParams params = unguarded();
    params.max_force_n = 5.0;  // the box's floor friction is 9.8 N
    sim::Box2dBackend backend(params);
    backend.reset({-0.45, 0.0, 0.0}, {}, {1.3, 0.0});
    EXPECT_EQ(backend.translate(0.5, 0.0).stop, Stop::stall);
    EXPECT_LT(backend.box().x_m, 0.1);
}

TEST(Box2dBackend, TheFenceMovesWithTheBox) {
    PusherParams params;
    params.guard = false;
    sim::Box2dBackend backend(params);
    backend.reset({-0.6, 0.0, 0.0}, {}, {1.3, 0.0});
    backend.translate(0.85, 0.0);
    const double box_x = backend.box().x_m;
    EXPECT_GT(box_x, 0.5);
    for (int i = 0; i < 10; ++i) backend.translate(-0.3, 0.0);
    EXPECT_NEAR(backend.robot().x_m, box_x - 1.3, 0.003);
}

TEST(Box2dBackend, ResetPutsAPushedBoxBack) {
    sim::Box2dBackend backend(unguarded());
    backend.reset({-0.6, 0.1, 0.0}, {}, {1.3, 0.0});
    backend.translate(0.5, 0.0);
    backend.reset({-0.6, 0.1, 0.0}, {}, {1.3, 0.0});
    EXPECT_TRUE(backend.box() == Pose{});
    EXPECT_NEAR(backend.robot().x_m, -0.6, 1e-7);
}

TEST(Box2dBackendThreads, OneWorldEachGivesTheSameBits) {
    static_assert(!std::is_copy_constructible_v<sim::Box2dBackend>);
    std::array<Pose, 4> boxes{};
    std::array<std::thread, 4> threads;
    for (std::size_t i = 0; i < threads.size(); ++i) {
        threads[i] = std::thread([&boxes, i] {
            sim::Box2dBackend backend(unguarded());
            backend.reset({-0.6, 0.05, 0.0}, {}, {1.3, 0.0});
            for (int k = 0; k < 20; ++k) backend.translate(k % 2 == 0 ? 0.4 : -0.3, 0.02);
            boxes[i] = backend.box();
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_GT(boxes[0].x_m, 0.1);
    for (const Pose& box : boxes) EXPECT_TRUE(box == boxes[0]);
}
