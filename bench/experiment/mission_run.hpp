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
#include "shards/shard.hpp"

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

/// Room for all that a plan's missions will find, manifest and settings aside.
[[nodiscard]] report::MissionResults blank_missions(const MissionPlan& plan, const LearnerRecipe& recipe);

/// Trains the robots on the kinematic backend, lets them do the missions on Box2D, where they go on learning, and then
/// records 'approach' in the settings of Figs. 11 and 13: those robots, and those seeds of the curves, that are in the
/// shard. What is found goes into blank_missions' results and does not depend on `threads`. `advance` is called once
/// for every robot and curve that is done, `work_of` says how often.
///
/// \throws std::invalid_argument for parameters out of range, or box and goal that cannot be reached.
void run_missions(const MissionPlan& plan, const LearnerRecipe& recipe, const shards::Shard& shard, std::size_t threads,
                  const std::function<void()>& advance, report::MissionResults& results);

[[nodiscard]] std::size_t work_of(const MissionPlan& plan, const shards::Shard& shard);

/// What the replays of a plan have in common.
[[nodiscard]] report::ReplayStage stage_of(const MissionPlan& plan);

}  // namespace sspql::experiment
