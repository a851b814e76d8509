// SPDX-License-Identifier: MIT
#include <sspql/paths/path_solver.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/paths/cost.hpp>
#include <sspql/paths/dary_heap.hpp>

#include "paths/learnt_grid.hpp"

using namespace sspql;
using namespace sspql::testing;

namespace {

template <class Cost = RiskWeighted>
using Solver = PathSolver<Cost, SumOverActions, DaryHeap<4>>;

constexpr ActionId a0{0};
constexpr StateId s0{0}, s1{1}, s2{2}, s3{3};

}  // namespace

TEST(PathSolver, NothingChangedTouchesNoEdge) {
    auto counts = learnt_grid<CountCell>(20);
    Solver<> solver;
    const std::vector<Goal> goals{{state_id(210), 0.0}};
    EXPECT_EQ(solver.solve(counts, goals), Solved::searched);
    expect_solved(solver.tree(), counts, goals);
    const std::uint64_t edges = solver.edges_touched();
    EXPECT_EQ(edges, 3 * counts.pairs()) << "each edge refreshed, copied and looked at";
    EXPECT_EQ(solver.solve(counts, goals), Solved::unchanged);
    EXPECT_EQ(solver.edges_touched(), edges);
    EXPECT_TRUE(solver.changed_states().empty());
}

// In a world without chance a second look brings nothing new: the state's edges are refreshed, no more.
TEST(PathSolver, ARecordThatChangesNoCostIsNoReasonToSolve) {
    TransitionCounts<CountCell> counts(100, 2);
    for (std::size_t s = 0; s + 1 < 100; ++s) counts.record(state_id(s), a0, state_id(s + 1));
    Solver<> solver;
    const std::vector<Goal> goals{{state_id(99), 0.0}};
    solver.solve(counts, goals);
    counts.record(state_id(50), a0, state_id(51));
    const std::uint64_t edges = solver.edges_touched();
    EXPECT_EQ(solver.solve(counts, goals), Solved::unchanged);
    EXPECT_EQ(solver.edges_touched(), edges + 1);
    EXPECT_EQ(solver.changes().states(), std::vector<StateId>{state_id(50)});
}

TEST(PathSolver, NewStatesWithoutAPathAreNoReasonToSolve) {
    auto counts = learnt_grid<CountCell>(10);
    Solver<> solver;
    const std::vector<Goal> goals{{s0, 0.0}};
    solver.solve(counts, goals);
    counts.grow(105);
    EXPECT_EQ(solver.solve(counts, goals), Solved::unchanged);
    EXPECT_EQ(solver.tree().size(), 105u);
    EXPECT_FALSE(solver.tree().reaches_goal(state_id(104)));
    counts.record(state_id(104), a0, state_id(57));
    EXPECT_EQ(solver.solve(counts, goals), Solved::repaired);
    EXPECT_EQ(solver.tree().next[104], state_id(57));
    expect_solved(solver.tree(), counts, goals);
}

TEST(PathSolver, ALocalChangeTouchesFewEdges) {
    auto counts = learnt_grid<CountCell>(100);
    Solver<> solver;
    const std::vector<Goal> goals{{s0, 0.0}};
    solver.solve(counts, goals);
    Random random(3);
    for (int round = 0; round < 20; ++round) {
        const StateId corner = state_id(9000 + 100 * random.below(9) + random.below(90));
        for (std::size_t i = 0; i < 5; ++i) counts.record(corner, action_id(i % 4), corner);
        const std::uint64_t before = solver.edges_touched();
        EXPECT_EQ(solver.solve(counts, goals), Solved::repaired);
        EXPECT_LE(solver.edges_touched() - before, counts.pairs() / 100);
        expect_solved(solver.tree(), counts, goals);
    }
}

TEST(PathSolver, WhereMostPathsAreLostASearchIsMade) {
    // A star of chains: the edge next to the goal carries everything.
    TransitionCounts<CountCell> counts(1000, 1);
    for (std::size_t s = 1; s < 1000; ++s) counts.record(state_id(s), a0, state_id(s <= 2 ? s - 1 : s <= 100 ? 1 : 2));
    Solver<> solver;
    const std::vector<Goal> goals{{s0, 0.0}};
    solver.solve(counts, goals);
    counts.record(state_id(50), a0, state_id(50));
    EXPECT_EQ(solver.solve(counts, goals), Solved::repaired);
    counts.record(s1, a0, s1);
    const std::uint64_t before = solver.edges_touched();
    EXPECT_EQ(solver.solve(counts, goals), Solved::searched);
    EXPECT_LE(solver.edges_touched() - before, 4 * counts.pairs()) << "a marking given up, and a search";
    expect_solved(solver.tree(), counts, goals);
}

TEST(PathSolver, OtherGoalsMeanASearch) {
    auto counts = learnt_grid<CountCell>(10);
    Solver<> solver;
    for (const std::vector<Goal>& goals :
         {std::vector<Goal>{{s0, 0.0}}, {{s0, 0.5}}, {{s1, 0.5}}, {{s1, 0.5}, {state_id(99), 0.0}}, {}}) {
        EXPECT_EQ(solver.solve(counts, goals), Solved::searched);
        expect_solved(solver.tree(), counts, goals);
        EXPECT_EQ(solver.solve(counts, goals), Solved::unchanged);
    }
}

TEST(PathSolver, ARefusedGoalChangesNothing) {
    auto counts = learnt_grid<CountCell>(5);
    Solver<> solver;
    solver.solve(counts, {{s0, 0.0}});
    counts.record(s2, a0, s3);
    EXPECT_THROW(solver.solve(counts, {{state_id(25), 0.0}}), std::invalid_argument);
    EXPECT_THROW(solver.solve(counts, {{s0, -1.0}}), std::invalid_argument);
    EXPECT_EQ(counts.dirty().size(), 1u);
    EXPECT_NE(solver.solve(counts, {{s0, 0.0}}), Solved::searched);
}

// Erased and seen again between two solves: the label is gone, the number of pairs is the same.
TEST(PathSolver, ErasedEdgesAreNoticed) {
    TransitionCounts<FadingCell> counts(300, 2);
    for (std::size_t s = 1; s < 300; ++s) {
        counts.record(state_id(s), a0, state_id(s / 2));
        counts.record(state_id(s), action_id(1), state_id(s - 1));
    }
    Solver<> solver;
    const std::vector<Goal> goals{{s0, 0.0}};
    solver.solve(counts, goals);
    EXPECT_EQ(solver.tree().next[200], state_id(100));
    counts.fade(state_id(200), a0, 0.0, 0.5);
    EXPECT_EQ(solver.solve(counts, goals), Solved::repaired);
    EXPECT_EQ(solver.tree().next[200], state_id(199));
    expect_solved(solver.tree(), counts, goals);

    counts.fade(state_id(150), a0, 0.0, 0.5);
    counts.record(state_id(150), a0, state_id(75), false, 0.0, 3.0);
    counts.record(state_id(150), a0, state_id(3));
    EXPECT_EQ(solver.solve(counts, goals), Solved::repaired);
    expect_solved(solver.tree(), counts, goals);

    counts.fade(state_id(151), a0, 0.0, 0.5);
    counts.fade(state_id(151), action_id(1), 0.0, 0.5);
    counts.record(state_id(160), a0, state_id(151));
    EXPECT_EQ(solver.solve(counts, goals), Solved::repaired);
    EXPECT_FALSE(solver.tree().reaches_goal(state_id(151)));
    expect_solved(solver.tree(), counts, goals);
}

// A pair that comes and one that goes leave the number of pairs as it was.
TEST(PathSolver, AsManyErasedAsAddedAreNoticed) {
    TransitionCounts<FadingCell> counts(4, 2);
    counts.record(s1, a0, s0);
    counts.record(s1, action_id(1), s2);
    counts.record(s2, a0, s0);
    Solver<> solver;
    const std::vector<Goal> goals{{s0, 0.0}};
    solver.solve(counts, goals);
    const std::size_t pairs = counts.pairs();
    counts.fade(s1, a0, 0.0, 0.5);
    counts.record(s3, a0, s1);
    ASSERT_EQ(counts.pairs(), pairs);
    solver.solve(counts, goals);
    EXPECT_EQ(solver.tree().next[1], s2);
    expect_solved(solver.tree(), counts, goals);
}

TEST(PathSolver, CostsThatDistancesAbsorbMeanSearches) {
    TransitionCounts<CountCell> counts(30, 2);
    for (std::size_t s = 1; s < 30; ++s) {
        counts.record(state_id(s), a0, state_id(s - 1), false, 0.0, s == 1 ? 1e20 : 1.0);
    }
    Solver<> solver;
    const std::vector<Goal> goals{{s0, 0.0}};
    solver.solve(counts, goals);
    counts.record(state_id(29), action_id(1), state_id(2));
    EXPECT_EQ(solver.solve(counts, goals), Solved::searched);
    EXPECT_EQ(solver.tree().path(state_id(29)).back(), s0);
}

TEST(PathSolver, ARepairThatMeetsAnAbsorbedCostGivesUp) {
    TransitionCounts<CountCell> counts(30, 2);
    for (std::size_t s = 1; s < 30; ++s) counts.record(state_id(s), a0, state_id(s - 1));
    Solver<> solver;
    const std::vector<Goal> goals{{s0, 0.0}};
    solver.solve(counts, goals);
    counts.record(state_id(20), a0, state_id(19), false, 0.0, 1e20);  // 20 to 29 lose their paths: few enough
    EXPECT_EQ(solver.solve(counts, goals), Solved::searched);
    EXPECT_EQ(solver.tree().path(state_id(29)).size(), 30u);
    counts.record(state_id(25), action_id(1), s3);
    EXPECT_EQ(solver.solve(counts, goals), Solved::searched) << "25 to 24 was absorbed";
    EXPECT_EQ(solver.tree().next[25], s3);
}

TEST(PathSolver, CostsBelowTheFloorMeanSearches) {
    TransitionCounts<CountCell> counts(30, 1);
    for (std::size_t s = 1; s < 30; ++s) counts.record(state_id(s), a0, state_id(s - 1));
    Solver<LogRisk> solver(LogRisk(0.0));
    const std::vector<Goal> goals{{s0, 0.0}};
    solver.solve(counts, goals);
    counts.record(state_id(20), a0, s0, false, 0.0, 1e-29);
    EXPECT_EQ(solver.solve(counts, goals), Solved::repaired) << "above the floor";
    counts.record(state_id(21), a0, s0, false, 0.0, 1e30);
    EXPECT_EQ(solver.solve(counts, goals), Solved::searched);
    ReverseGraph graph;
    graph.assign(counts);
    EXPECT_EQ(solver.tree().distance, shortest_paths_to(graph, goals).distance);
}

TEST(PathSolver, LearningRunsSolveAsFromScratch) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        TransitionCounts<FadingCell> counts(400, 4);
        Solver<> solver;
        std::size_t solved[3] = {0, 0, 0};
        const std::vector<Goal> goals{{state_id(210), 0.0}, {state_id(399), 0.5}};
        for (int episode = 0; episode < 400; ++episode) {
            walk(counts, 20, solver.tree(), goals, random);
            ++solved[static_cast<std::size_t>(solver.solve(counts, goals))];
            expect_solved(solver.tree(), counts, goals);
            if (HasFailure()) return;
        }
        EXPECT_GT(solved[static_cast<std::size_t>(Solved::repaired)], 100u);
        EXPECT_GT(solved[static_cast<std::size_t>(Solved::searched)], 5u);
    }
}
