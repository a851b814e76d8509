// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include <sspql/sim/backend.hpp>
#include <sspql/sim/belief.hpp>
#include <sspql/sim/box_frame.hpp>
#include <sspql/sim/mission/mission_moment.hpp>
#include <sspql/sim/mission/mission_start.hpp>
#include <sspql/sim/mission/mission_types.hpp>
#include <sspql/sim/mission/push_controller.hpp>
#include <sspql/sim/mission/search_controller.hpp>
#include <sspql/sim/pusher_params.hpp>
#include <sspql/sim/pusher_spaces.hpp>
#include <sspql/sim/pusher_tasks.hpp>
#include <sspql/sim/sensors/sensor_suite.hpp>

namespace sspql::sim {

/// The whole job of section 4.1: search, approach, turn, push, as a state machine with retries and time-outs, over a
/// backend whose box can be pushed. 'search' and 'push' are predetermined, 'approach' and 'turn' are learnt.
///
/// The learnt ones are agents over observations and commands, anything run_episode takes: begin(PusherObservation) ->
/// PusherCommand, step(reward, observation) -> command, end(reward, observation, terminated), abort(). The mission
/// gives them an episode each time, whose observations are what the robot believes: reward 1 and terminated behind the
/// box ('turn': looking along its way), a cut episode when the time is up or the box is lost. They go on learning or
/// not, as they like.
///
/// After a push the robot backs off and looks: from there a goal with the box in it shows at least one of its sides. A
/// push that failed, or did not deliver, is followed by another attempt; if the goal was not seen, by a search for it.
/// Away from the push a collision guard stops translations; the fence is kept by the robot itself, by what it believes.
///
/// `run` takes all chance from its seed (actuators RandomStream::noise, sensors SensorSuite::random_stream) and from
/// the agents. One object per thread.
template <class Backend>
class Mission {
    static_assert(is_pusher_backend_v<Backend>, "sspql: this is no PusherBackend, see sspql/sim/backend.hpp");

public:
    /// Takes copies of all numbers. \throws std::invalid_argument for parameters out of range.
    explicit Mission(const PusherParams& world = {}, const SensorParams& sensors = {}, const MissionParams& rules = {})
        : rules_((rules.validate(), rules)),
          fence_radius_m_(world.fence_radius_m),
          max_speed_m_per_s_(world.max_speed_m_per_s),
          max_turn_rad_per_s_(world.max_turn_rad_per_s),
          backend_(without_fence(world)),
          actuator_(world),
          sensors_(sensors),
          belief_(sensors, world.box_side_m),
          push_(world) {}

    /// One mission. \throws std::invalid_argument for a start the backend refuses.
    template <class Approach, class Turn, class Observer = NoMissionObserver>
    MissionResult run(const MissionStart& start, std::uint64_t seed, Approach& approach, Turn& turn,
                      Observer&& observer = {}) {
        backend_.reset(start.robot, start.box, start.goal);
        actuator_.reset(seed);
        sensors_.reset(seed);
        result_ = {};
        attempt_ = 1;
        frame_ = rules_.sensing == Sensing::truth ? Pose{} : backend_.robot();
        belief_.forget_all();
        task_ = SubTask::search;
        look();
        for (; attempt_ <= rules_.pushes; ++attempt_) {
            result_.end = attempt(approach, turn, observer);
            ++result_.ends[static_cast<std::size_t>(result_.end)];
            if (result_.end == Outcome::success) break;
        }
        result_.believed = result_.end == Outcome::success;
        result_.in_goal = distance_m(position(backend_.box()), backend_.goal()) < rules_.goal_radius_m;
        result_.cornered =
            !result_.in_goal && !has_push_place(backend_.params(), position(backend_.box()), backend_.goal());
        result_.first_push = result_.in_goal && result_.of(SubTask::push).attempts == 1;
        observer(moment(nullptr));
        return result_;
    }

    /// The world, as the last action left it.
    [[nodiscard]] const Backend& backend() const noexcept { return backend_; }
    /// The robot's sensors.
    [[nodiscard]] const SensorSuite& sensors() const noexcept { return sensors_; }

private:
    static constexpr double sure_m = 0.03;  // so far inside of the goal's edge the box must be believed

    static PusherParams without_fence(PusherParams params) {
        params.fence = false;
        return params;
    }

    template <class Approach, class Turn, class Observer>
    Outcome attempt(Approach& approach, Turn& turn, Observer& observer) {
        Outcome outcome = tallied(SubTask::search, [&] { return search(observer); });
        if (outcome != Outcome::success || is_delivered()) return outcome;
        if (!is_behind()) {
            outcome = tallied(SubTask::approach, [&] {
                return learnt(
                    approach, rules_.approach_actions, Outcome::approach_timeout, [this] { return is_behind(); },
                    observer);
            });
            if (outcome != Outcome::success) return outcome;
        }
        if (!is_aligned()) {
            outcome = tallied(SubTask::turn, [&] {
                return learnt(
                    turn, rules_.turn_actions, Outcome::turn_timeout, [this] { return is_aligned(); }, observer);
            });
            if (outcome != Outcome::success) return outcome;
        }
        return tallied(SubTask::push, [&] { return push(observer); });
    }

    template <class Body>
    Outcome tallied(SubTask task, Body&& body) {
        task_ = task;
        ++result_.of(task).attempts;
        const Outcome outcome = body();
        if (outcome == Outcome::success) ++result_.of(task).successes;
        return outcome;
    }

    template <class Observer>
    Outcome search(Observer& observer) {
        search_.begin();
        for (int i = 0; i < rules_.search_actions; ++i) {
            const std::optional<PusherCommand> command = search_.next(belief_, readings_.sonars);
            if (!command) return Outcome::success;
            act(*command, observer);
        }
        return belief_.is_complete() ? Outcome::success : Outcome::search_timeout;
    }

    /// One episode of a learnt sub-task.
    template <class Agent, class Arrived, class Observer>
    Outcome learnt(Agent& agent, int most_actions, Outcome timeout, const Arrived& arrived, Observer& observer) {
        PusherObservation seen = belief_.observation();
        try {
            PusherCommand command = agent.begin(seen);
            for (int i = 1;; ++i) {
                act(fenced(command), observer);
                const bool lost = !belief_.is_complete();
                if (!lost) seen = belief_.observation();
                const bool there = !lost && arrived();
                if (there || lost || i >= most_actions) {
                    agent.end(there ? 1.0 : 0.0, seen, there);
                    return there ? Outcome::success : lost ? Outcome::box_forgotten : timeout;
                }
                command = agent.step(0.0, seen);
            }
        } catch (...) {
            agent.abort();
            throw;
        }
    }

    template <class Observer>
    Outcome push(Observer& observer) {
        push_.begin(belief_);
        backend_.set_guard(false);
        Outcome outcome = Outcome::push_timeout;
        for (int i = 0; i < rules_.push_actions; ++i) {
            if (!belief_.is_complete()) {
                outcome = Outcome::box_forgotten;
                break;
            }
            const PushStep step = push_.next(belief_);
            if (step.over) {
                outcome = step.outcome;
                break;
            }
            act(step.command, observer);
        }
        backend_.set_guard(true);
        bool goal_seen = false;
        for (int i = 0; i < 2; ++i) {
            act({Motion::translate, -0.2}, observer);
            goal_seen = goal_seen || readings_.view.goal.has_value();
        }
        if (outcome != Outcome::success) return outcome;
        if (!goal_seen) {
            belief_.forget_goal();
            return Outcome::goal_not_seen;
        }
        if (!belief_.is_complete()) return Outcome::box_forgotten;
        return is_delivered() ? Outcome::success : Outcome::not_delivered;
    }

    [[nodiscard]] bool is_delivered() const noexcept {
        const PusherObservation seen = belief_.observation();
        return distance_m(position(seen.box), seen.goal) < rules_.goal_radius_m - sure_m;
    }

    template <class Observer>
    void act(const PusherCommand& command, Observer& observer) {
        observer(moment(&command));
        const Pose before = backend_.robot();
        const Move move = actuator_.execute(backend_, command);
        const double full = command.motion == Motion::rotate ? max_turn_rad_per_s_ : max_speed_m_per_s_;
        result_.driven_s += std::fabs(move.amount) / full;
        ++result_.of(task_).actions;
        belief_.travelled(sensors_.travelled(before, backend_.robot()));
        look();
    }

    void look() {
        scene_ = scene_of(backend_);
        readings_ = sensors_.look(scene_);
        if (rules_.sensing == Sensing::truth) {
            belief_.know(scene_.robot, scene_.box.centre, scene_.goal);
        } else {
            belief_.look(readings_, sensors_.range_finder());
        }
    }

    /// A translation only as far as the fence about the believed box lets it.
    [[nodiscard]] PusherCommand fenced(PusherCommand command) const noexcept {
        if (command.motion == Motion::rotate) return command;
        const PusherObservation seen = belief_.observation();
        const Direction heading = direction(seen.robot.heading_rad);
        const bool forward = command.amount > 0.0;
        const double allowed = distance_inside_fence(position(seen.robot), forward ? heading : reversed(heading),
                                                     std::fabs(command.amount), position(seen.box), fence_radius_m_);
        command.amount = forward ? allowed : -allowed;
        return command;
    }

    [[nodiscard]] bool is_behind() const { return in_push_sector(to_box_frame(belief_.observation())); }
    [[nodiscard]] bool is_aligned() const {
        return thirty_degree_bin(to_box_frame(belief_.observation()).heading_rad) == 0;
    }

    [[nodiscard]] MissionMoment moment(const PusherCommand* command) const noexcept {
        return {task_, attempt_, scene_, frame_, belief_, readings_, command};
    }

    MissionParams rules_;
    double fence_radius_m_;
    double max_speed_m_per_s_;
    double max_turn_rad_per_s_;
    Backend backend_;
    NoisyActuator actuator_;
    SensorSuite sensors_;
    Belief belief_;
    SearchController search_;
    PushController push_;
    SubTask task_ = SubTask::search;
    int attempt_ = 1;
    Pose frame_{};
    Scene scene_{};
    SensorReadings readings_{};
    MissionResult result_{};
};

}  // namespace sspql::sim
