// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include <sspql/core/errors.hpp>
#include <sspql/core/random.hpp>
#include <sspql/env/environment.hpp>
#include <sspql/spaces/uniform_grid.hpp>

namespace sspql {

/// The three commands of a MountainCar; EnumActions<Throttle>(3) decodes them.
enum class Throttle : std::uint8_t { back, none, forward };

/// Settings of a MountainCar.
struct MountainCarParams {
    std::size_t ticks = 1;      ///< a command is held for so many ticks of the dynamics; they make one step
    double step_reward = -1.0;  ///< of each step, however many ticks it has
    double goal_reward = -1.0;  ///< of the step that reaches the goal, instead of step_reward
};

/// Environment: a car in a valley whose engine is too weak for the slope, so that it must swing (Moore 1990; as in
/// Sutton and Barto 2018, example 10.1). Observation: {position, velocity}; command: Throttle. A tick changes
///
///     velocity <- velocity + 0.001 throttle - 0.0025 cos(3 position)     throttle -1, 0, 1; kept within +-0.07
///     position <- position + velocity                                    kept above -1.2, a wall that stops the car
///
/// and the episode ends on the right hilltop, position 0.5. It starts at rest near the bottom, at a position uniform in
/// [-0.6, -0.4). A continuous observation meets a tabular learner through a grid:
///
///     sspql::Agent robot(sspql::MountainCar::grid(24), sspql::EnumActions<sspql::Throttle>(3));
///
/// The cells are not quite states: a slow car stays in one for several ticks, and where it goes from there depends on
/// where in the cell it was. Holding a command for several ticks makes up for that.
///
/// Chance: reset(seed) draws one number from RandomStream::environment; steps are deterministic. O(ticks), without
/// allocation. The same bits need the same cos.
/// \throws std::invalid_argument for no ticks, or rewards that are not finite.
class MountainCar {
public:
    /// Position, and velocity in positions a tick.
    using Observation = std::array<double, 2>;

    static constexpr double leftmost = -1.2;   ///< where the wall is
    static constexpr double goal = 0.5;        ///< the position of the right hilltop
    static constexpr double fastest = 0.07;    ///< per tick
    static constexpr std::size_t actions = 3;  ///< how many commands there are

    /// The car is nowhere until reset().
    explicit MountainCar(MountainCarParams params = {}) : params_(params) {
        if (params.ticks == 0) throw_invalid("ticks", "be at least 1", params.ticks);
        require_finite("step reward", params.step_reward);
        require_finite("goal reward", params.goal_reward);
    }

    /// StatePolicy: `cells` x `cells` boxes over all positions and velocities.
    [[nodiscard]] static UniformGrid<2> grid(std::size_t cells) {
        return UniformGrid<2>({{{leftmost, goal, cells}, {-fastest, fastest, cells}}});
    }

    /// Starts an episode: at rest, near the bottom, where the seed says. \returns the first observation.
    Observation reset(std::uint64_t seed) {
        Random start(seed, RandomStream::environment);
        return place({start.uniform(-0.6, -0.4), 0.0});
    }

    /// Starts an episode at this position and velocity instead.
    /// \throws std::invalid_argument for a position outside [-1.2, 0.5) or a velocity outside +-0.07.
    Observation place(const Observation& at) {
        if (!(at[0] >= leftmost && at[0] < goal)) throw_invalid("position", "lie in [-1.2, 0.5)", at[0]);
        require_in("velocity", at[1], -fastest, fastest);
        at_ = at;
        running_ = true;
        return at_;
    }

    /// Holds the command for a step.
    /// \throws std::logic_error before reset() and after the end of an episode; std::invalid_argument for no Throttle.
    Step<Observation> step(Throttle throttle) {
        if (!running_) throw std::logic_error("step() outside an episode: reset() first");
        if (static_cast<std::size_t>(throttle) >= actions) {
            throw_invalid("throttle", "be below 3", static_cast<int>(throttle));
        }
        const double push = 0.001 * (static_cast<double>(throttle) - 1.0);
        for (std::size_t k = 0; k < params_.ticks && running_; ++k) tick(push);
        return {at_, running_ ? params_.step_reward : params_.goal_reward, !running_, false};
    }

    /// Where the car is and how fast it goes.
    [[nodiscard]] const Observation& observation() const noexcept { return at_; }
    /// Ticks and rewards, as given.
    [[nodiscard]] const MountainCarParams& params() const noexcept { return params_; }

private:
    void tick(double push) noexcept {
        double& position = at_[0];
        double& velocity = at_[1];
        velocity = std::clamp(velocity + push - 0.0025 * std::cos(3.0 * position), -fastest, fastest);
        position += velocity;
        if (position < leftmost) {
            position = leftmost;
            velocity = 0.0;
        }
        running_ = position < goal;
        position = std::min(position, goal);
    }

    MountainCarParams params_;
    Observation at_{};
    bool running_ = false;
};

}  // namespace sspql
