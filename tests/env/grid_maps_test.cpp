// SPDX-License-Identifier: MIT
#include <sspql/env/grid_maps.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/learn/exact_steps.hpp>
#include <sspql/learn/exact_values.hpp>

using sspql::grid_task;
using sspql::GridCell;
using sspql::GridMap;
using sspql::GridTask;
using sspql::state_id;

namespace {

std::size_t count(const GridMap& map, GridCell cell) {
    std::size_t n = 0;
    for (std::size_t s = 0; s < map.size(); ++s) n += map.cell(state_id(s)) == cell ? 1u : 0u;
    return n;
}

}  // namespace

// Expected steps by value iteration of another implementation, to 3 digits, for each map and 10 % slips to one of the
// three other directions; they hold for no other walls.
TEST(GridMaps, HaveTheirOptimalSteps) {
    const std::vector<std::pair<const char*, double>> expected{
        {"open64", 8.248}, {"soft54", 8.402}, {"soft47", 8.605}, {"nest54", 9.953}, {"nest47", 12.486}};
    for (const auto& [name, steps] : expected) {
        const sspql::TransitionTable table = grid_task(name).world().table();
        EXPECT_NEAR(*sspql::optimal_steps(table), steps, 5e-4) << name;
        EXPECT_NEAR(*sspql::optimal_return(table), 1.0, 1e-9) << name;
    }
}

TEST(GridMaps, HaveTheirSizes) {
    const std::vector<std::pair<const char*, std::size_t>> expected{
        {"open64", 64}, {"soft54", 54}, {"soft47", 47}, {"nest54", 54}, {"nest47", 47}};
    for (const auto& [name, cells] : expected) {
        const GridTask task = grid_task(name);
        EXPECT_EQ(task.map.rows(), 8u) << name;
        EXPECT_EQ(task.map.columns(), 8u) << name;
        EXPECT_EQ(count(task.map, GridCell::free) + 1, cells) << name;  // the goal counts as free
        EXPECT_EQ(task.map.goals(), std::vector<sspql::StateId>{task.map.state(7, 7)}) << name;
        EXPECT_EQ(task.map.starts().size(), cells - 1) << name;
        EXPECT_EQ(task.params.slip, 0.1) << name;
        EXPECT_EQ(task.total_steps, 0u) << name;
    }
}

TEST(GridMaps, ChainsOnlyAddWalls) {
    const std::vector<std::pair<const char*, const char*>> chains{
        {"open64", "soft54"}, {"soft54", "soft47"}, {"open64", "nest54"}, {"nest54", "nest47"}};
    for (const auto& [before, after] : chains) {
        const GridMap a = grid_task(before).map;
        const GridMap b = grid_task(after).map;
        for (std::size_t s = 0; s < a.size(); ++s) {
            if (a.cell(state_id(s)) == GridCell::wall) {
                EXPECT_EQ(b.cell(state_id(s)), GridCell::wall) << before << " " << after << " " << s;
            }
        }
    }
}

// Sutton and Barto (2018): 14 steps is the shortest path of Fig. 8.2; examples 8.2 and 8.3 have one of 10 steps by the
// right end of the wall (5 right, 5 up) and one of 16 by its left end (3 left, 5 up, 8 right).
TEST(GridMaps, TheBooksMazesHaveTheirShortestPaths) {
    const auto steps = [](const GridMap& map) {
        return *sspql::optimal_steps(sspql::GridWorld(map, grid_task("dyna-maze").params).table());
    };
    const GridTask dyna = grid_task("dyna-maze");
    EXPECT_EQ(dyna.params.slip, 0.0);
    EXPECT_EQ(count(dyna.map, GridCell::wall), 7u);
    EXPECT_DOUBLE_EQ(steps(dyna.map), 14.0);
    EXPECT_TRUE(dyna.changes.empty());

    const GridTask blocking = grid_task("blocking-maze");
    ASSERT_EQ(blocking.changes.size(), 1u);
    EXPECT_EQ(blocking.changes[0].from_step, 1000u);
    EXPECT_EQ(blocking.total_steps, 3000u);
    EXPECT_DOUBLE_EQ(steps(blocking.map), 10.0);
    EXPECT_DOUBLE_EQ(steps(blocking.changes[0].map), 16.0);

    const GridTask shortcut = grid_task("shortcut-maze");
    ASSERT_EQ(shortcut.changes.size(), 1u);
    EXPECT_EQ(shortcut.changes[0].from_step, 3000u);
    EXPECT_EQ(shortcut.total_steps, 6000u);
    EXPECT_DOUBLE_EQ(steps(shortcut.map), 16.0);
    EXPECT_DOUBLE_EQ(steps(shortcut.changes[0].map), 10.0);
}

// Example 6.6: up, 11 right, down = 13 steps at -1, the last one into the goal.
TEST(GridMaps, TheCliffsOptimumIsMinus13) {
    const GridTask task = grid_task("cliff");
    const sspql::TransitionTable table = task.world().table();
    EXPECT_NEAR(*sspql::optimal_return(table), -13.0, 1e-9);
    EXPECT_DOUBLE_EQ(*sspql::optimal_steps(table), 13.0);
    EXPECT_TRUE(table.is_success(-1.0));

    sspql::GridWorld world = task.world();
    EXPECT_EQ(world.reset(1), task.map.state(3, 0));
    const auto fall = world.step(sspql::Move::right);
    EXPECT_EQ(fall.observation, task.map.state(3, 0));
    EXPECT_EQ(fall.reward, -100.0);
    EXPECT_FALSE(fall.terminated);
    EXPECT_EQ(world.step(sspql::Move::up).reward, -1.0);
    for (int i = 0; i < 11; ++i) EXPECT_EQ(world.step(sspql::Move::right).reward, -1.0);
    const auto end = world.step(sspql::Move::down);
    EXPECT_EQ(end.reward, -1.0);
    EXPECT_TRUE(end.terminated);
}

TEST(GridMaps, AreFoundByNameOnly) {
    const std::vector<std::string> names{"open64",    "soft54",        "soft47",        "nest54", "nest47",
                                         "dyna-maze", "blocking-maze", "shortcut-maze", "cliff"};
    EXPECT_EQ(sspql::grid_task_names(), names);
    for (const std::string& name : names) EXPECT_EQ(grid_task(name).name, name);
    EXPECT_FALSE(sspql::find_grid_task("open").has_value());
    try {
        (void)grid_task("open");
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(),
                     "map must be one of open64, soft54, soft47, nest54, nest47, dyna-maze, blocking-maze, "
                     "shortcut-maze, cliff, or walls60 and the like, got open");
    }
}
