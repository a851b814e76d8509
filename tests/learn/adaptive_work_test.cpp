// SPDX-License-Identifier: MIT
// A robot's control loop cannot wait: no call touches more edges than a slice and one piece of work more, also when the
// first goal is found, new goals are told or the world changes.
#include <sspql/learn/adaptive_sspql.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <gtest/gtest.h>

#include <sspql/env/grid_world.hpp>
#include <sspql/env/random_walls.hpp>

namespace sspql_adaptive_work_test {

using namespace sspql;

namespace {

/// The edges out of 200 states whose paths are due: five neighbours on a grid, four actions. And those of the state the
/// call is about, in and out.
constexpr std::uint64_t piece = 200 * 5 * 4 + 200;

struct Work {
    std::uint64_t worst = 0;  ///< of a call
    std::uint64_t all = 0;
    std::size_t steps = 0;
};

GridWorld large(std::size_t size, std::uint64_t number) {
    GridWorldParams params;
    params.slip = 0.1;
    return GridWorld(random_walls(size, 0.2, number), params);
}

/// f(), and what it touched.
template <class F>
void measure(const AdaptiveSspql<>& learner, Work& work, const F& f) {
    const std::uint64_t before = learner.status().edge_touches;
    f();
    const std::uint64_t touched = learner.status().edge_touches - before;
    work.worst = std::max(work.worst, touched);
    work.all += touched;
}

/// Episodes of up to `most` steps until so many steps were made in all.
void live(GridWorld& world, AdaptiveSspql<>& learner, std::size_t steps, Work& work, StateId goal = no_state) {
    for (std::uint64_t seed = work.steps; work.steps < steps; ++seed) {
        StateId s = world.reset(seed);
        while (s == goal) s = world.reset(++seed + 1000000);
        ActionId a = learner.begin(s);
        for (bool done = false; !done;) {
            const auto step = world.step(static_cast<Move>(index(a)));
            ++work.steps;
            done = step.terminated || step.observation == goal || work.steps >= steps;
            measure(learner, work, [&] {
                if (done) {
                    learner.end(step.reward, step.observation, step.terminated || step.observation == goal);
                } else {
                    a = learner.step(step.reward, step.observation);
                }
            });
        }
    }
}

std::uint64_t bound(const AdaptiveParams<>& params) { return params.slice + piece; }

}  // namespace

TEST(AdaptiveWorkSlow, NoStepOnALargeMapExceedsItsBound) {
    for (std::uint64_t number = 1; number <= 3; ++number) {
        GridWorld world = large(100, number);
        const AdaptiveParams<> params;
        AdaptiveSspql<> learner(world.size(), 4, params, number);
        Work work;
        live(world, learner, 80000, work);
        ASSERT_TRUE(learner.status().goal_known) << "map " << number;
        EXPECT_LE(work.worst, bound(params)) << "map " << number;
        EXPECT_LE(static_cast<double>(work.all) / static_cast<double>(work.steps), 60.0) << "map " << number;
    }
}

TEST(AdaptiveWork, NorWithSmallSlices) {
    AdaptiveParams<> params;
    params.budget = StepBudget(40, 400);
    params.slice = 300;
    GridWorld world = large(30, 1);
    AdaptiveSspql<> learner(world.size(), 4, params, 1);
    Work work;
    live(world, learner, 15000, work);
    ASSERT_TRUE(learner.status().goal_known);
    EXPECT_LE(work.worst, bound(params));
    EXPECT_LE(static_cast<double>(work.all) / static_cast<double>(work.steps), 60.0);
    EXPECT_GE(static_cast<double>(work.all) / static_cast<double>(work.steps), 5.0) << "and it does plan";
}

TEST(AdaptiveWork, NorDoToldGoals) {
    const AdaptiveParams<> params;
    GridWorld world = large(60, 1);
    AdaptiveSspql<> learner(world.size(), 4, params, 1);
    Work work;
    live(world, learner, 25000, work);
    StateId other = world.map().starts().front();
    measure(learner, work, [&] { learner.set_goals({{other}}); });
    live(world, learner, 27000, work, other);
    measure(learner, work, [&] { learner.set_goals({}); });
    live(world, learner, 29000, work);
    EXPECT_LE(work.worst, bound(params));
}

TEST(AdaptiveWork, NorChangesOfTheWorld) {
    const AdaptiveParams<> params;
    GridWorld world = large(40, 1);
    AdaptiveSspql<> learner(world.size(), 4, params, 1);
    Work work;
    live(world, learner, 12000, work);
    for (std::uint64_t number = 2; number <= 4; ++number) {
        world.set_map(large(40, number).map());
        live(world, learner, 12000 + 3000 * number, work);
    }
    EXPECT_GE(learner.status().alarms, 20u);
    EXPECT_LE(work.worst, bound(params));
}

}  // namespace sspql_adaptive_work_test
