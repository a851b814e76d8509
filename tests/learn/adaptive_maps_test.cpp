// SPDX-License-Identifier: MIT
// What AdaptiveSspql is for: fewer steps than the paper's planner, also after the map changed, on large maps, and with
// little planning a step.
#include <sspql/learn/adaptive_sspql.hpp>

#include <cstddef>
#include <cstdint>

#include <gtest/gtest.h>

#include <sspql/env/grid_maps.hpp>
#include <sspql/env/random_mdp.hpp>
#include <sspql/env/tabular_environment.hpp>
#include <sspql/env/time_limit.hpp>
#include <sspql/learn/agent.hpp>
#include <sspql/run/episode.hpp>
#include <sspql/spaces/enum_state.hpp>

namespace sspql_adaptive_maps_test {

using namespace sspql;

namespace {

struct Totals {
    double before = 0.0;   ///< steps of 30 episodes on the first map, mean of the seeds
    double after = 0.0;    ///< of 30 episodes on the second one, after 50 on the first
    double touches = 0.0;  ///< edges touched a step
};

template <class Params>
Totals run_chain(const Params& params, const char* first, const char* second) {
    constexpr std::uint64_t seeds = 20;
    Totals totals;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        TimeLimit world(grid_task(first).world(), 2000);
        Agent robot(EnumState<StateId>(64), EnumActions<Move>(4), params, seed);
        std::size_t steps = 0;
        for (const auto& e : run_episodes(world, robot, 30, seed * 1000)) steps += e.steps;
        totals.before += static_cast<double>(steps) / seeds;
        for (const auto& e : run_episodes(world, robot, 20, seed * 1000 + 30)) steps += e.steps;
        world.environment().set_map(grid_task(second).map);
        for (const auto& e : run_episodes(world, robot, 30, seed * 1000 + 500)) {
            totals.after += static_cast<double>(e.steps) / seeds;
            steps += e.steps;
        }
        totals.touches += static_cast<double>(robot.learner().model_operations()) / static_cast<double>(steps) / seeds;
    }
    return totals;
}

/// Steps of 100 episodes on a large map.
double large_map(const AdaptiveParams<>& params, std::uint64_t number, std::uint64_t seed, double* touches = nullptr) {
    GridWorldParams settings;
    settings.slip = 0.1;
    GridWorld world(random_walls(60, 0.2, number), settings);
    Agent robot(EnumState<StateId>(world.size()), EnumActions<Move>(4), params, seed);
    double steps = 0.0;
    for (const auto& e : run_episodes(world, robot, 100, seed * 1000)) steps += static_cast<double>(e.steps);
    if (touches != nullptr) *touches = static_cast<double>(robot.learner().model_operations()) / steps;
    return steps;
}

}  // namespace

TEST(AdaptiveMaps, FewerStepsThanThePapersPlannerBeforeAndAfterAChange) {
    const Totals adaptive = run_chain(AdaptiveParams<>{}, "open64", "soft47");
    const Totals paper = run_chain(SspqlParams<>::with_bonus(), "open64", "soft47");
    EXPECT_LE(adaptive.before, 0.9 * paper.before) << "measured 0.81";
    EXPECT_LE(adaptive.after, 0.85 * paper.after);
    EXPECT_LE(adaptive.touches, 60.0);
    const Totals nest = run_chain(AdaptiveParams<>{}, "nest54", "nest47");
    EXPECT_LE(nest.after, 700.0);
    EXPECT_LE(nest.touches, 60.0);
}

// Sutton and Barto's: at step 1000 the short way is closed; the long one takes 16 steps, 125 goals in 2000 steps.
TEST(AdaptiveMaps, ABlockedWayIsLeftForAnother) {
    const GridTask task = grid_task("blocking-maze");
    double late = 0.0;
    constexpr std::uint64_t seeds = 10;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        auto world = task.changing_world();
        Agent robot(EnumState<StateId>(world.size()), EnumActions<Move>(4), AdaptiveParams<>{}, seed);
        std::uint64_t episode = 0;
        std::size_t since = 0;
        while (world.steps() < 3000) {
            const auto result = run_episode(world, robot, seed * 1000 + episode++);
            if (world.steps() > 1500) since += result.terminated ? 1u : 0u;
        }
        EXPECT_GE(since, 85u) << "seed " << seed << "; 93 at best";
        late += static_cast<double>(since) / seeds;
    }
    EXPECT_GE(late, 88.0);
}

// As large as the pusher's tasks: some thousand states, eight actions.
TEST(AdaptiveMaps, PlanningIsCheapForManyActionsToo) {
    RandomMdpParams process;
    process.states = 2000;
    process.actions = 8;
    process.branching = 2;
    const TransitionTable table = random_mdp(process, 1);
    AdaptiveSspql<> learner(table.states(), table.actions(), {}, 1);
    TimeLimit world(TabularEnvironment(table), 500);
    for (std::uint64_t k = 0; learner.status().steps < 20000; ++k) (void)run_episode(world, learner, k);
    const AdaptiveStatus status = learner.status();
    EXPECT_LE(static_cast<double>(status.edge_touches) / static_cast<double>(status.steps), 60.0);
}

TEST(AdaptiveMapsSlow, TheShortestPathBoundsExplorationOfLargeMaps) {
    AdaptiveParams<> unbounded;
    unbounded.bound_by_paths = false;
    double with = 0.0, without = 0.0;
    for (std::uint64_t number = 1; number <= 3; ++number) {
        double touches = 0.0;
        with += large_map({}, number, number, &touches);
        EXPECT_LE(touches, 60.0) << "map " << number;
        without += large_map(unbounded, number, number);
    }
    EXPECT_GE(without, 2.0 * with) << "measured 3.1; " << with << " steps with the bound";
}

}  // namespace sspql_adaptive_maps_test
