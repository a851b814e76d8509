// SPDX-License-Identifier: MIT
#include "experiment/mission_run.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <sspql/core/random.hpp>
#include <sspql/run/parallel.hpp>
#include <sspql/sim/box2d_backend.hpp>
#include <sspql/sim/kinematic_backend.hpp>
#include <sspql/sim/mission/mission.hpp>
#include <sspql/sim/mission/sensed_approach.hpp>
#include <sspql/sim/pusher_tasks.hpp>

#include "experiment/mission_recorder.hpp"
#include "experiment/runner.hpp"

namespace sspql::experiment {

namespace {

constexpr std::size_t episode_limit = 2000;
constexpr std::size_t curve_episodes = 30;
constexpr std::size_t curve_settings = 2;

using ApproachAgent = TimedAgent<sim::ApproachState, sim::ApproachActions>;
using TurnAgent = TimedAgent<sim::TurnState, sim::TurnActions>;

/// One stream of seeds for training, one for the missions: neither depends on how many the other takes.
std::uint64_t robot_seed(const MissionPlan& plan, std::size_t robot) { return Random(plan.seed, 20000 + robot).bits(); }

/// A robot: two learners, trained without physics.
class Robot {
public:
    Robot(const MissionPlan& plan, const LearnerRecipe& recipe, std::uint64_t seed)
        : approach_(recipe.make(sim::ApproachState::size(), sim::ApproachActions::size(), seed)),
          turn_(recipe.make(sim::TurnState::size(), sim::TurnActions::size(), seed)),
          approach_agent_({}, {}, *approach_),
          turn_agent_({}, {}, *turn_),
          seed_(seed) {
        sim::PusherParams world = plan.world;
        world.starts = sim::Starts::anywhere;
        approach_training =
            train<sim::ApproachTask<sim::KinematicBackend>>(world, approach_agent_, plan.approach_episodes);
        turn_training = train<sim::TurnTask<sim::KinematicBackend>>(world, turn_agent_, plan.turn_episodes);
    }

    [[nodiscard]] ApproachAgent& approach() noexcept { return approach_agent_; }
    [[nodiscard]] TurnAgent& turn() noexcept { return turn_agent_; }
    [[nodiscard]] const AnyLearner& approach_learner() const noexcept { return *approach_; }
    [[nodiscard]] const AnyLearner& turn_learner() const noexcept { return *turn_; }

    report::SeedRun approach_training;
    report::SeedRun turn_training;

private:
    template <class Task, class Agent>
    report::SeedRun train(const sim::PusherParams& world, Agent& agent, std::size_t episodes) const {
        Task task(world);
        RunPlan plan;
        plan.episodes = episodes;
        plan.steps_per_episode = episode_limit;
        return run_seed(task, agent, seed_, 0, plan);
    }

    std::unique_ptr<AnyLearner> approach_;
    std::unique_ptr<AnyLearner> turn_;
    ApproachAgent approach_agent_;
    TurnAgent turn_agent_;
    std::uint64_t seed_;
};

report::MissionRecord record_of(const sim::MissionResult& result) {
    report::MissionRecord record;
    record.in_goal = result.in_goal;
    record.first_push = result.first_push;
    record.believed = result.believed;
    record.cornered = result.cornered;
    record.end = std::string(sim::text_of(result.end));
    record.driven_s = result.driven_s;
    for (std::size_t t = 0; t < report::mission_tasks; ++t) {
        record.tasks[t] = {result.tasks[t].attempts, result.tasks[t].successes, result.tasks[t].actions};
    }
    for (std::size_t e = 0; e < sim::outcomes; ++e) {
        const auto outcome = static_cast<sim::Outcome>(e);
        if (outcome == sim::Outcome::success) continue;
        for (int i = 0; i < result.ends[e]; ++i) record.failed_ends.emplace_back(sim::text_of(outcome));
    }
    return record;
}

std::string outcome_text(const report::MissionRecord& record) {
    if (record.first_push) return "in the goal at the first push";
    const int pushes = record.tasks[report::mission_tasks - 1].attempts;
    if (record.in_goal) return "in the goal after " + std::to_string(pushes) + " pushes";
    return record.believed ? "believed to be in the goal, but is not" : "given up: " + record.end;
}

/// What a robot would do, cell by cell.
report::LearntMap map_of(const AnyLearner& learner) {
    report::LearntMap map;
    for (std::size_t a = 0; a < sim::ApproachActions::size(); ++a) {
        map.actions.emplace_back(sim::ApproachActions::describe(action_id(a)));
    }
    for (std::size_t s = 0; s < sim::ApproachState::size(); ++s) {
        bool known = false;
        for (std::size_t a = 0; a < sim::ApproachActions::size(); ++a) {
            known = known || learner.terms(state_id(s), action_id(a)).n > 0.0;
        }
        map.best.push_back(known ? static_cast<int>(index(learner.best(state_id(s)))) : report::LearntMap::unknown);
    }
    return map;
}

/// All missions of one robot, in order.
void run_robot(const MissionPlan& plan, const LearnerRecipe& recipe, std::size_t r, report::MissionResults& results) {
    Robot robot(plan, recipe, robot_seed(plan, r));
    sim::Mission<sim::Box2dBackend> mission(plan.world, plan.sensors, plan.rules);
    for (std::size_t k = r; k < plan.missions; k += plan.robots) {
        Random random(plan.seed, 1000000 + k);
        const sim::MissionStart start = sim::random_mission_start(plan.world, random, plan.box ? &*plan.box : nullptr,
                                                                  plan.goal ? &*plan.goal : nullptr);
        const std::uint64_t seed = random.bits();
        if (k < plan.replays) {
            report::MissionReplay& replay = results.replays[k];
            MissionRecorder recorder(plan.world, robot.approach_learner(), robot.turn_learner(), replay);
            results.missions[k] = record_of(mission.run(start, seed, robot.approach(), robot.turn(), recorder));
            replay.number = k + 1;
            replay.outcome = outcome_text(results.missions[k]);
            replay.in_goal = results.missions[k].in_goal;
            replay.first_push = results.missions[k].first_push;
        } else {
            results.missions[k] = record_of(mission.run(start, seed, robot.approach(), robot.turn()));
        }
    }
    if (r == 0) results.map = map_of(robot.approach_learner());
    results.approach_training[r] = std::move(robot.approach_training);
    results.turn_training[r] = std::move(robot.turn_training);
}

/// One run of 'approach' by SSPQL with bonus: as in simulation (Fig. 11), or as on the real robot (Fig. 13).
report::SeedRun curve_run(const MissionPlan& plan, bool real, std::size_t k) {
    static const LearnerRecipe published = learner_recipes("sspql-bonus", {}).front();
    const auto learner = published.make(sim::ApproachState::size(), sim::ApproachActions::size(), k + 1);
    ApproachAgent agent({}, {}, *learner);
    RunPlan run;
    run.episodes = curve_episodes;
    run.steps_per_episode = episode_limit;
    sim::PusherParams world = plan.world;
    world.starts = sim::Starts::two;
    world.noise = 1.0;
    if (!real) {
        sim::ApproachTask<sim::Box2dBackend> task(world);
        return run_seed(task, agent, k + 1, 0, run);
    }
    sim::SensorParams sensors = plan.sensors;
    world.noise = 2.0;
    sensors.noise = 2.0;
    sim::SensedApproachTask<sim::Box2dBackend> task(world, sensors);
    return run_seed(task, agent, k + 1, 0, run);
}

}  // namespace

sim::PusherParams mission_world() {
    sim::PusherParams world;
    world.body.shape = sim::BodyShape::rectangle;
    return world;
}

std::size_t work_of(const MissionPlan& plan, const shards::Shard& shard) {
    return shard.share(plan.robots) + curve_settings * shard.share(plan.curve_seeds);
}

report::ReplayStage stage_of(const MissionPlan& plan) {
    report::ReplayStage stage;
    stage.half_width_m = plan.world.arena_half_side_m;
    stage.robot_length_m = plan.world.body.length_m;
    stage.robot_width_m = plan.world.body.width_m;
    stage.box_side_m = plan.world.box_side_m;
    stage.goal_radius_m = plan.rules.goal_radius_m;
    stage.camera_field_rad = plan.sensors.camera_field_rad;
    for (std::size_t i = 0; i < sim::SonarRing::count; ++i) {
        stage.sonar_offsets_m.push_back(sim::outline_m(plan.world.body, sim::SonarRing::bearing_rad(i)));
    }
    for (std::size_t a = 0; a < sim::ApproachActions::size(); ++a) {
        stage.approach_actions.emplace_back(sim::ApproachActions::describe(action_id(a)));
    }
    for (std::size_t a = 0; a < sim::TurnActions::size(); ++a) {
        stage.turn_actions.emplace_back(sim::TurnActions::describe(action_id(a)));
    }
    return stage;
}

report::MissionResults blank_missions(const MissionPlan& plan, const LearnerRecipe& recipe) {
    report::MissionResults results;
    results.learner = recipe.name();
    results.missions.resize(plan.missions);
    results.approach_training.resize(plan.robots);
    results.turn_training.resize(plan.robots);
    results.replays.resize(plan.replays);
    if (plan.curve_seeds > 0) {
        results.curves = {{"nominal noise, true poses", std::vector<report::SeedRun>(plan.curve_seeds)},
                          {"twice the noise, by sensors", std::vector<report::SeedRun>(plan.curve_seeds)}};
    }
    return results;
}

void run_missions(const MissionPlan& plan, const LearnerRecipe& recipe, const shards::Shard& shard, std::size_t threads,
                  const std::function<void()>& advance, report::MissionResults& results) {
    const std::size_t robots = shard.share(plan.robots);
    parallel_for(work_of(plan, shard), threads, [&](std::size_t i) {
        if (i < robots) {
            run_robot(plan, recipe, shard.unit(i), results);
        } else {
            const std::size_t curve = (i - robots) % curve_settings;
            const std::size_t k = shard.unit((i - robots) / curve_settings);
            results.curves[curve].runs[k] = curve_run(plan, curve == 1, k);
        }
        advance();
    });
}

}  // namespace sspql::experiment
