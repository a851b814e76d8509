// SPDX-License-Identifier: MIT
#include <sspql/env/grid_world.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/env/changing_grid_world.hpp>
#include <sspql/env/time_limit.hpp>

using sspql::action_id;
using sspql::ChangingGridWorld;
using sspql::GridMap;
using sspql::GridRewards;
using sspql::GridWorld;
using sspql::GridWorldParams;
using sspql::index;
using sspql::Move;
using sspql::SlipKind;
using sspql::state_id;
using sspql::StateId;

static_assert(sspql::is_environment_v<GridWorld, Move>);
static_assert(sspql::is_environment_v<ChangingGridWorld, Move>);
static_assert(sspql::is_environment_v<sspql::TimeLimit<ChangingGridWorld>, Move>);

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

GridWorldParams slipping(SlipKind kind, double slip) {
    GridWorldParams params;
    params.slip = slip;
    params.slip_kind = kind;
    return params;
}

/// The probability that the table gives to (s, move, next, reward, terminal).
double probability(const sspql::TransitionTable& table, StateId s, Move move, StateId next) {
    double sum = 0.0;
    for (const auto& outcome : table.outcomes(s, action_id(static_cast<std::size_t>(move)))) {
        if (outcome.next == next) sum += outcome.probability;
    }
    return sum;
}

}  // namespace

TEST(GridWorld, MovesAndBumps) {
    GridWorld world(
        GridMap::parse("...\n"
                       ".S#\n"
                       "..G\n"));
    const auto to = [&](Move move) {
        const auto step = world.step(move);
        EXPECT_EQ(step.reward, 0.0);
        EXPECT_FALSE(step.terminated || step.truncated);
        return index(step.observation);
    };
    EXPECT_EQ(world.state(), sspql::no_state);
    EXPECT_EQ(index(world.reset(3)), 4u);
    EXPECT_EQ(to(Move::right), 4u);  // wall
    EXPECT_EQ(to(Move::up), 1u);
    EXPECT_EQ(to(Move::up), 1u);  // edge
    EXPECT_EQ(to(Move::right), 2u);
    EXPECT_EQ(to(Move::right), 2u);
    EXPECT_EQ(to(Move::down), 2u);
    EXPECT_EQ(to(Move::left), 1u);
    EXPECT_EQ(to(Move::left), 0u);
    EXPECT_EQ(to(Move::left), 0u);
    EXPECT_EQ(to(Move::down), 3u);
    EXPECT_EQ(to(Move::down), 6u);
    EXPECT_EQ(to(Move::down), 6u);
    EXPECT_EQ(to(Move::right), 7u);
    const auto end = world.step(Move::right);
    EXPECT_EQ(index(end.observation), 8u);
    EXPECT_EQ(end.reward, 1.0);
    EXPECT_TRUE(end.terminated);
    EXPECT_FALSE(end.truncated);
    EXPECT_EQ(world.describe(end.observation), "row 2, column 2 (goal)");
}

TEST(GridWorld, HazardsEndTheEpisodeOrLeadBack) {
    const GridMap map = GridMap::parse("S.H.G");
    GridWorldParams params;
    params.rewards = {2.0, -0.5, -3.0, true};
    GridWorld ends(map, params);
    (void)ends.reset(1);
    EXPECT_EQ(ends.step(Move::right).reward, -0.5);
    const auto end = ends.step(Move::right);
    EXPECT_EQ(end.reward, -3.0);
    EXPECT_TRUE(end.terminated);
    EXPECT_EQ(index(end.observation), 2u);

    params.rewards.hazard_ends = false;
    GridWorld leads_back(map, params);
    (void)leads_back.reset(1);
    (void)leads_back.step(Move::right);
    const auto back = leads_back.step(Move::right);
    EXPECT_EQ(back.reward, -3.0);
    EXPECT_FALSE(back.terminated);
    EXPECT_EQ(index(back.observation), 0u);
    EXPECT_EQ(index(leads_back.step(Move::right).observation), 1u);
    EXPECT_EQ(error_of([&] { GridWorld(GridMap::parse("S.H.S.G"), params); }),
              "number of start cells must be 1 where hazards lead back to the start, got 2");
}

TEST(GridWorld, SlipsGoWhereTheirKindSays) {
    const GridMap map = GridMap::parse(
        "#.G\n"
        "...\n"
        "...\n");
    const StateId s = map.state(1, 1);
    const auto p = [&](SlipKind kind, Move move) {
        const sspql::TransitionTable table = GridWorld(map, slipping(kind, 0.3)).table();
        return std::vector<double>{probability(table, s, move, map.state(0, 1)),
                                   probability(table, s, move, map.state(2, 1)),
                                   probability(table, s, move, map.state(1, 0)),
                                   probability(table, s, move, map.state(1, 2)), probability(table, s, move, s)};
    };
    const auto expect = [](const std::vector<double>& actual, const std::vector<double>& wanted) {
        for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(actual[i], wanted[i], 1e-15) << i;
    };
    //                                              up   down left right stay
    expect(p(SlipKind::other, Move::up), {0.7, 0.1, 0.1, 0.1, 0.0});
    expect(p(SlipKind::other, Move::down), {0.1, 0.7, 0.1, 0.1, 0.0});
    expect(p(SlipKind::other, Move::left), {0.1, 0.1, 0.7, 0.1, 0.0});
    expect(p(SlipKind::other, Move::right), {0.1, 0.1, 0.1, 0.7, 0.0});
    expect(p(SlipKind::perpendicular, Move::up), {0.7, 0.0, 0.15, 0.15, 0.0});
    expect(p(SlipKind::perpendicular, Move::down), {0.0, 0.7, 0.15, 0.15, 0.0});
    expect(p(SlipKind::perpendicular, Move::left), {0.15, 0.15, 0.7, 0.0, 0.0});
    expect(p(SlipKind::perpendicular, Move::right), {0.15, 0.15, 0.0, 0.7, 0.0});
    expect(p(SlipKind::lost, Move::up), {0.7, 0.0, 0.0, 0.0, 0.3});
    expect(p(SlipKind::lost, Move::right), {0.0, 0.0, 0.0, 0.7, 0.3});
}

// 200 000 random steps a kind against the table: for the outcomes of each (s, move), the chi-squared statistic over all
// of them; its mean is the degrees of freedom k, its deviation sqrt(2 k), and we allow 4 of those. Seed 7.
TEST(GridWorld, StepsAsOftenAsItsTableSays) {
    const GridMap map = GridMap::parse(
        "..#.\n"
        ".H..\n"
        "...G\n");
    for (const SlipKind kind : {SlipKind::other, SlipKind::perpendicular, SlipKind::lost}) {
        GridWorld world(map, slipping(kind, 0.4));
        const sspql::TransitionTable table = world.table();
        std::map<std::tuple<std::size_t, std::size_t, std::size_t, double, bool>, double> seen;
        std::vector<std::vector<double>> tries(map.size(), std::vector<double>(4, 0.0));
        sspql::Random random(7);
        StateId s = world.reset(0);
        for (std::uint64_t i = 1; i <= 200000; ++i) {
            const std::size_t move = random.below(4);
            const auto step = world.step(static_cast<Move>(move));
            tries[index(s)][move] += 1.0;
            seen[{index(s), move, index(step.observation), step.reward, step.terminated}] += 1.0;
            s = step.terminated ? world.reset(i) : step.observation;
        }
        double chi_squared = 0.0;
        double freedom = 0.0;
        double explained = 0.0;
        for (std::size_t state = 0; state < map.size(); ++state) {
            for (std::size_t move = 0; move < 4; ++move) {
                const auto outcomes = table.outcomes(state_id(state), action_id(move));
                for (const auto& outcome : outcomes) {
                    const double n = seen[{state, move, index(outcome.next), outcome.reward, outcome.terminal}];
                    const double expected = tries[state][move] * outcome.probability;
                    ASSERT_GT(expected, 5.0);
                    chi_squared += (n - expected) * (n - expected) / expected;
                    explained += n;
                }
                if (!outcomes.empty()) freedom += static_cast<double>(outcomes.size()) - 1.0;
            }
        }
        EXPECT_EQ(explained, 200000.0);  // nothing happens that the table does not know
        EXPECT_LT(std::fabs(chi_squared - freedom), 4.0 * std::sqrt(2.0 * freedom)) << static_cast<int>(kind);
    }
}

TEST(GridWorld, StartsInEveryFreeCellAlike) {
    GridWorld world(GridMap::parse("..#\n.HG"));
    std::map<std::size_t, int> starts;
    for (std::uint64_t seed = 0; seed < 3000; ++seed) ++starts[index(world.reset(seed))];
    ASSERT_EQ(starts.size(), 3u);
    for (const auto& [s, n] : starts) EXPECT_NEAR(n, 1000, 104) << s;  // 4 deviations of sqrt(3000 (1/3) (2/3)) = 25.8
}

TEST(GridWorld, TheSameSeedIsTheSameEpisode) {
    GridWorld first(GridMap::parse("....\n....\n...G"), slipping(SlipKind::other, 0.5));
    GridWorld second = first;
    (void)second.reset(99);
    (void)second.step(Move::up);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        ASSERT_EQ(first.reset(seed), second.reset(seed));
        for (std::size_t i = 0; i < 50; ++i) {
            const auto a = first.step(static_cast<Move>(i % 4));
            const auto b = second.step(static_cast<Move>(i % 4));
            ASSERT_EQ(a.observation, b.observation);
            ASSERT_EQ(a.terminated, b.terminated);
            if (a.terminated) break;
        }
    }
}

// A bump, a slip and a plain step take one number each: after them, two worlds with different walls still slip alike.
TEST(GridWorld, TakesOneNumberAStep) {
    GridWorld open(GridMap::parse("........\n....S...\n.......G"), slipping(SlipKind::lost, 0.5));
    GridWorld walled(GridMap::parse("########\n####S###\n.......G"), slipping(SlipKind::lost, 0.5));
    (void)open.reset(5);
    (void)walled.reset(5);
    sspql::Random noise(5, sspql::RandomStream::noise);
    StateId s = open.state();
    for (std::size_t i = 0; i < 40; ++i) {
        const Move move = i % 2 == 0 ? Move::left : Move::right;
        const bool slips = noise.chance(0.5);
        const StateId next = open.step(move).observation;
        EXPECT_EQ(next == s, slips || (move == Move::left && open.map().column(s) == 0) ||
                                 (move == Move::right && open.map().column(s) == 7));
        s = next;
        (void)walled.step(move);
    }
    EXPECT_EQ(walled.step(Move::down).observation == walled.map().state(1, 4), noise.chance(0.5));
}

TEST(GridWorld, ItsTableIsWhatItDoes) {
    const sspql::TransitionTable table = GridWorld(GridMap::parse("S#G\n..H"), GridWorldParams{}).table();
    EXPECT_EQ(table.states(), 6u);
    EXPECT_EQ(table.actions(), 4u);
    EXPECT_EQ(table.size(), 3u * 4u);
    EXPECT_EQ(table.starts(), std::vector<StateId>{state_id(0)});
    EXPECT_FALSE(table.has_actions(state_id(1)));
    EXPECT_FALSE(table.has_actions(state_id(2)));
    EXPECT_FALSE(table.has_actions(state_id(5)));
    const auto into_hazard = table.outcomes(state_id(4), action_id(3));
    ASSERT_EQ(into_hazard.size(), 1u);
    EXPECT_TRUE(into_hazard[0].terminal);
    EXPECT_EQ(into_hazard[0].reward, 0.0);
    EXPECT_EQ(into_hazard[0].next, state_id(5));
}

TEST(GridWorld, AlwaysSlippingIsATableToo) {
    for (const SlipKind kind : {SlipKind::other, SlipKind::perpendicular, SlipKind::lost}) {
        GridWorld world(GridMap::parse("..\n.G"), slipping(kind, 1.0));
        EXPECT_EQ(world.table().states(), 4u);
        (void)world.reset(1);
        const auto step = world.step(Move::up);
        EXPECT_GT(probability(world.table(), world.reset(1), Move::up, step.observation), 0.0);
    }
}

TEST(GridWorld, RefusesWrongCalls) {
    GridWorld world(GridMap::parse("SG"));
    EXPECT_EQ(error_of([&] { (void)world.step(Move::up); }), "step() outside an episode: reset() first");
    (void)world.reset(1);
    EXPECT_EQ(error_of([&] { (void)world.step(static_cast<Move>(4)); }), "move must be below 4, got 4");
    EXPECT_TRUE(world.step(Move::right).terminated);
    EXPECT_EQ(error_of([&] { (void)world.step(Move::right); }), "step() outside an episode: reset() first");
    GridWorldParams params;
    params.slip = 1.5;
    EXPECT_EQ(error_of([&] { GridWorld(world.map(), params); }), "slip must lie in [0, 1], got 1.5");
    params.slip = 0.0;
    params.rewards.step = std::numeric_limits<double>::infinity();
    EXPECT_EQ(error_of([&] { GridWorld(world.map(), params); }), "step reward must be finite, got inf");
}

TEST(GridWorld, AnotherMapHoldsFromTheNextStep) {
    GridWorld world(GridMap::parse("S..G"));
    (void)world.reset(1);
    (void)world.step(Move::right);
    world.set_map(GridMap::parse("S##G"));  // the agent is walled in, at state 1
    EXPECT_EQ(index(world.step(Move::right).observation), 1u);
    EXPECT_EQ(index(world.step(Move::left).observation), 0u);
    EXPECT_EQ(index(world.step(Move::right).observation), 0u);
    world.set_map(GridMap::parse("G..S"));  // the goal comes to the agent: it must be entered
    EXPECT_FALSE(world.step(Move::left).terminated);
    (void)world.step(Move::right);
    EXPECT_TRUE(world.step(Move::left).terminated);
    EXPECT_EQ(index(world.reset(1)), 3u);
    EXPECT_EQ(error_of([&] { world.set_map(GridMap::parse("SG\n..")); }),
              "new map must have 1 rows of 4, got 2 rows of 2");
}

TEST(ChangingGridWorld, ChangesAfterSoManyStepsOfAllEpisodes) {
    ChangingGridWorld world(GridWorld(GridMap::parse("S.G")), {{3, GridMap::parse("S#G")}, {5, GridMap::parse("SG.")}});
    EXPECT_EQ(world.changes().size(), 2u);
    (void)world.reset(1);
    (void)world.step(Move::right);
    EXPECT_TRUE(world.step(Move::right).terminated);  // steps 0 and 1
    (void)world.reset(2);
    EXPECT_EQ(index(world.step(Move::left).observation), 0u);  // step 2
    EXPECT_EQ(world.changes_made(), 0u);
    EXPECT_EQ(index(world.step(Move::right).observation), 0u);  // step 3: the wall is there
    EXPECT_EQ(world.changes_made(), 1u);
    EXPECT_EQ(index(world.step(Move::right).observation), 0u);
    EXPECT_EQ(world.steps(), 5u);
    EXPECT_TRUE(world.step(Move::right).terminated);  // step 5: the goal has moved
    EXPECT_EQ(world.changes_made(), 2u);
    EXPECT_EQ(world.world().map(), GridMap::parse("SG."));
    EXPECT_EQ(error_of([&] { (void)world.step(Move::up); }), "step() outside an episode: reset() first");
    EXPECT_EQ(world.steps(), 6u);
}

TEST(ChangingGridWorld, StartsEpisodesOnTheMapOfTheirFirstStep) {
    ChangingGridWorld world(GridWorld(GridMap::parse("SG.")), {{1, GridMap::parse(".GS")}});
    EXPECT_EQ(index(world.reset(1)), 0u);
    (void)world.step(Move::right);
    EXPECT_EQ(index(world.reset(1)), 2u);
}

TEST(ChangingGridWorld, RefusesImpossibleChanges) {
    const GridWorld world(GridMap::parse("S.G"));
    const GridMap other = GridMap::parse("SG.");
    EXPECT_EQ(error_of([&] {
                  ChangingGridWorld(world, {{0, other}});
              }),
              "from_step of a map change must exceed 0, got 0");
    EXPECT_EQ(error_of([&] {
                  ChangingGridWorld(world, {{5, other}, {5, other}});
              }),
              "from_step of a map change must exceed 5, got 5");
    EXPECT_EQ(error_of([&] {
                  ChangingGridWorld(world, {{5, GridMap::parse("SG")}});
              }),
              "new map must have 1 rows of 3, got 1 rows of 2");
}
