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
    SubTask task = SubTask::search;
    int attempt = 1;
    const Scene& scene;  ///< the truth, arena frame
    const Pose& frame;   ///< the belief's frame, in the arena's
    const Belief& belief;
    const SensorReadings& readings;
    const PusherCommand* command = nullptr;  ///< about to be executed; none at the end
};

struct NoMissionObserver {
    void operator()(const MissionMoment&) const noexcept {}
};

}  // namespace sspql::sim
