// SPDX-License-Identifier: MIT
// Sspql's two ways to plan for less: a tolerance for costs, and a budget per step.
#include <sspql/learn/sspql.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/paths/reverse_graph.hpp>

namespace sspql_sspql_path_budget_test {

using namespace sspql;

namespace {

constexpr std::size_t side = 8;
constexpr std::size_t states = side * side;

SspqlParams<> with(double tolerance, std::uint64_t budget) {
    SspqlParams<> params;
    params.path_tolerance = tolerance;
    params.path_budget = budget;
    return params;
}

/// One episode on a grid, one move in ten slips; the last state is the goal. \returns the steps.
std::size_t episode(Sspql<>& learner, Random& world) {
    std::size_t s = world.below(states - 1);
    ActionId a = learner.begin(state_id(s));
    for (std::size_t steps = 1;; ++steps) {
        const std::size_t d = world.chance(0.1) ? world.below(4) : index(a);
        if (d == 0 && s >= side) s -= side;
        if (d == 1 && s + side < states) s += side;
        if (d == 2 && s % side != 0) s -= 1;
        if (d == 3 && s % side != side - 1) s += 1;
        if (s == states - 1) {
            learner.end(1.0, state_id(s), true);
            return steps;
        }
        a = learner.step(0.0, state_id(s));
    }
}

std::size_t late_steps(Sspql<>& learner, std::uint64_t seed) {
    Random world(seed);
    std::size_t late = 0;
    for (int i = 0; i < 150; ++i) {
        const std::size_t steps = episode(learner, world);
        if (i >= 100) late += steps;
    }
    return late;
}

}  // namespace

TEST(SspqlPathBudget, WithoutOneThePathsAreThoseOfASolveFromScratch) {
    Sspql<> learner(states, 4, {}, 3);
    Random world(3);
    for (int i = 0; i < 100; ++i) {
        episode(learner, world);
        ReverseGraph graph;
        graph.assign(learner.counts());
        const ShortestPathTree fresh = shortest_paths_to(graph, learner.goals());
        ASSERT_EQ(learner.tree().distance, fresh.distance) << i;
        ASSERT_EQ(learner.tree().next, fresh.next) << i;
        SspValues values;
        values.assign(learner.counts(), fresh, learner.legal_actions());
        for (std::size_t s = 0; s < states; ++s) {
            for (std::size_t a = 0; a < 4; ++a) {
                ASSERT_EQ(learner.ssp_values()(state_id(s), action_id(a)), values(state_id(s), action_id(a)));
            }
        }
    }
}

TEST(SspqlPathBudget, LearnsAboutAsWellWithEither) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
        Sspql<> whole(states, 4, {}, seed);
        Sspql<> tolerant(states, 4, with(0.05, 0), seed);
        Sspql<> budgeted(states, 4, with(0.0, 50), seed);
        const std::size_t steps = late_steps(whole, seed);
        EXPECT_LT(late_steps(tolerant, seed), 2 * steps);
        EXPECT_LT(late_steps(budgeted, seed), 2 * steps);
        EXPECT_LT(tolerant.model_operations(), whole.model_operations());
    }
}

TEST(SspqlPathBudget, NoStepTouchesMoreThanTheBudgetAndAState) {
    constexpr std::uint64_t budget = 12;
    Sspql<> learner(states, 4, with(0.0, budget), 1);
    Random world(1);
    std::size_t changes = 0;
    ShortestPathTree in_use = learner.tree();
    for (int i = 0; i < 4000; ++i) {
        const std::uint64_t before = learner.model_operations();
        const std::size_t s = world.below(states - 1);
        const std::size_t next = world.chance(0.5) ? s + 1 : s >= side ? s - side : s;
        learner.observe(state_id(s), action_id(world.below(4)), next == states - 1 ? 1.0 : 0.0, state_id(next),
                        next == states - 1);
        ASSERT_LE(learner.model_operations() - before, 1 + budget + 10) << "9 is the most a state has, i " << i;
        changes += learner.tree().distance != in_use.distance ? 1 : 0;
        in_use = learner.tree();
    }
    EXPECT_GT(changes, 5u);
    EXPECT_TRUE(learner.tree().reaches_goal(state_id(0)));
}

// An episode's end only begins: the paths come some steps later.
TEST(SspqlPathBudget, PathsComeLater) {
    Sspql<> learner(4, 2, with(0.0, 5), 1);
    learner.observe(state_id(0), action_id(1), 0.0, state_id(1), false);
    learner.observe(state_id(1), action_id(1), 1.0, state_id(2), true);
    EXPECT_FALSE(learner.tree().reaches_goal(state_id(0)));
    int steps = 0;
    while (!learner.tree().reaches_goal(state_id(0)) && ++steps < 100) {
        learner.observe(state_id(3), action_id(0), 0.0, state_id(3), false);
    }
    EXPECT_GT(steps, 2);
    EXPECT_LT(steps, 20);
    EXPECT_EQ(learner.ssp_values().action(state_id(0)), action_id(1));
}

TEST(SspqlPathBudget, SetGoalsAndUpdatePathsAreWhole) {
    Sspql<> learner(4, 2, with(0.0, 1), 1);
    for (std::size_t s = 0; s < 3; ++s) {
        learner.observe(state_id(s), action_id(1), 0.0, state_id(s + 1), false);
        learner.observe(state_id(s + 1), action_id(0), 0.0, state_id(s), false);
    }
    learner.set_goals({{state_id(3)}});
    EXPECT_EQ(learner.best(state_id(0)), action_id(1));
    learner.set_goals({{state_id(0)}});
    EXPECT_EQ(learner.best(state_id(2)), action_id(0));
    learner.observe(state_id(3), action_id(1), 0.0, state_id(0), true);
    EXPECT_EQ(learner.tree().next[3], state_id(2));
    learner.update_paths();
    EXPECT_EQ(learner.tree().next[3], state_id(0));
}

TEST(SspqlPathBudget, RefusesWhatMakesNoSense) {
    EXPECT_THROW(Sspql<>(4, 2, with(-0.1, 0)), std::invalid_argument);
    EXPECT_THROW(Sspql<>(4, 2, with(0.6, 0)), std::invalid_argument);
    EXPECT_THROW(Sspql<>(4, 2, with(std::numeric_limits<double>::quiet_NaN(), 0)), std::invalid_argument);
    EXPECT_THROW(Sspql<>(4, 2, with(0.0, ~std::uint64_t{0})), std::invalid_argument);
}

}  // namespace sspql_sspql_path_budget_test
