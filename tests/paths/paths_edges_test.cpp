// SPDX-License-Identifier: MIT
// Paths at the ends of the ranges: no states, one state, weights from 1e-30 to 1e30, a million states in a row.
#include <sspql/paths/ssp_planner.hpp>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include <pthread.h>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/paths/auto_queue.hpp>
#include <sspql/paths/cost.hpp>
#include <sspql/paths/dary_heap.hpp>
#include <sspql/paths/fibonacci_heap.hpp>
#include <sspql/paths/path_solver.hpp>

using namespace sspql;

namespace {

constexpr ActionId a0{0};

/// A tree without cycles whose distances are finite, and larger than the next one's or equal.
void expect_tree(const ShortestPathTree& tree, std::size_t reached) {
    std::size_t found = 0;
    for (std::size_t s = 0; s < tree.size(); ++s) {
        ASSERT_FALSE(std::isnan(tree.distance[s])) << s;
        if (!tree.reaches_goal(state_id(s))) continue;
        ++found;
        std::size_t steps = 0;
        StateId at = state_id(s);
        for (; tree.next[index(at)] != no_state; at = tree.next[index(at)]) {
            ASSERT_LE(tree.distance[index(tree.next[index(at)])], tree.distance[index(at)]) << s;
            ASSERT_LT(++steps, tree.size()) << "a cycle, from " << s;
        }
    }
    EXPECT_EQ(found, reached);
}

/// Runs f on a stack of 256 KiB, in which a call for each state of a long chain would not fit.
template <class F>
void on_a_small_stack(F f) {
    pthread_attr_t attributes;
    ASSERT_EQ(pthread_attr_init(&attributes), 0);
    ASSERT_EQ(pthread_attr_setstacksize(&attributes, std::size_t{1} << 18), 0);
    pthread_t thread{};
    const auto run = [](void* call) -> void* {
        (*static_cast<F*>(call))();
        return nullptr;
    };
    ASSERT_EQ(pthread_create(&thread, &attributes, run, &f), 0);
    pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
}

template <class Parts>
class PathsEdges : public testing::Test {};

template <class C, class Q>
struct Parts {
    using Cost = C;
    using Queue = Q;
};
using AllParts = testing::Types<Parts<RiskWeighted, AutoQueue<>>, Parts<RiskWeighted, FibonacciHeap<>>,
                                Parts<ExpectedTries, AutoQueue<>>, Parts<ExpectedTries, DaryHeap<4>>,
                                Parts<LogRisk, AutoQueue<>>, Parts<HopCount, AutoQueue<>>>;

}  // namespace

TYPED_TEST_SUITE(PathsEdges, AllParts, );

TYPED_TEST(PathsEdges, AnEmptyModelHasAnEmptyTree) {
    TransitionCounts<CountCell> counts(0, 1);
    SspPlanner<typename TypeParam::Cost, BestAction, typename TypeParam::Queue> planner;
    planner.update(counts, {}, AllActions{});
    EXPECT_EQ(planner.tree().size(), 0u);
    EXPECT_THROW(planner.update(counts, {{state_id(0), 0.0}}, AllActions{}), std::invalid_argument);
    planner.start(counts, {});
    StepBudget budget = StepBudget::unlimited();
    for (int i = 0; i < 5; ++i) planner.advance(counts, AllActions{}, budget);
    EXPECT_FALSE(planner.running());
    counts.grow(1);
    planner.update(counts, {{state_id(0), 0.0}}, AllActions{});
    EXPECT_TRUE(planner.tree().reaches_goal(state_id(0)));
}

TYPED_TEST(PathsEdges, OneStateIsItsOwnGoalOrNone) {
    TransitionCounts<CountCell> counts(1, 1);
    counts.record(state_id(0), a0, state_id(0));
    SspPlanner<typename TypeParam::Cost, BestAction, typename TypeParam::Queue> planner;
    planner.update(counts, {}, AllActions{});
    EXPECT_FALSE(planner.tree().reaches_goal(state_id(0)));
    EXPECT_EQ(planner.values().action(state_id(0)), no_action);
    planner.update(counts, {{state_id(0), 2.0}}, AllActions{});
    EXPECT_EQ(planner.tree().distance[0], 2.0);
    EXPECT_EQ(planner.tree().next[0], no_state);
    EXPECT_EQ(planner.tree().path(state_id(0)), std::vector<StateId>{state_id(0)});
    EXPECT_EQ(planner.values().action(state_id(0)), no_action) << "at the goal there is nothing left to do";
}

// Weights over the whole range, in one graph: distances absorb whole paths, and still the tree is one.
TYPED_TEST(PathsEdges, WeightsOfAllMagnitudes) {
    constexpr std::size_t n = 300;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        TransitionCounts<CountCell> counts(n, 2);
        PathSolver<typename TypeParam::Cost, BestAction, typename TypeParam::Queue> solver;
        const std::vector<Goal> goals{{state_id(0), 0.0}, {state_id(1), 1e30}};
        for (std::size_t s = 2; s < n; ++s) {  // every state has a way down
            const std::size_t next = random.below(s);
            counts.record(state_id(s), a0, state_id(next), false, 0.0, random.chance(0.5) ? 1e-30 : 1e30);
        }
        for (int round = 0; round < 20; ++round) {
            solver.solve(counts, goals);
            expect_tree(solver.tree(), n);
            for (int i = 0; i < 30; ++i) {
                const StateId s = state_id(2 + random.below(n - 2));
                const StateId next = state_id(random.below(n));
                const double exponent = random.uniform(-30.0, 30.0);
                counts.record(s, action_id(random.below(2)), next, false, 0.0, std::pow(10.0, exponent));
            }
        }
    }
}

// A million states in a row: found, cut off near the goal, and found again.
TEST(PathsEdgesSlow, AMillionStatesInARowNeedNoStack) {
    on_a_small_stack([] {
        constexpr std::size_t n = 1000000;
        TransitionCounts<FadingCell> counts(n, 1);
        for (std::size_t s = 0; s + 1 < n; ++s) counts.record(state_id(s), a0, state_id(s + 1));
        PathSolver<RiskWeighted, SumOverActions, AutoQueue<>> solver;
        const std::vector<Goal> goals{{state_id(n - 1), 0.0}};
        EXPECT_EQ(solver.solve(counts, goals), Solved::searched);
        EXPECT_EQ(solver.tree().path(state_id(0)).size(), n);

        counts.fade(state_id(n / 2), a0, 0.0, 1.0);  // half of all lose their way: a repair
        EXPECT_EQ(solver.solve(counts, goals), Solved::repaired);
        EXPECT_FALSE(solver.tree().reaches_goal(state_id(0)));
        EXPECT_TRUE(solver.tree().reaches_goal(state_id(n / 2 + 1)));

        counts.record(state_id(n / 2), a0, state_id(n / 2 + 1));
        solver.solve(counts, goals);
        EXPECT_EQ(solver.tree().path(state_id(0)).size(), n);

        counts.fade(state_id(n - 2), a0, 0.0, 1.0);  // nobody has a way any more: a search
        solver.solve(counts, goals);
        EXPECT_FALSE(solver.tree().reaches_goal(state_id(n - 2)));
        EXPECT_TRUE(solver.tree().path(state_id(0)).empty());
    });
}
