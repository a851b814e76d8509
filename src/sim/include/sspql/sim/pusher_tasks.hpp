// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include <sspql/core/errors.hpp>
#include <sspql/core/random.hpp>
#include <sspql/env/environment.hpp>
#include <sspql/sim/backend.hpp>
#include <sspql/sim/box_frame.hpp>
#include <sspql/sim/pose.hpp>
#include <sspql/sim/pusher_params.hpp>
#include <sspql/sim/pusher_spaces.hpp>

/// \file
/// The two subtasks the paper learns (section 4.1) as Environments over any PusherBackend. Neither has a time limit of
/// its own (sspql::TimeLimit cuts, at 2000 steps in the study). Reward 1 and `terminated` at the goal, else reward 0.

namespace sspql::sim {

/// Adds the actuators' errors to commands. Every call takes the same two normal draws from RandomStream::noise,
/// whatever the command and whatever came of the last one, so that runs with different outcomes stay comparable.
class NoisyActuator {
public:
    /// The errors of these parameters, `noise` times each deviation. Precondition: valid parameters.
    explicit NoisyActuator(const PusherParams& params) noexcept
        : distance_noise_(params.noise * params.distance_noise),
          turn_noise_(params.noise * params.turn_noise),
          drift_noise_rad_(params.noise * params.drift_noise_rad) {}

    /// Begins the sequence of errors of this seed.
    void reset(std::uint64_t seed) noexcept { random_ = Random(seed, RandomStream::noise); }

    /// Executes the command on the backend with its errors: an amount of (1 + e) times what was asked, never the other
    /// way round, and on a translation a drift of the heading beside the curve.
    /// \throws std::invalid_argument for an amount or a curve that is not finite.
    template <class Backend>
    Move execute(Backend& backend, const PusherCommand& command) {
        require_finite("command amount", command.amount);
        require_finite("command curve_rad", command.curve_rad);
        const double amount_error = random_.normal();
        const double drift_error = random_.normal();
        if (command.motion == Motion::rotate) {
            return backend.rotate(command.amount * std::max(0.0, 1.0 + turn_noise_ * amount_error));
        }
        return backend.translate(command.amount * std::max(0.0, 1.0 + distance_noise_ * amount_error),
                                 command.curve_rad + drift_noise_rad_ * drift_error);
    }

private:
    double distance_noise_;
    double turn_noise_;
    double drift_noise_rad_;
    Random random_{0, RandomStream::noise};
};

/// What both tasks share: the world, the actuator, the observation, the last move.
/// \throws std::invalid_argument (constructor) for parameters out of range.
template <class Backend>
class PusherTask {
    static_assert(is_pusher_backend_v<Backend>, "sspql: this is no PusherBackend, see sspql/sim/backend.hpp");

public:
    /// What is seen now: the true poses.
    [[nodiscard]] PusherObservation observe() const { return {backend_.robot(), backend_.box(), backend_.goal()}; }

    /// How the last step's move went: how far, and what stopped it.
    [[nodiscard]] const Move& last_move() const noexcept { return last_move_; }

    /// The world, to look at it or to disturb it.
    [[nodiscard]] Backend& backend() noexcept { return backend_; }
    /// The world, to look at it.
    [[nodiscard]] const Backend& backend() const noexcept { return backend_; }
    /// The numbers of the world.
    [[nodiscard]] const PusherParams& params() const noexcept { return backend_.params(); }

protected:
    /// A start is redrawn at most this often before the parameters count as impossible.
    static constexpr int most_redraws = 1000;

    explicit PusherTask(const PusherParams& params) : backend_(params), actuator_(params) {}

    void move(const PusherCommand& command) { last_move_ = actuator_.execute(backend_, command); }

    void place(const Pose& robot) {
        const PusherParams& p = params();
        backend_.reset(robot, Pose{p.box_place.x_m, p.box_place.y_m, 0.0}, p.goal_place);
        last_move_ = {};
    }

    void reset_noise(std::uint64_t seed) noexcept { actuator_.reset(seed); }

    /// The pose with the start's jitter: three draws.
    [[nodiscard]] Pose jittered(const Pose& pose, Random& random) const noexcept {
        const PusherParams& p = params();
        Pose result = pose;
        result.x_m += random.uniform(-p.start_jitter_m, p.start_jitter_m);
        result.y_m += random.uniform(-p.start_jitter_m, p.start_jitter_m);
        result.heading_rad = wrap_angle(result.heading_rad + random.uniform(-p.start_jitter_rad, p.start_jitter_rad));
        return result;
    }

private:
    Backend backend_;
    NoisyActuator actuator_;
    Move last_move_{};
};

/// 'approach': drive around the box into sector A, behind it as seen from the goal; any ring, any heading ('turn' then
/// aligns the robot). Environment for ApproachState and ApproachActions. Starts where params.starts says.
///
/// `reset(seed)` fixes all chance of the episode: starts from RandomStream::environment, noise from
/// RandomStream::noise. Deviation: section 4.2 rewards "A and heading 0"; with that reading 'turn' would have nothing
/// left to learn.
template <class Backend>
class ApproachTask : public PusherTask<Backend> {
public:
    /// Takes a copy.
    /// \throws std::invalid_argument for parameters out of range (a negative noise, a box outside the arena ...).
    explicit ApproachTask(const PusherParams& params = {}) : PusherTask<Backend>(params) {}

    /// Starts an episode.
    /// \throws std::invalid_argument if the start places overlap the box or lie in the goal sector, jitter included.
    PusherObservation reset(std::uint64_t seed) {
        const PusherParams& p = this->params();
        Random random(seed, RandomStream::environment);
        this->reset_noise(seed);
        for (int i = 0; i < this->most_redraws; ++i) {
            if (p.starts == Starts::anywhere) {
                const Pose start = anywhere(random);
                if (!is_free(start)) continue;
                this->place(start);
            } else {
                const std::size_t place = random.below(p.start_places.size());
                this->place(this->jittered(p.start_places[p.starts == Starts::one ? 0 : place], random));
            }
            const PusherObservation observation = this->observe();
            if (!in_push_sector(to_box_frame(observation))) return observation;
        }
        throw std::invalid_argument("start places must not all lie in the goal sector behind the box");
    }

    /// Carries the command out, with its errors. \throws std::invalid_argument for an amount that is not finite.
    Step<PusherObservation> step(const PusherCommand& command) {
        this->move(command);
        const PusherObservation observation = this->observe();
        const bool arrived = in_push_sector(to_box_frame(observation));
        return {observation, arrived ? 1.0 : 0.0, arrived, false};
    }

private:
    /// Uniform on the square about the fence, looking anywhere: three draws.
    [[nodiscard]] Pose anywhere(Random& random) const noexcept {
        const PusherParams& p = this->params();
        Pose pose{p.box_place.x_m, p.box_place.y_m, 0.0};
        pose.x_m += random.uniform(-p.fence_radius_m, p.fence_radius_m);
        pose.y_m += random.uniform(-p.fence_radius_m, p.fence_radius_m);
        pose.heading_rad = random.uniform(-pi, pi);
        return pose;
    }

    /// Whether the robot stands inside the fence, clear of box and walls.
    [[nodiscard]] bool is_free(const Pose& pose) const noexcept {
        const PusherParams& p = this->params();
        const Square box = square_at({p.box_place.x_m, p.box_place.y_m, 0.0}, p.box_side_m);
        return distance_m(position(pose), p.box_place) <= p.fence_radius_m &&
               box_gap_m(p.body, pose, box) > p.guard_clearance_m &&
               wall_gap_m(p.body, pose, p.arena_half_side_m) > p.guard_clearance_m;
    }
};

/// 'turn': from sector A, looking anywhere but along the box's way, turn until the heading falls into bin 0 (+-15
/// degrees). Environment for TurnState and TurnActions. Starts params.turn_start_radius_m behind the box, the heading
/// uniform outside bin 0; `reset(seed)` fixes all chance, as in ApproachTask.
template <class Backend>
class TurnTask : public PusherTask<Backend> {
public:
    /// Takes a copy. \throws std::invalid_argument for parameters out of range.
    explicit TurnTask(const PusherParams& params = {}) : PusherTask<Backend>(params) {}

    /// Starts an episode. \throws std::invalid_argument if the start overlaps the box or a wall.
    PusherObservation reset(std::uint64_t seed) {
        const PusherParams& p = this->params();
        Random random(seed, RandomStream::environment);
        this->reset_noise(seed);
        const Direction to_goal =
            direction(std::atan2(p.goal_place.y_m - p.box_place.y_m, p.goal_place.x_m - p.box_place.x_m));
        const Point behind = ahead(p.box_place, to_goal, -p.turn_start_radius_m);
        while (true) {
            const double heading = random.uniform(-pi, pi);
            this->place(this->jittered({behind.x_m, behind.y_m, heading}, random));
            const PusherObservation observation = this->observe();
            if (!is_aligned(to_box_frame(observation))) return observation;
        }
    }

    /// Carries the command out, with its errors. \throws std::invalid_argument for an amount that is not finite.
    Step<PusherObservation> step(const PusherCommand& command) {
        this->move(command);
        const PusherObservation observation = this->observe();
        const bool aligned = is_aligned(to_box_frame(observation));
        return {observation, aligned ? 1.0 : 0.0, aligned, false};
    }

private:
    [[nodiscard]] static bool is_aligned(const Pose& in_box_frame) noexcept {
        return thirty_degree_bin(in_box_frame.heading_rad) == 0;
    }
};

}  // namespace sspql::sim
