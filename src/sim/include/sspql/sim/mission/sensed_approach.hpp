// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#include <sspql/env/environment.hpp>
#include <sspql/sim/belief.hpp>
#include <sspql/sim/box_frame.hpp>
#include <sspql/sim/pusher_params.hpp>
#include <sspql/sim/pusher_spaces.hpp>
#include <sspql/sim/pusher_tasks.hpp>
#include <sspql/sim/sensors/sensor_suite.hpp>

namespace sspql::sim {

/// 'approach' as the paper's real robot met it (Fig. 13): ApproachTask, but what is observed, rewarded and ended by is
/// what the robot believes. An episode begins with a true idea of where box and goal are; from then on odometry drifts
/// and sensors correct. While the box is forgotten, the last observation stays.
///
/// `reset(seed)` fixes all chance of the episode, as in ApproachTask; sensors draw from SensorSuite::random_stream.
template <class Backend>
class SensedApproachTask {
public:
    /// Takes copies of all numbers. \throws std::invalid_argument for parameters out of range.
    explicit SensedApproachTask(const PusherParams& params = {}, const SensorParams& sensors = {})
        : task_(params), sensors_(sensors), belief_(sensors, params.box_side_m) {}

    /// Starts an episode. \throws std::invalid_argument as ApproachTask::reset does.
    PusherObservation reset(std::uint64_t seed) {
        observation_ = task_.reset(seed);
        sensors_.reset(seed);
        belief_.know(observation_.robot, position(observation_.box), observation_.goal);
        return observation_;
    }

    /// Carries the command out, with its errors. \throws std::invalid_argument for an amount that is not finite.
    Step<PusherObservation> step(const PusherCommand& command) {
        const Pose before = task_.backend().robot();
        task_.step(command);
        belief_.travelled(sensors_.travelled(before, task_.backend().robot()));
        belief_.look(sensors_.look(scene_of(task_.backend())), sensors_.range_finder());
        if (belief_.is_complete()) observation_ = belief_.observation();
        const bool arrived = belief_.is_complete() && in_push_sector(to_box_frame(observation_));
        return {observation_, arrived ? 1.0 : 0.0, arrived, false};
    }

    /// The task as it truly is.
    [[nodiscard]] const ApproachTask<Backend>& task() const noexcept { return task_; }
    /// What the robot believes.
    [[nodiscard]] const Belief& belief() const noexcept { return belief_; }

private:
    ApproachTask<Backend> task_;
    SensorSuite sensors_;
    Belief belief_;
    PusherObservation observation_{};
};

}  // namespace sspql::sim
