// SPDX-License-Identifier: MIT
// Goals that are told to AdaptiveSspql, others later, and back to those that rewards discover.
#include <sspql/learn/adaptive_sspql.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "learn/learner_testing.hpp"

#include <sspql/env/grid_maps.hpp>

namespace sspql_adaptive_goals_test {

using namespace sspql;
using namespace sspql::testing;

namespace {

constexpr ActionId east{0}, west{1};

/// A learner that knows the room, but no goal.
AdaptiveSspql<> guest(std::uint64_t seed, AdaptiveParams<> params = {}) {
    AdaptiveSspql<> learner(Room::states, Room::actions, params, seed);
    for (int k = 0; k < 3; ++k) show_room(learner);
    return learner;
}

/// Steps of an episode that ends in `to`, and pays nothing.
std::size_t steps(AdaptiveSspql<>& learner, StateId from, StateId to) {
    std::size_t n = 1;
    StateId s = Room::moved(from, learner.begin(from));
    for (; s != to && n < 1000; ++n) s = Room::moved(s, learner.step(0.0, s));
    learner.end(0.0, s, s == to);
    return n;
}

std::size_t distance(StateId s, StateId to) {
    const auto apart = [](std::size_t a, std::size_t b) { return a < b ? b - a : a - b; };
    return apart(index(s) % 5, index(to) % 5) + apart(index(s) / 5, index(to) / 5);
}

}  // namespace

TEST(AdaptiveGoals, ANewGoalIsReachedTheShortestWayAtOnce) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        AdaptiveSspql<> learner = guest(seed);
        for (const StateId goal : {Room::at(4, 4), Room::at(4, 0), Room::at(2, 1), Room::at(0, 4)}) {
            learner.set_goals({{goal}});
            for (const StateId from : {Room::at(0, 0), Room::at(4, 3), Room::at(1, 4)}) {
                EXPECT_EQ(steps(learner, from, goal), distance(from, goal)) << "seed " << seed;
            }
        }
    }
}

TEST(AdaptiveGoals, PathsToAToldGoalAreKnownAtOnce) {
    AdaptiveSspql<> learner = guest(1);
    for (const StateId goal : {Room::at(4, 4), Room::at(1, 3)}) {
        learner.set_goals({{goal}});
        for (std::size_t s = 0; s < Room::states; ++s) {
            if (state_id(s) == goal) continue;
            EXPECT_EQ(learner.path_length(state_id(s)), static_cast<double>(distance(state_id(s), goal))) << s;
        }
    }
}

TEST(AdaptiveGoals, ThePlanForANewGoalIsSpreadOverSteps) {
    AdaptiveParams<> params;
    params.slice = 50;
    AdaptiveSspql<> learner = guest(2, params);
    learner.set_goals({{Room::at(4, 4)}});
    std::size_t last = 0;
    for (int k = 0; k < 30; ++k) last = steps(learner, Room::at(0, 0), Room::at(4, 4));
    EXPECT_EQ(last, 8u);
    learner.set_goals({{Room::at(0, 4)}});
    learner.set_goals({{Room::at(4, 0)}});  // before the plan for the other one is ready
    for (int k = 0; k < 30; ++k) last = steps(learner, Room::at(0, 0), Room::at(4, 0));
    EXPECT_EQ(last, 4u);
    EXPECT_EQ(learner.path_length(Room::at(0, 0)), 4.0);
}

TEST(AdaptiveGoals, TheBetterOfTwoGoalsWithinReachIsTaken) {
    AdaptiveSspql<> learner = guest(3);
    const StateId near = Room::at(2, 0), far = Room::at(0, 4);
    const auto reached = [&](StateId from) {
        StateId s = Room::moved(from, learner.begin(from));
        for (int n = 0; s != near && s != far && n < 100; ++n) s = Room::moved(s, learner.step(0.0, s));
        learner.end(0.0, s, true);
        return s;
    };
    learner.set_goals({{far}, {near}});
    EXPECT_EQ(reached(Room::at(0, 0)), near) << "2 steps, not 4";
    EXPECT_EQ(reached(Room::at(0, 3)), far);
    learner.set_goals({{far}, {near, 1.0}});
    EXPECT_EQ(reached(Room::at(0, 0)), near) << "2 + 1 steps, not 4";
    learner.set_goals({{far}, {near, 5.0}});
    EXPECT_EQ(reached(Room::at(0, 0)), far) << "4 steps, not 2 + 5";
    learner.set_goals({{far, 9.0}, {near, 2.0}});
    EXPECT_EQ(reached(Room::at(0, 1)), near);
}

TEST(AdaptiveGoals, ANewGoalDuringAnEpisodeTurnsItRound) {
    AdaptiveSspql<> learner = guest(4);
    learner.set_goals({{Room::at(4, 0)}});
    EXPECT_EQ(learner.begin(Room::at(0, 0)), east);
    EXPECT_EQ(learner.step(0.0, Room::at(1, 0)), east);
    learner.set_goals({{Room::at(0, 0)}});
    EXPECT_TRUE(learner.running());
    EXPECT_EQ(learner.step(0.0, Room::at(2, 0)), west);
}

TEST(AdaptiveGoals, AnEmptyListGoesBackToTheGoalsRewardsDiscovered) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        AdaptiveSspql<> learner(Room::states, Room::actions, {}, seed);
        Room room(seed);
        for (int k = 0; k < 15; ++k) (void)walk(learner, room, Room::at(0, 0), Room::at(4, 4));
        learner.set_goals({{Room::at(0, 4)}});
        for (int k = 0; k < 10; ++k) (void)steps(learner, Room::at(0, 0), Room::at(0, 4));
        EXPECT_LE(steps(learner, Room::at(0, 0), Room::at(0, 4)), 5u);
        learner.set_goals({});
        EXPECT_LE(walk(learner, room, Room::at(0, 0), Room::at(4, 4)).size(), 10u) << "seed " << seed;
    }
}

TEST(AdaptiveGoals, WhatWasToldHoldsNoLongerThanTold) {
    AdaptiveSspql<> learner = guest(6);  // no reward ever
    const auto spread = [&] { return learner.state_value(Room::at(3, 4)) - learner.state_value(Room::at(0, 0)); };
    EXPECT_NEAR(spread(), 0.0, 0.03);
    learner.set_goals({{Room::at(4, 4)}});
    EXPECT_NEAR(spread(), 1.0 - std::pow(0.99, 7.0), 0.01) << "seven steps";
    for (int k = 0; k < 3; ++k) (void)steps(learner, Room::at(0, 0), Room::at(4, 4));
    learner.set_goals({});
    EXPECT_FALSE(learner.status().goal_known);
    EXPECT_NEAR(spread(), 0.0, 0.03) << "nothing draws it there any more";
}

TEST(AdaptiveGoals, RewardsForOtherEndsCountNoMoreButHazardsDo) {
    AdaptiveSspql<> learner(4, 3, {}, 7);
    for (int k = 0; k < 10; ++k) {
        learner.observe(state_id(0), action_id(0), 1.0, state_id(1), true);   // pays
        learner.observe(state_id(0), action_id(1), 0.0, state_id(2), true);   // what will be told
        learner.observe(state_id(0), action_id(2), -1.0, state_id(3), true);  // hurts
    }
    EXPECT_EQ(learner.best(state_id(0)), action_id(0));
    learner.set_goals({{state_id(2)}});
    EXPECT_EQ(learner.best(state_id(0)), action_id(1));
    EXPECT_LT(learner.q()(state_id(0), action_id(0)), 0.1);
    EXPECT_LT(learner.q()(state_id(0), action_id(2)), -0.5);
    learner.set_goals({{state_id(3)}});
    EXPECT_EQ(learner.best(state_id(0)), action_id(2)) << "a goal is what is told";
    learner.set_goals({});
    EXPECT_EQ(learner.best(state_id(0)), action_id(0));
    EXPECT_LT(learner.q()(state_id(0), action_id(2)), -0.5);
}

// The map is learnt on the way to one corner; then the other corner is told.
TEST(AdaptiveGoals, AnotherCornerOfAMapIsReachedWithoutRelearning) {
    const GridMap map = grid_task("soft54").map;
    const StateId corner = map.state(7, 0);
    double sum = 0.0;
    constexpr std::uint64_t seeds = 20;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        GridWorld world(map, {0.1});
        AdaptiveSspql<> learner(world.size(), 4, {}, seed);
        for (std::uint64_t k = 0; k < 60; ++k) {
            ActionId a = learner.begin(world.reset(seed * 1000 + k));
            for (;;) {
                const auto step = world.step(static_cast<Move>(index(a)));
                if (step.terminated) {
                    learner.end(step.reward, step.observation, true);
                    break;
                }
                a = learner.step(step.reward, step.observation);
            }
        }
        learner.set_goals({{corner}});
        StateId s = world.reset(seed);
        while (s == corner) s = world.reset(seed + 100);
        ActionId a = learner.begin(s);
        for (int n = 1; n <= 2000; ++n) {
            const auto step = world.step(static_cast<Move>(index(a)));
            sum += 1.0;
            if (step.observation == corner || step.terminated) {
                learner.end(0.0, step.observation, true);
                break;
            }
            a = learner.step(0.0, step.observation);
        }
    }
    EXPECT_LE(sum / seeds, 16.0) << "about 8 at best";
}

}  // namespace sspql_adaptive_goals_test
