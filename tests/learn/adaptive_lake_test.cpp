// SPDX-License-Identifier: MIT
// A frozen lake: two steps in three go to a side, holes end the episode, nothing ever changes. The success of an agent
// that takes noise for change again and again is poor; what keeps AdaptiveSspql from it is the floor of its alarms.
#include <sspql/learn/adaptive_sspql.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/env/grid_world.hpp>
#include <sspql/env/time_limit.hpp>
#include <sspql/learn/agent.hpp>
#include <sspql/learn/exact_values.hpp>
#include <sspql/run/episode.hpp>
#include <sspql/spaces/enum_state.hpp>

namespace sspql_adaptive_lake_test {

using namespace sspql;

namespace {

constexpr std::size_t limit = 200;

GridWorld lake(const char* map) {
    GridWorldParams params;
    params.slip = 2.0 / 3.0;
    params.slip_kind = SlipKind::perpendicular;
    return GridWorld(GridMap::parse(map), params);
}

constexpr const char* lakes[] = {
    "S.......\n"
    ".H....H.\n"
    "....H...\n"
    "..H.....\n"
    ".....H..\n"
    "H..H....\n"
    ".......H\n"
    ".H..H..G\n",
    "S...H...\n"
    "........\n"
    ".H..H...\n"
    "........\n"
    "...H..H.\n"
    ".H......\n"
    ".....H..\n"
    "H..H...G\n"};

/// The greatest probability of reaching the goal within the limit, whatever the policy does with the time that is left.
double optimum(const TransitionTable& table) {
    std::vector<double> success(table.states(), 0.0);
    for (std::size_t left = 1; left <= limit; ++left) {
        std::vector<double> before = success;
        for (std::size_t s = 0; s < table.states(); ++s) {
            if (!table.has_actions(state_id(s))) continue;
            double best = 0.0;
            for (std::size_t a = 0; a < table.actions(); ++a) {
                best = std::max(best, action_value(table, before, 1.0, state_id(s), action_id(a)));
            }
            success[s] = best;  // rewards are 1 at the goal and 0 else
        }
    }
    return mean_over_starts(table, success);
}

/// Part of the last 500 of 2000 episodes that reached the goal, mean of four seeds.
double late_success(const GridWorld& world, const AdaptiveParams<>& params) {
    constexpr std::uint64_t seeds = 4;
    double success = 0.0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        TimeLimit limited(world, limit);
        Agent robot(EnumState<StateId>(world.size()), EnumActions<Move>(4), params, seed);
        (void)run_episodes(limited, robot, 1500, seed * 100000);
        for (const auto& e : run_episodes(limited, robot, 500, seed * 100000 + 1500)) {
            success += e.last_reward / (500.0 * seeds);
        }
    }
    return success;
}

}  // namespace

TEST(AdaptiveLakeSlow, LateSuccessIsWithinFivePercentOfTheOptimum) {
    for (const char* map : lakes) {
        const GridWorld world = lake(map);
        const double best = optimum(world.table());
        EXPECT_NEAR(best, 0.871, 0.002);
        EXPECT_GE(late_success(world, {}), 0.95 * best);
    }
}

TEST(AdaptiveLakeSlow, WithoutTheFloorOfAlarmsItIsNot) {
    AdaptiveParams<> params;
    params.change.threshold = 0.0;
    params.change.log_offset = 100.0;
    const GridWorld world = lake(lakes[0]);
    EXPECT_LE(late_success(world, params), 0.75 * optimum(world.table()));
}

}  // namespace sspql_adaptive_lake_test
