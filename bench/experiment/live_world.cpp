// SPDX-License-Identifier: MIT
#include "experiment/live_world.hpp"

#include <stdexcept>

#include <sspql/env/time_limit.hpp>
#include <sspql/sim/box2d_backend.hpp>
#include <sspql/sim/kinematic_backend.hpp>
#include <sspql/sim/pusher_tasks.hpp>

namespace sspql::experiment {

namespace {

template <class Task, class States, class Actions>
class WorldBox final : public LiveWorld {
public:
    WorldBox(const sim::PusherParams& params, std::size_t steps_per_episode)
        : limited_(Task(params), steps_per_episode) {}

    sim::PusherObservation reset(std::uint64_t seed) override { return limited_.reset(seed); }
    Step<sim::PusherObservation> step(ActionId action) override { return limited_.step(Actions::decode(action)); }
    [[nodiscard]] sim::Move last_move() const override { return limited_.environment().last_move(); }

    [[nodiscard]] std::size_t states() const override { return States::size(); }
    [[nodiscard]] std::size_t actions() const override { return Actions::size(); }
    [[nodiscard]] StateId encode(const sim::PusherObservation& observation) const override {
        return States::encode(observation);
    }
    [[nodiscard]] std::string state_text(StateId s) const override { return States::describe(s); }
    [[nodiscard]] sim::PusherCommand command(ActionId action) const override { return Actions::decode(action); }
    [[nodiscard]] std::string action_text(ActionId action) const override { return Actions::describe(action); }
    [[nodiscard]] const sim::PusherParams& params() const override { return limited_.environment().params(); }

private:
    TimeLimit<Task> limited_;
};

template <class Backend>
std::unique_ptr<LiveWorld> world_of(const std::string& task, const sim::PusherParams& params, std::size_t steps) {
    using namespace sim;
    if (task == "approach") {
        return std::make_unique<WorldBox<ApproachTask<Backend>, ApproachState, ApproachActions>>(params, steps);
    }
    if (task == "turn") return std::make_unique<WorldBox<TurnTask<Backend>, TurnState, TurnActions>>(params, steps);
    throw std::invalid_argument("the task must be approach or turn, got '" + task + "'");
}

}  // namespace

std::unique_ptr<LiveWorld> make_live_world(const std::string& backend, const std::string& task,
                                           const sim::PusherParams& params, std::size_t steps_per_episode) {
    if (backend == "kinematic") return world_of<sim::KinematicBackend>(task, params, steps_per_episode);
    if (backend == "box2d") return world_of<sim::Box2dBackend>(task, params, steps_per_episode);
    throw std::invalid_argument("the backend must be kinematic or box2d, got '" + backend + "'");
}

}  // namespace sspql::experiment
