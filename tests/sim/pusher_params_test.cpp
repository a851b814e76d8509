// SPDX-License-Identifier: MIT
#include <sspql/sim/pusher_params.hpp>

#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <gtest/gtest.h>

namespace sim = sspql::sim;

static_assert(std::is_aggregate_v<sim::PusherParams>);

namespace {

template <class Change>
std::string refusal(Change change) {
    sim::PusherParams params;
    change(params);
    try {
        params.validate();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST(PusherParams, DefaultsAreTheLearningStudy) {
    const sim::PusherParams params;
    EXPECT_NO_THROW(params.validate());
    EXPECT_EQ(params.body.radius_m, 0.20);
    EXPECT_EQ(params.box_side_m, 0.30);
    EXPECT_EQ(params.fence_radius_m, 1.3);
    EXPECT_EQ(params.guard_clearance_m, 0.06);
    EXPECT_TRUE(params.goal_place == (sim::Point{1.3, 0.0}));
}

TEST(PusherParams, RefusalsNameTheMemberAndTheValue) {
    EXPECT_EQ(refusal([](auto& p) { p.noise = -1.0; }), "noise must be finite and >= 0, got -1");
    EXPECT_EQ(refusal([](auto& p) { p.body.radius_m = 0.0; }), "robot radius_m must be finite and > 0, got 0");
    EXPECT_EQ(refusal([](auto& p) { p.box_place.x_m = 2.6; }), "box_place x_m must lie in [-2.5, 2.5], got 2.6");
    EXPECT_EQ(refusal([](auto& p) { p.velocity_iterations = 0; }), "velocity_iterations must be at least 1, got 0");
    EXPECT_NE(refusal([](auto& p) { p.goal_place = p.box_place; }).find("goal_place must differ"), std::string::npos);
}

TEST(PusherParams, EveryNumberIsChecked) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    double sim::PusherParams::*const numbers[] = {
        &sim::PusherParams::arena_half_side_m,    &sim::PusherParams::wall_friction,
        &sim::PusherParams::robot_mass_kg,        &sim::PusherParams::max_speed_m_per_s,
        &sim::PusherParams::max_turn_rad_per_s,   &sim::PusherParams::max_force_n,
        &sim::PusherParams::max_torque_nm,        &sim::PusherParams::box_side_m,
        &sim::PusherParams::box_mass_kg,          &sim::PusherParams::box_ground_friction,
        &sim::PusherParams::box_contact_friction, &sim::PusherParams::box_torque_arm,
        &sim::PusherParams::gravity_m_per_s2,     &sim::PusherParams::guard_clearance_m,
        &sim::PusherParams::fence_radius_m,       &sim::PusherParams::time_step_s,
        &sim::PusherParams::done_distance_m,      &sim::PusherParams::done_angle_rad,
        &sim::PusherParams::stall_speed_fraction, &sim::PusherParams::noise,
        &sim::PusherParams::distance_noise,       &sim::PusherParams::turn_noise,
        &sim::PusherParams::drift_noise_rad,      &sim::PusherParams::turn_start_radius_m,
        &sim::PusherParams::start_jitter_m,       &sim::PusherParams::start_jitter_rad};
    int i = 0;
    for (double sim::PusherParams::*const number : numbers) {
        EXPECT_NE(refusal([&](auto& p) { p.*number = nan; }), "accepted") << i;
        EXPECT_NE(refusal([&](auto& p) { p.*number = -0.01; }), "accepted") << i;
        ++i;
    }
    EXPECT_NE(refusal([&](auto& p) { p.guard_angles_rad[2] = nan; }), "accepted");
    EXPECT_NE(refusal([](auto& p) { p.guard_angles_rad[0] = 2.0; }), "accepted");
    EXPECT_NE(refusal([&](auto& p) { p.start_places[1].heading_rad = nan; }), "accepted");
    EXPECT_NE(refusal([](auto& p) { p.start_places[0].y_m = -3.0; }), "accepted");
    EXPECT_NE(refusal([](auto& p) { p.goal_place.y_m = 3.0; }), "accepted");
    EXPECT_NE(refusal([](auto& p) { p.position_iterations = 0; }), "accepted");
    EXPECT_NE(refusal([](auto& p) { p.stall_steps = 0; }), "accepted");
}
