// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <sspql/sim/box2d_backend.hpp>
#include <sspql/sim/kinematic_backend.hpp>
#include <sspql/sim/pusher_tasks.hpp>

#include "experiment/learner_catalog.hpp"
#include "experiment/live_run.hpp"
#include "experiment/live_world.hpp"
#include "experiment/runner.hpp"

namespace sspql::experiment {
namespace {

constexpr std::size_t episode_limit = 60;  // cuts some of the early episodes

LiveRun live_run(const std::string& backend, const std::string& task, const std::string& learners, std::uint64_t seed) {
    return LiveRun(make_live_world(backend, task, {}, episode_limit), learner_recipes(learners, {}), seed);
}

void finish(LiveRun& run, std::size_t episodes) {
    run.stop_after(episodes);
    while (!run.is_over()) run.tick();
}

/// What the experiment makes of the same learner, seed and task.
template <class Task, class States, class Actions>
std::vector<report::EpisodeRecord> experiment(const std::string& learner, std::uint64_t seed, std::size_t episodes) {
    Task task{sim::PusherParams{}};
    const auto made = learner_recipes(learner, {})[0].make(States::size(), Actions::size(), seed);
    TimedAgent agent(States{}, Actions{}, *made);
    RunPlan plan;
    plan.episodes = episodes;
    plan.steps_per_episode = episode_limit;
    return run_seed(task, agent, seed, 0, plan).episodes;
}

template <class Task, class States, class Actions>
void expect_the_experiment(const std::string& backend, const std::string& task, std::size_t episodes) {
    std::size_t cut = 0;
    for (const std::string learner : {"q", "sspql-bonus", "dyna-q-bonus:20", "adaptive"}) {
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            SCOPED_TRACE(backend + " " + task + " " + learner + " seed " + std::to_string(seed));
            LiveRun run = live_run(backend, task, learner, seed);
            finish(run, episodes);
            const auto expected = experiment<Task, States, Actions>(learner, seed, episodes);
            ASSERT_EQ(run.episodes().size(), expected.size());
            std::size_t steps = 0;
            for (std::size_t k = 0; k < episodes; ++k) {
                EXPECT_EQ(run.episodes()[k].steps, expected[k].steps) << "episode " << k;
                EXPECT_EQ(run.episodes()[k].success, expected[k].success) << "episode " << k;
                steps += expected[k].steps;
                cut += expected[k].capped ? 1 : 0;
            }
            EXPECT_EQ(run.total_steps(), steps);
        }
    }
    if (task == "approach") {
        EXPECT_GT(cut, 0U) << "episodes that are cut have not been compared";
    }
}

TEST(LiveRun, ShowsTheRunThatTheExperimentMakes) {
    using namespace sim;
    expect_the_experiment<ApproachTask<KinematicBackend>, ApproachState, ApproachActions>("kinematic", "approach", 25);
    expect_the_experiment<TurnTask<KinematicBackend>, TurnState, TurnActions>("kinematic", "turn", 25);
    expect_the_experiment<ApproachTask<Box2dBackend>, ApproachState, ApproachActions>("box2d", "approach", 10);
    expect_the_experiment<TurnTask<Box2dBackend>, TurnState, TurnActions>("box2d", "turn", 10);
}

TEST(LiveRun, LookingAtItChangesNothing) {
    LiveRun watched = live_run("kinematic", "approach", "adaptive", 5);
    watched.stop_after(15);
    while (!watched.is_over()) {
        for (std::size_t s = 0; s < watched.world().states(); s += 7) (void)watched.view(state_id(s));
        watched.tick();
    }
    LiveRun alone = live_run("kinematic", "approach", "adaptive", 5);
    finish(alone, 15);
    EXPECT_EQ(watched.total_steps(), alone.total_steps());
    EXPECT_EQ(watched.observation().robot, alone.observation().robot);
}

TEST(LiveRun, ATickIsAnActionAndAfterAnEpisodeTheNextBeginning) {
    LiveRun run = live_run("kinematic", "approach", "q", 1);
    EXPECT_EQ(run.episode(), 1U);
    EXPECT_EQ(run.episode_steps(), 0U);
    ASSERT_TRUE(run.next());
    EXPECT_FALSE(run.last());
    while (!run.is_episode_over()) {
        const std::size_t before = run.total_steps();
        const Decision decision = *run.next();
        EXPECT_EQ(decision.state, run.world().encode(run.observation()));
        EXPECT_EQ(decision.terms.size(), 4U);
        run.tick();
        EXPECT_EQ(run.total_steps(), before + 1);
        ASSERT_TRUE(run.last());
        EXPECT_EQ(run.last()->action, decision.action);
        EXPECT_EQ(run.last()->state, decision.state);
    }
    EXPECT_FALSE(run.next());
    EXPECT_EQ(run.episode(), 1U);
    EXPECT_EQ(run.episodes()[0].steps, run.total_steps());
    EXPECT_EQ(run.trail().size(), run.total_steps() + 1);
    EXPECT_TRUE(run.last_trail().empty());
    const auto trail = run.trail();
    const std::size_t steps = run.total_steps();
    run.tick();
    EXPECT_EQ(run.total_steps(), steps);
    EXPECT_EQ(run.episode(), 2U);
    EXPECT_EQ(run.trail().size(), 1U);
    EXPECT_EQ(run.last_trail(), trail);
}

TEST(LiveRun, AnotherLearnerOrSeedBeginsAnew) {
    LiveRun run = live_run("kinematic", "approach", "q,sspql-bonus", 1);
    finish(run, 5);
    run.choose_learner(1);
    EXPECT_EQ(run.learner_name(), "sspql-bonus");
    EXPECT_EQ(run.total_steps(), 0U);
    EXPECT_TRUE(run.episodes().empty());
    EXPECT_TRUE(run.last_trail().empty());
    EXPECT_FALSE(run.view(run.next()->state).tried) << "nothing is left of what the other learnt";
    finish(run, 5);
    LiveRun fresh = live_run("kinematic", "approach", "sspql-bonus", 1);
    finish(fresh, 5);
    EXPECT_EQ(run.total_steps(), fresh.total_steps());
    EXPECT_EQ(run.observation().robot, fresh.observation().robot);

    run.restart(2);
    EXPECT_EQ(run.seed(), 2U);
    finish(run, 5);
    LiveRun second = live_run("kinematic", "approach", "sspql-bonus", 2);
    finish(second, 5);
    EXPECT_EQ(run.total_steps(), second.total_steps());
    EXPECT_NE(second.total_steps(), fresh.total_steps());
}

TEST(LiveRun, NothingHappensAfterTheLastEpisode) {
    LiveRun run = live_run("kinematic", "turn", "q", 1);
    finish(run, 3);
    const std::size_t steps = run.total_steps();
    run.tick();
    EXPECT_EQ(run.total_steps(), steps);
    EXPECT_EQ(run.episodes().size(), 3U);
    EXPECT_TRUE(run.is_episode_over());
    run.stop_after(4);
    EXPECT_FALSE(run.is_over());
}

TEST(LiveRun, ViewsTellTheWorthOfWhatWasTried) {
    LiveRun run = live_run("kinematic", "turn", "q", 1);  // 12 headings, gamma = alpha = .8, reward 1 at the goal
    const StateId first = run.next()->state;
    EXPECT_FALSE(run.view(first).tried);
    EXPECT_EQ(run.view(first).value, 0.0);
    finish(run, 1);
    const StateView before_goal = run.view(run.last()->state);
    EXPECT_TRUE(before_goal.tried);
    EXPECT_NEAR(before_goal.value, 0.8, 1e-12);  // one update from 0 towards 1
    EXPECT_EQ(before_goal.best, run.last()->action);
    EXPECT_THROW((void)run.view(state_id(12)), std::invalid_argument);
}

TEST(LiveRun, RefusesWhatIsNone) {
    EXPECT_THROW((void)make_live_world("gazebo", "turn", {}, 10), std::invalid_argument);
    EXPECT_THROW((void)make_live_world("box2d", "dance", {}, 10), std::invalid_argument);
    EXPECT_THROW((void)make_live_world("kinematic", "turn", {}, 0), std::invalid_argument);
    EXPECT_THROW(LiveRun(make_live_world("kinematic", "turn", {}, 10), {}, 1), std::invalid_argument);
    LiveRun run = live_run("kinematic", "turn", "q", 1);
    EXPECT_THROW(run.choose_learner(1), std::invalid_argument);
    EXPECT_EQ(run.learner_name(), "q");
}

}  // namespace
}  // namespace sspql::experiment
