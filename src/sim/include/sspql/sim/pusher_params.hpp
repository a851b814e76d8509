// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

#include <sspql/core/errors.hpp>
#include <sspql/sim/pose.hpp>
#include <sspql/sim/robot_body.hpp>

namespace sspql::sim {

/// Where an 'approach' episode starts: at the first of PusherParams::start_places, at either of the two, or anywhere
/// inside the fence, looking anywhere.
enum class Starts { one, two, anywhere };

/// Every number of the box pusher's world (section 4 of the paper gives only the actions and the 12 x 3 x 12 states;
/// the others are ours, tuned so that the task is well-posed). The defaults are those of the learning study: a circular
/// robot that knows its pose, in metres, kilograms, seconds, radians. Plain data: change members, then hand it over;
/// backends and tasks call `validate` and keep a copy.
struct PusherParams {
    // Arena: the square [-arena_half_side_m, arena_half_side_m]^2, frame of all poses.
    double arena_half_side_m = 2.5;  ///< half the length of a wall
    double wall_friction = 0.2;      ///< coefficient; Box2D mixes two as sqrt(a b)

    // Robot.
    RobotBody body{};                                ///< the outline
    double robot_mass_kg = 9.0;                      ///< of the robot
    double max_speed_m_per_s = 0.4;                  ///< of translations
    double max_turn_rad_per_s = from_degrees(60.0);  ///< of turns on the spot
    double max_force_n = 60.0;                       ///< of the drive, also while it brakes
    double max_torque_nm = 12.0;                     ///< of the drive, about the robot's centre

    // Box, a square whose friction with the floor is a force of up to box_ground_friction * mass * g.
    double box_side_m = 0.30;           ///< length of a side
    double box_mass_kg = 2.0;           ///< of the box
    double box_ground_friction = 0.5;   ///< coefficient with the floor
    double box_contact_friction = 0.3;  ///< coefficient at its sides
    double box_torque_arm = 0.765;      ///< mean friction arm of a square, in half sides: a torque of mu m g 0.765 h
    double gravity_m_per_s2 = 9.81;     ///< of the earth

    // Safety of a translation. The guard's sonars look forward (or to the rear when it drives backwards), from the
    // body's outline outward at these angles from the way it drives.
    bool guard = true;  ///< whether translations are guarded
    /// Where they look, from the way it drives.
    std::array<double, 3> guard_angles_rad{0.0, from_degrees(30.0), from_degrees(-30.0)};
    double guard_clearance_m = 0.06;  ///< stop where one of them reads this or less
    bool fence = true;                ///< whether translations keep within a circle around the box
    double fence_radius_m = 1.3;      ///< stop where the next bit would lead farther than this from the box's centre

    // Box2D.
    double time_step_s = 1.0 / 60.0;    ///< of one step of the simulation
    int velocity_iterations = 8;        ///< Box2D's, a time step
    int position_iterations = 3;        ///< Box2D's, a time step
    double done_distance_m = 0.002;     ///< a translation is done when less is left
    double done_angle_rad = 0.003;      ///< a rotation is done when less is left
    double stall_speed_fraction = 0.1;  ///< slower than this part of the full speed ...
    int stall_steps = 12;               ///< ... for so many steps: stalled, the action ends

    // Actuator noise, normal, per action; all deviations are multiplied by `noise`. 0 = exact.
    double noise = 1.0;                          ///< multiplies all deviations below
    double distance_noise = 0.05;                ///< of the distance
    double turn_noise = 0.05;                    ///< of the angle
    double drift_noise_rad = from_degrees(2.0);  ///< change of heading over one translation, whatever its length

    // Tasks.
    Point box_place{0.0, 0.0};    ///< the box's centre in the tasks, arena frame
    Point goal_place{1.3, 0.0};   ///< where the box is to go
    Starts starts = Starts::two;  ///< which places 'approach' starts at
    /// Of 'approach', before the jitter.
    std::array<Pose, 2> start_places{Pose{0.9, 0.5, pi}, Pose{0.2, -1.2, pi / 2.0}};
    double turn_start_radius_m = 0.85;  ///< 'turn' starts this far behind the box
    double start_jitter_m = 0.03;       ///< uniform, each coordinate, to both sides
    double start_jitter_rad = 0.03;     ///< uniform, to both sides

    /// Checks every member.
    /// \throws std::invalid_argument naming the first one out of range, with its value.
    void validate() const {
        require_positive("arena_half_side_m", arena_half_side_m);
        require_not_negative("wall_friction", wall_friction);
        body.validate();
        require_positive("robot_mass_kg", robot_mass_kg);
        require_positive("max_speed_m_per_s", max_speed_m_per_s);
        require_positive("max_turn_rad_per_s", max_turn_rad_per_s);
        require_positive("max_force_n", max_force_n);
        require_positive("max_torque_nm", max_torque_nm);
        require_positive("box_side_m", box_side_m);
        require_positive("box_mass_kg", box_mass_kg);
        require_not_negative("box_ground_friction", box_ground_friction);
        require_not_negative("box_contact_friction", box_contact_friction);
        require_not_negative("box_torque_arm", box_torque_arm);
        require_not_negative("gravity_m_per_s2", gravity_m_per_s2);
        for (const double angle : guard_angles_rad) require_in("guard angle (rad)", angle, -pi / 2.0, pi / 2.0);
        require_not_negative("guard_clearance_m", guard_clearance_m);
        require_positive("fence_radius_m", fence_radius_m);
        require_in("time_step_s", time_step_s, 1e-4, 0.1);
        if (velocity_iterations < 1) throw_invalid("velocity_iterations", "be at least 1", velocity_iterations);
        if (position_iterations < 1) throw_invalid("position_iterations", "be at least 1", position_iterations);
        require_positive("done_distance_m", done_distance_m);
        require_positive("done_angle_rad", done_angle_rad);
        require_in("stall_speed_fraction", stall_speed_fraction, 0.0, 1.0);
        if (stall_steps < 1) throw_invalid("stall_steps", "be at least 1", stall_steps);
        require_not_negative("noise", noise);
        require_not_negative("distance_noise", distance_noise);
        require_not_negative("turn_noise", turn_noise);
        require_not_negative("drift_noise_rad", drift_noise_rad);
        require_inside("box_place", box_place);
        require_inside("goal_place", goal_place);
        if (box_place == goal_place) throw_invalid("goal_place", "differ from box_place, x_m", goal_place.x_m);
        for (const Pose& start : start_places) {
            require_inside("start place", position(start));
            require_finite("start heading_rad", start.heading_rad);
        }
        require_positive("turn_start_radius_m", turn_start_radius_m);
        require_not_negative("start_jitter_m", start_jitter_m);
        require_not_negative("start_jitter_rad", start_jitter_rad);
    }

private:
    void require_inside(const char* name, const Point& p) const {
        const double most = arena_half_side_m;
        require_in((std::string(name) + " x_m").c_str(), p.x_m, -most, most);
        require_in((std::string(name) + " y_m").c_str(), p.y_m, -most, most);
    }
};

}  // namespace sspql::sim
