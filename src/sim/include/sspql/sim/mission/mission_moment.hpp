// SPDX-License-Identifier: MIT
#pragma once

#include <sspql/sim/belief.hpp>
#include <sspql/sim/mission/mission_types.hpp>
#include <sspql/sim/pose.hpp>
#include <sspql/sim/pusher_spaces.hpp>
#include <sspql/sim/sensors/sensor_suite.hpp>

namespace sspql::sim {

/// What an observer of a mission is shown before each action and once at the end.
struct MissionMoment {
    SubTask task = SubTask::search;          ///< what the robot is about
    int attempt = 1;                         ///< at the whole job, from 1
    const Scene& scene;                      ///< the truth, arena frame
    const Pose& frame;                       ///< the belief's frame, in the arena's
    const Belief& belief;                    ///< what the robot believes
    const SensorReadings& readings;          ///< what its sensors say
    const PusherCommand* command = nullptr;  ///< about to be executed; none at the end
};

/// Looks at nothing; what Mission::run shows its moments unless told otherwise.
struct NoMissionObserver {
    /// Does nothing.
    void operator()(const MissionMoment&) const noexcept {}
};

}  // namespace sspql::sim
