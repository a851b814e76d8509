// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <box2d/box2d.h>

#include <sspql/core/errors.hpp>
#include <sspql/sim/backend.hpp>
#include <sspql/sim/geometry.hpp>
#include <sspql/sim/guard.hpp>
#include <sspql/sim/pose.hpp>
#include <sspql/sim/pusher_params.hpp>

namespace sspql::sim {

/// PusherBackend on Box2D 2.4, seen from above (no gravity): a robot driven by a velocity servo, a box that the robot
/// may push against the friction of the floor, walls. The only header of sspql that names Box2D.
///
/// The servo is a limited impulse per time step towards the full speed along the heading, or towards the speed from
/// which it can still brake in time (a = force / mass); the lateral velocity is part of what it cancels, the heading is
/// held on the course. A move ends when less than `done_distance_m` or `done_angle_rad` is left, or by guard, fence or
/// stall; then both bodies' velocities are set to zero. Guard and fence look once per time step (6.7 mm of way at the
/// defaults).
///
/// A move costs some 30 time steps of about 1 us. `reset` builds a new world (about 4 us): contacts, joint impulses
/// and the order of Box2D's lists do not survive, so a used object and a new one give the same bits. Movable, not
/// copyable. One object per thread; several objects in several threads are fine (Box2D's only shared state is a table
/// of functions, filled before the first world here, and profiling counters that nobody reads).
class Box2dBackend {
public:
    /// Copies the numbers; reset() says where things are. \throws std::invalid_argument for parameters out of range.
    explicit Box2dBackend(const PusherParams& params = {}) : params_(detail::checked(params)), guard_(params_) {
        fill_contact_table();
        build({-1.0, 0.0, 0.0}, {}, {1.3, 0.0});
    }

    /// A new world at rest.
    /// \throws std::invalid_argument unless all is finite, robot and box lie inside the arena and do not overlap.
    void reset(const Pose& robot, const Pose& box, const Point& goal) {
        detail::require_start(params_, robot, box, goal);
        build(robot, box, goal);
        path_.clear();
        record();
    }

    /// Drives, turning evenly by `drift_rad` meanwhile. \throws std::invalid_argument unless both are finite.
    Move translate(double distance_m, double drift_rad) {
        require_finite("distance_m", distance_m);
        require_finite("drift_rad", drift_rad);
        const double wanted = std::fabs(distance_m);
        if (wanted == 0.0) return {};
        const bool forward = distance_m > 0.0;
        const double dt = params_.time_step_s;
        const double brake = params_.max_force_n / params_.robot_mass_kg;
        const double start_angle = robot_body_->GetAngle();
        const double stall_speed = params_.stall_speed_fraction * params_.max_speed_m_per_s;
        const long most_steps = step_limit(wanted / params_.max_speed_m_per_s);
        double gone = 0.0;
        int slow_steps = 0;
        Stop stop = Stop::stall;
        for (long step = 0; step < most_steps; ++step) {
            const double angle = robot_body_->GetAngle();
            const Direction heading = direction(angle);
            const Direction travel = forward ? heading : reversed(heading);
            const Point here = point_of(*robot_body_);
            double rest = wanted - gone;
            if (rest < params_.done_distance_m) {
                stop = Stop::done;
                break;
            }
            if (params_.guard && is_guarded(here, heading, forward)) {
                stop = Stop::guard;
                break;
            }
            if (params_.fence) {
                rest = distance_inside_fence(here, travel, rest, point_of(*box_body_), params_.fence_radius_m);
                if (rest < params_.done_distance_m) {
                    stop = Stop::fence;
                    break;
                }
            }
            const double speed = servo_speed(rest, params_.max_speed_m_per_s, brake, dt);
            const double course = start_angle + drift_rad * std::min((gone + speed * dt) / wanted, 1.0);
            drive(travel, speed, (course - angle) / dt);
            world_->Step(static_cast<float>(dt), params_.velocity_iterations, params_.position_iterations);
            const Point there = point_of(*robot_body_);
            const double progress = (there.x_m - here.x_m) * travel.x + (there.y_m - here.y_m) * travel.y;
            gone += progress;
            record();
            slow_steps = progress < stall_speed * dt ? slow_steps + 1 : 0;
            if (slow_steps >= params_.stall_steps) break;
        }
        come_to_rest();
        return {forward ? gone : -gone, stop};
    }

    /// Turns on the spot, > 0 to the left. \throws std::invalid_argument unless the angle is finite.
    Move rotate(double angle_rad) {
        require_finite("angle_rad", angle_rad);
        const double dt = params_.time_step_s;
        const double brake = params_.max_torque_nm / static_cast<double>(robot_body_->GetInertia());
        const double start = robot_body_->GetAngle();
        const double stall_speed = params_.stall_speed_fraction * params_.max_turn_rad_per_s;
        const long most_steps = step_limit(std::fabs(angle_rad) / params_.max_turn_rad_per_s);
        const double side = angle_rad < 0.0 ? -1.0 : 1.0;
        double gone = 0.0;
        int slow_steps = 0;
        Stop stop = Stop::stall;
        for (long step = 0; step < most_steps; ++step) {
            const double rest = std::fabs(angle_rad) - gone;
            if (rest < params_.done_angle_rad) {
                stop = Stop::done;
                break;
            }
            drive({}, 0.0, side * servo_speed(rest, params_.max_turn_rad_per_s, brake, dt));
            world_->Step(static_cast<float>(dt), params_.velocity_iterations, params_.position_iterations);
            const double now = side * (static_cast<double>(robot_body_->GetAngle()) - start);
            slow_steps = now - gone < stall_speed * dt ? slow_steps + 1 : 0;
            gone = now;
            record();
            if (slow_steps >= params_.stall_steps) break;
        }
        come_to_rest();
        return {side * gone, stop};
    }

    /// Where the robot is, arena frame, heading in (-pi, pi].
    [[nodiscard]] Pose robot() const noexcept { return pose_of(*robot_body_); }
    /// Where the box is, arena frame, heading in (-pi, pi].
    [[nodiscard]] Pose box() const noexcept { return pose_of(*box_body_); }
    /// Where the box is to go, as given to reset.
    [[nodiscard]] const Point& goal() const noexcept { return goal_; }
    /// As given, but for the guard's switch.
    [[nodiscard]] const PusherParams& params() const noexcept { return params_; }

    /// Switches the guard on or off from the next move on: pushing means touching.
    void set_guard(bool on) noexcept { params_.guard = on; }

    /// Whether `path` grows: from now on, by the robot's pose after every time step.
    void set_path_recording(bool on) {
        recording_ = on;
        path_.clear();
        record();
    }

    /// The recorded poses, the first one from reset (or from the switching on).
    [[nodiscard]] const std::vector<Pose>& path() const noexcept { return path_; }

private:
    [[nodiscard]] static Point point_of(const b2Body& body) noexcept {
        const b2Vec2& p = body.GetPosition();
        return {static_cast<double>(p.x), static_cast<double>(p.y)};
    }

    [[nodiscard]] static Pose pose_of(const b2Body& body) noexcept {
        const Point p = point_of(body);
        return {p.x_m, p.y_m, wrap_angle(static_cast<double>(body.GetAngle()))};
    }

    [[nodiscard]] static b2Vec2 vector(double x, double y) noexcept {
        return {static_cast<float>(x), static_cast<float>(y)};
    }

    /// The greatest speed v for one more time step after which one can still brake in time: v dt + v^2 / (2 brake) =
    /// rest. (For dt -> 0 this is sqrt(2 brake rest), which overshoots by up to a millimetre at 60 steps a second.)
    [[nodiscard]] static double servo_speed(double rest, double full, double brake, double dt) noexcept {
        const double lost = brake * dt;
        return std::min(full, std::sqrt(lost * lost + 2.0 * brake * rest) - lost);
    }

    /// A move that takes 10 times its time at full speed and a second more has stalled, however it wriggles.
    [[nodiscard]] long step_limit(double seconds) const noexcept {
        return static_cast<long>(std::min((10.0 * seconds + 1.0) / params_.time_step_s, 1e6)) + params_.stall_steps;
    }

    /// Whether a sonar reads too little. The rays are cast only where the body's gap makes that possible.
    [[nodiscard]] bool is_guarded(const Point& here, const Direction& heading, bool forward) const noexcept {
        const double clearance = params_.guard_clearance_m;
        const bool box_near = distance_m(here, point_of(*box_body_)) <= reach_m_ + clearance;
        if (!box_near && circle_wall_gap(here, reach_m(params_.body), params_.arena_half_side_m) > clearance) {
            return false;
        }
        const Square square = square_at(pose_of(*box_body_), params_.box_side_m);
        return guard_.reading_m(here, heading, forward, square) <= clearance;
    }

    /// One time step's impulses towards `speed` along `way` and `turn_rate`, within force and torque.
    void drive(const Direction& way, double speed, double turn_rate) noexcept {
        const double dt = params_.time_step_s;
        const b2Vec2& velocity = robot_body_->GetLinearVelocity();
        double push_x = params_.robot_mass_kg * (speed * way.x - static_cast<double>(velocity.x));
        double push_y = params_.robot_mass_kg * (speed * way.y - static_cast<double>(velocity.y));
        const double push = std::sqrt(push_x * push_x + push_y * push_y);
        const double most_push = params_.max_force_n * dt;
        if (push > most_push) {
            push_x *= most_push / push;
            push_y *= most_push / push;
        }
        robot_body_->ApplyLinearImpulseToCenter(vector(push_x, push_y), true);
        const double rate = std::clamp(turn_rate, -params_.max_turn_rad_per_s, params_.max_turn_rad_per_s);
        const double twist = static_cast<double>(robot_body_->GetInertia()) *
                             (rate - static_cast<double>(robot_body_->GetAngularVelocity()));
        const double most_twist = params_.max_torque_nm * dt;
        robot_body_->ApplyAngularImpulse(static_cast<float>(std::clamp(twist, -most_twist, most_twist)), true);
    }

    /// Both velocities zero. The box sleeps until the robot touches it: asleep it costs nothing.
    void come_to_rest() noexcept {
        robot_body_->SetLinearVelocity({0.0f, 0.0f});
        robot_body_->SetAngularVelocity(0.0f);
        box_body_->SetAwake(false);
    }

    void record() {
        if (recording_) path_.push_back(robot());
    }

    void build(const Pose& robot, const Pose& box, const Point& goal) {
        world_ = std::make_unique<b2World>(b2Vec2(0.0f, 0.0f));
        world_->SetAllowSleeping(false);
        world_->SetContinuousPhysics(false);
        b2Body* ground = add_walls();
        robot_body_ = add_robot(robot);
        box_body_ = add_box(box, *ground);
        reach_m_ = reach_m(params_.body) + params_.box_side_m * 0.7072;
        goal_ = goal;
        come_to_rest();
    }

    /// One closed chain; clockwise, so that the solid sides look inward.
    b2Body* add_walls() {
        b2BodyDef at_rest;
        b2Body* ground = world_->CreateBody(&at_rest);
        const auto h = static_cast<float>(params_.arena_half_side_m);
        const b2Vec2 corners[4] = {{-h, -h}, {-h, h}, {h, h}, {h, -h}};
        b2ChainShape walls;
        walls.CreateLoop(corners, 4);
        b2FixtureDef fixture;
        fixture.shape = &walls;
        fixture.friction = static_cast<float>(params_.wall_friction);
        ground->CreateFixture(&fixture);
        return ground;
    }

    b2Body* add_body(const Pose& pose) {
        b2BodyDef movable;
        movable.type = b2_dynamicBody;
        movable.position = vector(pose.x_m, pose.y_m);
        movable.angle = static_cast<float>(wrap_angle(pose.heading_rad));
        return world_->CreateBody(&movable);
    }

    b2Body* add_robot(const Pose& pose) {
        b2Body* body = add_body(pose);
        const RobotBody& outline = params_.body;
        b2CircleShape circle;
        circle.m_radius = static_cast<float>(outline.radius_m);
        b2PolygonShape rectangle;
        b2FixtureDef fixture;
        double area = pi * outline.radius_m * outline.radius_m;
        fixture.shape = &circle;
        if (outline.shape == BodyShape::rectangle) {
            const double skin = static_cast<double>(b2_polygonRadius);  // Box2D adds it around every polygon
            const double half_length = std::max(outline.length_m / 2.0 - skin, skin);
            const double half_width = std::max(outline.width_m / 2.0 - skin, skin);
            rectangle.SetAsBox(static_cast<float>(half_length), static_cast<float>(half_width));
            area = 4.0 * half_length * half_width;
            fixture.shape = &rectangle;
        }
        fixture.density = static_cast<float>(params_.robot_mass_kg / area);
        fixture.friction = static_cast<float>(params_.box_contact_friction);
        body->CreateFixture(&fixture);
        return body;
    }

    b2Body* add_box(const Pose& pose, b2Body& ground) {
        b2Body* body = add_body(pose);
        const double half_side = params_.box_side_m / 2.0;
        b2PolygonShape square;
        square.SetAsBox(static_cast<float>(half_side), static_cast<float>(half_side));
        b2FixtureDef fixture;
        fixture.shape = &square;
        fixture.density = static_cast<float>(params_.box_mass_kg / (params_.box_side_m * params_.box_side_m));
        fixture.friction = static_cast<float>(params_.box_contact_friction);
        body->CreateFixture(&fixture);
        const double friction = params_.box_ground_friction * params_.box_mass_kg * params_.gravity_m_per_s2;
        b2FrictionJointDef floor;
        floor.Initialize(&ground, body, body->GetPosition());
        floor.maxForce = static_cast<float>(friction);
        floor.maxTorque = static_cast<float>(friction * params_.box_torque_arm * half_side);
        floor.collideConnected = true;
        world_->CreateJoint(&floor);
        return body;
    }

    /// Box2D fills its table of contact functions at the first contact, unguarded: let one thread do it.
    static void fill_contact_table() {
        static const bool filled = [] {
            b2World world(b2Vec2(0.0f, 0.0f));
            b2CircleShape circle;
            circle.m_radius = 1.0f;
            for (int i = 0; i < 2; ++i) {
                b2BodyDef movable;
                movable.type = b2_dynamicBody;
                world.CreateBody(&movable)->CreateFixture(&circle, 1.0f);
            }
            world.Step(0.01f, 1, 1);
            return true;
        }();
        static_cast<void>(filled);
    }

    PusherParams params_;
    Guard guard_;
    std::unique_ptr<b2World> world_;
    b2Body* robot_body_ = nullptr;  // owned by the world
    b2Body* box_body_ = nullptr;
    double reach_m_ = 0.0;  // from the robot's to the box's centre when they can just touch
    Point goal_{};
    bool recording_ = false;
    std::vector<Pose> path_;
};

static_assert(is_pusher_backend_v<Box2dBackend>);

}  // namespace sspql::sim
