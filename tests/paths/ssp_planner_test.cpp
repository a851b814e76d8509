// SPDX-License-Identifier: MIT
// Algorithm 1 in instalments: any budget leads to the tree and values of a whole solve, no call exceeds its budget by
// more than a state's edges, and what is in use meanwhile is the last finished tree.
#include <sspql/paths/ssp_planner.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/core/step_budget.hpp>
#include <sspql/paths/auto_queue.hpp>
#include <sspql/spaces/legal_actions.hpp>

#include "paths/learnt_grid.hpp"

using namespace sspql;
using namespace sspql::testing;

namespace {

using Planner = SspPlanner<RiskWeighted, SumOverActions, AutoQueue<>>;
const AllActions legal;

template <class Cell>
std::size_t largest_degree(const TransitionCounts<Cell>& counts) {
    std::size_t most = 0;
    for (std::size_t s = 0; s < counts.states(); ++s) {
        most = std::max({most, counts.in_degree(state_id(s)), counts.out_degree(state_id(s))});
    }
    return most;
}

/// Goes on until the solve is finished; no call may leave a larger debt than one state makes. \returns the calls.
template <class Cell>
std::size_t finish(Planner& planner, TransitionCounts<Cell>& counts, std::uint64_t per_call) {
    StepBudget budget(per_call, per_call);
    const auto debt = -static_cast<std::int64_t>(largest_degree(counts) + 1);
    std::size_t calls = 0;
    while (planner.running()) {
        budget.earn();
        const bool finished = planner.advance(counts, legal, budget);
        EXPECT_EQ(finished, !planner.running());
        EXPECT_GE(budget.balance(), debt);
        ++calls;
    }
    return calls;
}

template <class Cell>
void expect_values(const Planner& planner, const TransitionCounts<Cell>& counts) {
    SspValues fresh;
    fresh.assign(counts, planner.tree(), legal);
    for (std::size_t s = 0; s < counts.states(); ++s) {
        ASSERT_EQ(planner.values().action(state_id(s)), fresh.action(state_id(s))) << s;
        const ActionId a = fresh.action(state_id(s));
        ASSERT_TRUE(a == no_action || planner.values()(state_id(s), a) == fresh(state_id(s), a)) << s;
    }
}

}  // namespace

TEST(SspPlanner, UpdatesAreWholeWhateverChanged) {
    TransitionCounts<FadingCell> counts(225, 4);
    Planner planner;
    Random random(5);
    std::vector<Goal> goals{{state_id(112), 0.0}};
    for (int episode = 0; episode < 200; ++episode) {
        walk(counts, 15, planner.tree(), goals, random);
        if (episode % 50 == 49) goals[0].state = state_id(random.below(225));
        planner.update(counts, goals, legal);
        expect_solved(planner.tree(), counts, goals);
        expect_values(planner, counts);
    }
}

TEST(SspPlanner, AnyBudgetLeadsToTheSameTree) {
    const auto learnt = learnt_grid<CountCell>(30);
    const std::vector<Goal> goals{{state_id(444), 0.0}, {state_id(0), 1.0}};
    std::size_t calls_before = 0;
    for (const std::uint64_t per_call : {100000u, 1000u, 37u, 5u, 1u}) {
        auto counts = learnt;
        Planner planner;
        planner.start(counts, goals);
        const std::size_t calls = finish(planner, counts, per_call);
        EXPECT_GT(calls, calls_before);
        EXPECT_LE(calls * per_call, 7 * counts.pairs() + 5 * counts.states() + 2 * per_call);
        calls_before = calls;
        expect_solved(planner.tree(), counts, goals);
        expect_values(planner, counts);
    }
}

// Every record marks a state, may add an edge, grow the states or erase pairs: the tree in use stays the same object of
// the same content until the new one is whole.
TEST(SspPlanner, TheTreeInUseIsTheLastFinishedOne) {
    TransitionCounts<FadingCell> counts(400, 4);
    Random random(11);
    const std::vector<Goal> goals{{state_id(210), 0.0}};
    Planner planner;
    StepBudget budget(50, 50);
    std::size_t finished = 0;
    ShortestPathTree in_use;
    std::vector<ActionId> actions_in_use;
    for (int step = 0; step < 20000; ++step) {
        const std::size_t s = random.below(counts.states());
        const std::size_t a = random.below(4);
        counts.record(state_id(s), action_id(a), state_id(s < 400 ? moved(20, s, a) : random.below(400)));
        if (random.chance(0.1)) counts.fade(state_id(s), action_id(a), 0.3, 0.5);
        if (random.chance(0.001)) {
            counts.grow(counts.states() + 1);
            counts.record(state_id(s), action_id(a), state_id(counts.states() - 1));
        }
        if (!planner.running()) planner.start(counts, goals);
        budget.earn();
        if (planner.advance(counts, legal, budget)) {
            ++finished;
            in_use = planner.tree();
            for (std::size_t i = 0; i < in_use.size(); ++i) {
                const std::vector<StateId> path = in_use.path(state_id(i));
                ASSERT_LE(path.size(), counts.states());
                ASSERT_TRUE(path.empty() || path.back() == state_id(210));
            }
        } else {
            ASSERT_EQ(planner.tree().distance, in_use.distance);
            ASSERT_EQ(planner.tree().next, in_use.next);
        }
    }
    EXPECT_GT(finished, 40u);
    finish(planner, counts, 50);
    planner.start(counts, goals);
    finish(planner, counts, 50);
    expect_solved(planner.tree(), counts, goals);
    expect_values(planner, counts);
}

TEST(SspPlanner, NothingNewIsNotSolved) {
    auto counts = learnt_grid<CountCell>(10);
    const std::vector<Goal> goals{{state_id(0), 0.0}};
    Planner planner;
    planner.start(counts, goals);
    finish(planner, counts, 10);
    planner.start(counts, goals);
    EXPECT_FALSE(planner.running());
    planner.start(counts, {{state_id(1), 0.0}});
    EXPECT_TRUE(planner.running());
    finish(planner, counts, 10);
    expect_solved(planner.tree(), counts, {{state_id(1), 0.0}});
}

// The tolerance keeps all labels: only the refreshed state's value is looked at.
TEST(SspPlanner, WhereNoLabelChangedOnlyValuesAreRenewed) {
    auto counts = learnt_grid<CountCell>(10, 100);
    const std::vector<Goal> goals{{state_id(0), 0.0}};
    Planner planner(RiskWeighted{}, {}, 0.05);
    planner.start(counts, goals);
    finish(planner, counts, 10);
    const ShortestPathTree before = planner.tree();
    const std::uint64_t edges = planner.edges_touched();
    counts.record(state_id(57), action_id(0), state_id(47));
    planner.start(counts, goals);
    ASSERT_TRUE(planner.running());
    finish(planner, counts, 10);
    EXPECT_EQ(planner.edges_touched() - edges, counts.out_degree(state_id(57)));
    EXPECT_EQ(planner.tree().next, before.next);
    expect_values(planner, counts);
}

TEST(SspPlanner, AWholeUpdateReplacesOneInInstalments) {
    const auto learnt = learnt_grid<CountCell>(12);
    const std::vector<Goal> goals{{state_id(70), 0.0}};
    for (int calls = 0; calls < 200; calls += 7) {
        auto counts = learnt;
        Planner planner;
        StepBudget budget(30, 30);
        planner.start(counts, goals);
        Random random(1);
        for (int i = 0; i < calls; ++i) {
            budget.earn();
            planner.advance(counts, legal, budget);
            const std::size_t s = random.below(144);
            counts.record(state_id(s), action_id(0), state_id(moved(12, s, 1)));
        }
        planner.update(counts, goals, legal);
        EXPECT_FALSE(planner.running());
        expect_solved(planner.tree(), counts, goals);
        expect_values(planner, counts);
        TransitionCounts<CountCell> afresh = counts;
        PathSolver<RiskWeighted, SumOverActions, AutoQueue<>> solver;
        for (std::size_t s = 0; s < 144; ++s) afresh.record(state_id(s), action_id(3), state_id(s));
        for (std::size_t s = 0; s < 144; ++s) counts.record(state_id(s), action_id(3), state_id(s));
        solver.solve(afresh, goals);
        planner.update(counts, goals, legal);
        EXPECT_EQ(planner.tree().distance, solver.tree().distance) << "no refresh was forgotten";
    }
}

TEST(SspPlanner, ChangedMasksChangeValues) {
    auto counts = learnt_grid<CountCell>(6);
    const std::vector<Goal> goals{{state_id(0), 0.0}};
    LegalActionTable masks;
    Planner planner;
    planner.update(counts, goals, masks);
    const ActionId before = planner.values().action(state_id(7));
    ActionSet mask = ActionSet::all(4);
    mask.erase(before);
    masks.set(state_id(7), mask);
    planner.mask_changed(state_id(7));
    planner.update(counts, goals, masks);
    EXPECT_NE(planner.values().action(state_id(7)), before);
    SspValues fresh;
    fresh.assign(counts, planner.tree(), masks);
    EXPECT_EQ(planner.values().action(state_id(7)), fresh.action(state_id(7)));
}

TEST(SspPlanner, RefusedGoalsChangeNothing) {
    auto counts = learnt_grid<CountCell>(5);
    Planner planner;
    EXPECT_THROW(planner.start(counts, {{state_id(25), 0.0}}), std::invalid_argument);
    EXPECT_FALSE(planner.running());
    EXPECT_THROW(planner.update(counts, {{state_id(0), -1.0}}, legal), std::invalid_argument);
    EXPECT_EQ(counts.dirty().size(), 25u);
}

// As long as paths can be, and no recursion.
TEST(SspPlannerSlow, AChainOfAMillionStates) {
    constexpr std::size_t n = 1000000;
    TransitionCounts<CountCell> counts(n, 1);
    counts.reserve(n, 2 * n);
    for (std::size_t s = 1; s < n; ++s) counts.record(state_id(s), action_id(0), state_id(s - 1));
    const std::vector<Goal> goals{{state_id(0), 0.0}};
    Planner planner;
    planner.start(counts, goals);
    EXPECT_GT(finish(planner, counts, 1000), 5 * n / 1000);
    EXPECT_EQ(planner.tree().path(state_id(n - 1)).size(), n);
    planner.update(counts, goals, legal);
    EXPECT_EQ(planner.tree().path(state_id(n - 1)).size(), n);
    counts.record(state_id(n - 1000), action_id(0), state_id(n - 1000));
    planner.update(counts, goals, legal);
    EXPECT_EQ(planner.solver().changed_states().size(), 1000u);
    EXPECT_EQ(planner.tree().path(state_id(n - 1)).size(), n);
}
