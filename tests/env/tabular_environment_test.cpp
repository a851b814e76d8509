// SPDX-License-Identifier: MIT
#include <sspql/env/tabular_environment.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include <sspql/env/chain.hpp>
#include <sspql/model/transition_table_builder.hpp>

using sspql::action_id;
using sspql::ActionId;
using sspql::index;
using sspql::state_id;
using sspql::StateId;
using sspql::TabularEnvironment;
using sspql::TransitionTableBuilder;

static_assert(sspql::is_environment_v<TabularEnvironment, ActionId>);

namespace {

template <class F>
std::string error_of(F&& f) {
    try {
        f();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "no error";
}

sspql::TransitionTable three_ways() {
    TransitionTableBuilder builder(3, 2);
    builder.add(state_id(0), action_id(0), state_id(0), 0.5, -1.0);
    builder.add(state_id(0), action_id(0), state_id(1), 0.3);
    builder.add(state_id(0), action_id(0), state_id(2), 0.2, 4.0, true);
    builder.add(state_id(1), action_id(1), state_id(0), 1.0);
    return builder.build();
}

}  // namespace

// 100 000 draws, 4 deviations: 4 sqrt(p (1-p) 100 000) <= 633. Seed 1.
TEST(TabularEnvironment, DrawsOutcomesAsOftenAsTheTableSays) {
    TransitionTableBuilder builder(4, 1);
    builder.add(state_id(0), action_id(0), state_id(0), 0.5);
    builder.add(state_id(0), action_id(0), state_id(1), 0.3, 2.0);
    builder.add(state_id(0), action_id(0), state_id(2), 0.2, -1.0);
    builder.add(state_id(1), action_id(0), state_id(0), 1.0);
    builder.add(state_id(2), action_id(0), state_id(0), 1.0);
    builder.start_in({state_id(0)});
    TabularEnvironment environment(builder.build());
    std::map<std::pair<std::size_t, double>, double> seen;
    (void)environment.reset(1);
    double draws = 0.0;
    while (draws < 100000.0) {
        const bool counts = environment.state() == state_id(0);
        const auto step = environment.step(action_id(0));
        EXPECT_FALSE(step.terminated || step.truncated);
        if (!counts) continue;
        draws += 1.0;
        seen[{index(step.observation), step.reward}] += 1.0;
    }
    ASSERT_EQ(seen.size(), 3u);
    EXPECT_NEAR((seen[{0, 0.0}]), 50000, 633);
    EXPECT_NEAR((seen[{1, 2.0}]), 30000, 580);
    EXPECT_NEAR((seen[{2, -1.0}]), 20000, 506);
}

TEST(TabularEnvironment, EndsWhereTheTableDoes) {
    TabularEnvironment environment(three_ways());
    EXPECT_EQ(environment.size(), 3u);
    EXPECT_EQ(environment.state(), sspql::no_state);
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        StateId s = environment.reset(seed);
        for (;;) {
            const auto step = environment.step(index(s) == 0 ? action_id(0) : action_id(1));
            EXPECT_EQ(step.terminated, step.observation == state_id(2));
            EXPECT_EQ(step.terminated, step.reward > 0.0);
            if (step.terminated) break;
            s = step.observation;
        }
        EXPECT_EQ(error_of([&] { (void)environment.step(action_id(0)); }), "step() outside an episode: reset() first");
    }
}

TEST(TabularEnvironment, TheSameSeedIsTheSameEpisode) {
    TabularEnvironment first(sspql::chain_table({10, 0.3}));
    TabularEnvironment second = first;
    (void)second.reset(77);
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        ASSERT_EQ(first.reset(seed), second.reset(seed));
        for (;;) {
            const auto a = first.step(action_id(0));
            const auto b = second.step(action_id(0));
            ASSERT_EQ(a.observation, b.observation);
            if (a.terminated) break;
        }
    }
}

TEST(TabularEnvironment, RefusesActionsThatAStateDoesNotHave) {
    TabularEnvironment environment(three_ways());
    EXPECT_EQ(error_of([&] { (void)environment.step(action_id(0)); }), "step() outside an episode: reset() first");
    std::uint64_t seed = 0;
    while (environment.reset(seed) != state_id(0)) ++seed;
    EXPECT_EQ(error_of([&] { (void)environment.step(action_id(1)); }), "action must be one of state 0, got 1");
    EXPECT_EQ(error_of([&] { (void)environment.step(action_id(2)); }), "action must be one of state 0, got 2");
    EXPECT_EQ(environment.state(), state_id(0));
}

TEST(Chain, GoesWhereItIsSentOrStays) {
    const sspql::TransitionTable table = sspql::chain_table();
    EXPECT_EQ(table.states(), 10u);
    EXPECT_EQ(table.actions(), 2u);
    EXPECT_EQ(table.size(), 9u * 2u + 8u * 2u + 1u);  // right or stay; left or stay; stay at the left end
    ASSERT_EQ(table.starts().size(), 1u);
    EXPECT_EQ(table.starts()[0], state_id(0));
    EXPECT_FALSE(table.has_actions(state_id(9)));
    const auto last = table.outcomes(state_id(8), action_id(0));
    EXPECT_EQ(last[0].next, state_id(8));
    EXPECT_EQ(last[0].probability, 0.7);
    EXPECT_EQ(last[1].next, state_id(9));
    EXPECT_EQ(last[1].probability, 0.3);
    EXPECT_EQ(last[1].reward, 1.0);
    EXPECT_TRUE(last[1].terminal);
    const auto back = table.outcomes(state_id(8), action_id(1));
    EXPECT_EQ(back[0].next, state_id(7));
    EXPECT_EQ(back[0].probability, 0.3);
    EXPECT_EQ(back[0].reward, 0.0);
    EXPECT_FALSE(back[0].terminal);
    ASSERT_EQ(table.outcomes(state_id(0), action_id(1)).size(), 1u);
    EXPECT_EQ(table.outcomes(state_id(0), action_id(1))[0].next, state_id(0));
    EXPECT_EQ(sspql::chain_table({10, 1.0}).size(), 9u * 2u);
    EXPECT_EQ(error_of([] { (void)sspql::chain_table({1, 0.3}); }), "number of states must be at least 2, got 1");
    EXPECT_EQ(error_of([] { (void)sspql::chain_table({10, 0.0}); }), "probability must lie in (0, 1], got 0");
}

// 2000 episodes: the mean length is 30, its deviation sqrt(9 (1-p) / p^2 / 2000) = .19; 4 of those.
TEST(Chain, LastsThirtySteps) {
    TabularEnvironment environment(sspql::chain_table());
    double steps = 0.0;
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        (void)environment.reset(seed);
        bool terminated = false;
        while (!terminated) {
            terminated = environment.step(action_id(0)).terminated;
            steps += 1.0;
        }
    }
    EXPECT_NEAR(steps / 2000.0, 30.0, 0.75);
}
