// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include <sspql/sim/mission/mission_types.hpp>
#include <sspql/sim/pose.hpp>
#include <sspql/sim/pusher_params.hpp>
#include <sspql/sim/sensors/sensor_params.hpp>

#include "experiment/learner_catalog.hpp"
#include "report/mission_results.hpp"

namespace sspql::experiment {

/// What pusher_mission does.
struct MissionPlan {
    sim::PusherParams world{};
    sim::SensorParams sensors{};
    sim::MissionParams rules{};
    std::uint64_t seed = 1;
    std::size_t missions = 300;
    std::size_t robots = 30;  ///< each trained by itself; mission k is done by robot k mod robots, in order
    std::size_t approach_episodes = 150;
    std::size_t turn_episodes = 50;
    std::size_t replays = 0;  ///< the first so many missions are recorded
    std::size_t curve_seeds = 0;
    std::optional<sim::Point> box{};
    std::optional<sim::Point> goal{};
};

/// A world with the mission's robot: a rectangle with a flat front.
[[nodiscard]] sim::PusherParams mission_world();

/// Trains the robots on the kinematic backend, lets them do the missions on Box2D, where they go on learning, and then
/// records 'approach' in the settings of Figs. 11 and 13. The results, manifest and settings aside. They do not depend
/// on `threads`. `advance` is called once for every robot and curve that is done, `work_of` says how often.
///
/// \throws std::invalid_argument for parameters out of range, or box and goal that cannot be reached.
[[nodiscard]] report::MissionResults run_missions(const MissionPlan& plan, const LearnerRecipe& recipe,
                                                  std::size_t threads, const std::function<void()>& advance);

[[nodiscard]] std::size_t work_of(const MissionPlan& plan);

/// What the replays of a plan have in common.
[[nodiscard]] report::ReplayStage stage_of(const MissionPlan& plan);

}  // namespace sspql::experiment
