// SPDX-License-Identifier: MIT
#include <sspql/model/transition_table.hpp>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/model/table_of_counts.hpp>
#include <sspql/model/transition_table_builder.hpp>
#include <sspql/spaces/legal_actions.hpp>

using sspql::action_id;
using sspql::state_id;
using sspql::StateId;
using sspql::TransitionTable;
using sspql::TransitionTableBuilder;
using sspql::TransitionTableError;

namespace {

template <class Error, class F>
std::string error_of(F&& f) {
    try {
        f();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

template <class F>
std::string invalid(F&& f) {
    return error_of<std::invalid_argument>(f);
}

/// 0 --a0--> 1 (.75) or 0 (.25); 0 --a1--> end in 2, reward -1; 1 --a0--> end in 2, reward 1. State 1 has no a1.
TransitionTableBuilder small() {
    TransitionTableBuilder builder(3, 2);
    builder.add(state_id(1), action_id(0), state_id(2), 1.0, 1.0, true);
    builder.add(state_id(0), action_id(1), state_id(2), 1.0, -1.0, true);
    builder.add(state_id(0), action_id(0), state_id(1), 0.75);
    builder.add(state_id(0), action_id(0), state_id(0), 0.25, -2.0);
    return builder;
}

}  // namespace

TEST(TransitionTable, KeepsWhatWasAdded) {
    const TransitionTable table = small().build();
    EXPECT_EQ(table.states(), 3u);
    EXPECT_EQ(table.actions(), 2u);
    EXPECT_EQ(table.size(), 4u);
    const auto outcomes = table.outcomes(state_id(0), action_id(0));
    ASSERT_EQ(outcomes.size(), 2u);
    EXPECT_EQ(outcomes[0].next, state_id(0));
    EXPECT_EQ(outcomes[0].probability, 0.25);
    EXPECT_EQ(outcomes[0].reward, -2.0);
    EXPECT_FALSE(outcomes[0].terminal);
    EXPECT_EQ(outcomes[1].next, state_id(1));
    EXPECT_EQ(outcomes[1].probability, 0.75);
    ASSERT_EQ(table.outcomes(state_id(1), action_id(0)).size(), 1u);
    EXPECT_TRUE(table.outcomes(state_id(1), action_id(0))[0].terminal);
    EXPECT_TRUE(table.outcomes(state_id(1), action_id(1)).empty());
    EXPECT_TRUE(table.outcomes(state_id(2), action_id(0)).empty());
}

TEST(TransitionTable, KnowsWhichActionsAStateHas) {
    static_assert(sspql::is_legal_actions_v<TransitionTable>);
    const TransitionTable table = small().build();
    EXPECT_TRUE(table.allowed(state_id(0)).contains(action_id(1)));
    EXPECT_TRUE(table.allowed(state_id(1)).contains(action_id(0)));
    EXPECT_FALSE(table.allowed(state_id(1)).contains(action_id(1)));
    EXPECT_FALSE(table.allowed(state_id(1)).contains(action_id(2)));
    EXPECT_FALSE(table.allowed(state_id(2)).contains(action_id(0)));
    EXPECT_TRUE(table.has_actions(state_id(1)));
    EXPECT_FALSE(table.has_actions(state_id(2)));
    EXPECT_EQ(table.action_set(state_id(0)), sspql::ActionSet::all(2));
    EXPECT_EQ(table.action_set(state_id(1)), sspql::ActionSet::of(2, {action_id(0)}));
    EXPECT_TRUE(table.action_set(state_id(2)).is_empty());
}

TEST(TransitionTable, StartsWhereItIsToldOrWhereverThereAreActions) {
    EXPECT_EQ(small().build().starts(), (std::vector<StateId>{state_id(0), state_id(1)}));
    EXPECT_EQ(small().start_in({state_id(1)}).build().starts(), std::vector<StateId>{state_id(1)});
    EXPECT_EQ(small().start_in({state_id(1), state_id(0)}).build().starts(),
              (std::vector<StateId>{state_id(0), state_id(1)}));
    EXPECT_EQ(invalid([] { (void)small().start_in({state_id(2)}).build(); }), "start state must have an action, got 2");
    EXPECT_EQ(invalid([] {
                  small().start_in({state_id(1), state_id(0), state_id(1)});
              }),
              "start state must be given once, got 1");
    EXPECT_EQ(invalid([] { small().start_in({state_id(3)}); }), "state must be below the number of states 3, got 3");
}

TEST(TransitionTable, SuccessIsAPositiveTerminalRewardOrElseTheBest) {
    const TransitionTable table = small().build();
    EXPECT_EQ(table.best_terminal_reward(), 1.0);
    EXPECT_TRUE(table.is_success(0.1));
    EXPECT_FALSE(table.is_success(0.0));

    TransitionTableBuilder costs(2, 2);
    costs.add(state_id(0), action_id(0), state_id(1), 1.0, -1.0, true);
    costs.add(state_id(0), action_id(1), state_id(1), 1.0, -5.0, true);
    EXPECT_TRUE(costs.build().is_success(-1.0));
    EXPECT_FALSE(costs.build().is_success(-5.0));

    TransitionTableBuilder endless(1, 1);
    endless.add(state_id(0), action_id(0), state_id(0), 1.0, 3.0);
    EXPECT_FALSE(endless.build().best_terminal_reward().has_value());
    EXPECT_FALSE(endless.build().is_success(3.0));
}

TEST(TransitionTableBuilder, AddsUpEqualOutcomesOnly) {
    TransitionTableBuilder builder(1, 1);
    builder.add(state_id(0), action_id(0), state_id(0), 0.25);
    builder.add(state_id(0), action_id(0), state_id(0), 0.25, 1.0);
    builder.add(state_id(0), action_id(0), state_id(0), 0.125);
    builder.add(state_id(0), action_id(0), state_id(0), 0.375, 0.0, true);
    const TransitionTable table = builder.build();
    const auto outcomes = table.outcomes(state_id(0), action_id(0));
    ASSERT_EQ(outcomes.size(), 3u);
    EXPECT_EQ(outcomes[0].probability, 0.375);
    EXPECT_FALSE(outcomes[0].terminal);
    EXPECT_EQ(outcomes[1].probability, 0.375);
    EXPECT_TRUE(outcomes[1].terminal);
    EXPECT_EQ(outcomes[2].probability, 0.25);
    EXPECT_EQ(outcomes[2].reward, 1.0);
}

TEST(TransitionTableBuilder, RefusesProbabilitiesThatDoNotSumToOne) {
    TransitionTableBuilder builder = small();
    builder.add(state_id(1), action_id(1), state_id(0), 0.5);
    builder.add(state_id(0), action_id(1), state_id(0), 1e-10);  // within 1e-9
    EXPECT_EQ(invalid([&] { (void)builder.build(); }),
              "probabilities of state 1, action 1 must sum to 1 within 1e-9, got 0.5");
    builder.add(state_id(1), action_id(1), state_id(1), 0.500001);
    try {
        (void)builder.build();
        FAIL();
    } catch (const TransitionTableError& error) {
        EXPECT_STREQ(error.what(), "probabilities of state 1, action 1 must sum to 1 within 1e-9, got 1.000001");
        EXPECT_EQ(error.row(), 4u);
        EXPECT_EQ(error.field(), TransitionTableError::Field::probability);
    }
}

TEST(TransitionTableBuilder, RefusesToGoOnWhereThereAreNoActions) {
    TransitionTableBuilder builder = small();
    builder.add(state_id(1), action_id(1), state_id(2), 1.0);
    try {
        (void)builder.build();
        FAIL();
    } catch (const TransitionTableError& error) {
        EXPECT_STREQ(error.what(), "state 1, action 1 must be terminal where it enters state 2, which has no actions");
        EXPECT_EQ(error.row(), 4u);
        EXPECT_EQ(error.field(), TransitionTableError::Field::next);
    }
}

TEST(TransitionTableBuilder, RefusesBadOutcomesAndStaysUsable) {
    TransitionTableBuilder builder = small();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto add = [&](std::size_t s, std::size_t a, std::size_t next, double p, double reward) {
        return invalid([&] { builder.add(state_id(s), action_id(a), state_id(next), p, reward); });
    };
    EXPECT_EQ(add(3, 0, 0, 1.0, 0.0), "state must be below the number of states 3, got 3");
    EXPECT_EQ(add(0, 2, 0, 1.0, 0.0), "action must be below the number of actions 2, got 2");
    EXPECT_EQ(add(0, 0, 3, 1.0, 0.0), "state must be below the number of states 3, got 3");
    EXPECT_EQ(add(0, 0, 0, 0.0, 0.0), "probability must lie in (0, 1], got 0");
    EXPECT_EQ(add(0, 0, 0, -0.5, 0.0), "probability must lie in (0, 1], got -0.5");
    EXPECT_EQ(add(0, 0, 0, 1.5, 0.0), "probability must lie in (0, 1], got 1.5");
    EXPECT_EQ(add(0, 0, 0, nan, 0.0), "probability must lie in (0, 1], got nan");
    EXPECT_EQ(add(0, 0, 0, 1.0, nan), "reward must be finite, got nan");
    EXPECT_EQ(builder.build().size(), 4u);
    EXPECT_EQ(invalid([] { (void)TransitionTableBuilder(1, 1).build(); }),
              "a transition table needs at least one outcome");
    EXPECT_EQ(invalid([] { TransitionTableBuilder(0, 1); }),
              "number of states must lie between 1 and 4294967294, got 0");
}

TEST(TableOfCounts, IsTheMaximumLikelihoodTable) {
    sspql::TransitionCounts<sspql::FadingCell> counts(4, 2);
    for (int i = 0; i < 3; ++i) counts.record(state_id(0), action_id(0), state_id(1), false, 2.0);
    counts.record(state_id(0), action_id(0), state_id(1), false, 0.0);
    counts.record(state_id(0), action_id(0), state_id(0));
    counts.record(state_id(1), action_id(1), state_id(3), true, 1.0);
    counts.record(state_id(1), action_id(0), state_id(2), false, 0.5);  // nothing was tried in 2
    const TransitionTable table = sspql::table_of(counts);
    EXPECT_EQ(table.states(), 4u);
    EXPECT_EQ(table.size(), 4u);
    const auto outcomes = table.outcomes(state_id(0), action_id(0));
    ASSERT_EQ(outcomes.size(), 2u);
    EXPECT_EQ(outcomes[0].probability, 0.2);
    EXPECT_EQ(outcomes[1].probability, 0.8);
    EXPECT_EQ(outcomes[1].reward, 1.5);  // (3 * 2 + 0) / 4
    EXPECT_FALSE(table.allowed(state_id(0)).contains(action_id(1)));
    EXPECT_TRUE(table.outcomes(state_id(1), action_id(1))[0].terminal);
    EXPECT_TRUE(table.outcomes(state_id(1), action_id(0))[0].terminal);
    EXPECT_EQ(table.starts(), (std::vector<StateId>{state_id(0), state_id(1)}));
}

TEST(TableOfCounts, TakesRewardsFromElsewhereForIntegerCounts) {
    sspql::TransitionCounts<> counts(2, 1);
    counts.record(state_id(0), action_id(0), state_id(0));
    counts.record(state_id(0), action_id(0), state_id(0));
    counts.record(state_id(0), action_id(0), state_id(1), true);
    const TransitionTable table =
        sspql::table_of(counts, [](StateId, sspql::ActionId, StateId next, const sspql::CountCell& cell) {
            return cell.terminal() ? 1.0 : -static_cast<double>(sspql::index(next)) - 1.0;
        });
    const auto outcomes = table.outcomes(state_id(0), action_id(0));
    ASSERT_EQ(outcomes.size(), 2u);
    EXPECT_DOUBLE_EQ(outcomes[0].probability, 2.0 / 3.0);
    EXPECT_EQ(outcomes[0].reward, -1.0);
    EXPECT_EQ(outcomes[1].reward, 1.0);
    EXPECT_TRUE(outcomes[1].terminal);
}

TEST(TableOfCounts, RefusesEmptyCounts) {
    const sspql::TransitionCounts<sspql::FadingCell> counts(2, 1);
    EXPECT_THROW((void)sspql::table_of(counts), std::invalid_argument);
}
