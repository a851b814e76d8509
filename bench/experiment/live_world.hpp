// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include <sspql/core/ids.hpp>
#include <sspql/env/environment.hpp>
#include <sspql/sim/backend.hpp>
#include <sspql/sim/pusher_params.hpp>
#include <sspql/sim/pusher_spaces.hpp>

namespace sspql::experiment {

/// A pusher task whose type is chosen when the program runs, with its states and actions: what a learner of ids needs.
/// Episodes are cut as TimeLimit does. One object per thread.
class LiveWorld {
public:
    LiveWorld() = default;
    LiveWorld(const LiveWorld&) = delete;
    LiveWorld& operator=(const LiveWorld&) = delete;
    virtual ~LiveWorld() = default;

    virtual sim::PusherObservation reset(std::uint64_t seed) = 0;
    virtual Step<sim::PusherObservation> step(ActionId action) = 0;

    /// How the last step's move went: how far, and what stopped it.
    [[nodiscard]] virtual sim::Move last_move() const = 0;

    [[nodiscard]] virtual std::size_t states() const = 0;
    [[nodiscard]] virtual std::size_t actions() const = 0;
    [[nodiscard]] virtual StateId encode(const sim::PusherObservation& observation) const = 0;
    [[nodiscard]] virtual std::string state_text(StateId s) const = 0;
    [[nodiscard]] virtual sim::PusherCommand command(ActionId action) const = 0;
    [[nodiscard]] virtual std::string action_text(ActionId action) const = 0;
    [[nodiscard]] virtual const sim::PusherParams& params() const = 0;
};

/// Backend "kinematic" or "box2d", task "approach" or "turn".
/// \throws std::invalid_argument for another name, parameters out of range, or no steps per episode.
[[nodiscard]] std::unique_ptr<LiveWorld> make_live_world(const std::string& backend, const std::string& task,
                                                         const sim::PusherParams& params,
                                                         std::size_t steps_per_episode);

}  // namespace sspql::experiment
