// SPDX-License-Identifier: MIT
// The small parts of AdaptiveSspql: which actions lead back, a selector without noise, goals that were told.
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/learn/action_selector.hpp>
#include <sspql/learn/adaptive/retrace.hpp>
#include <sspql/learn/adaptive/told_goals.hpp>
#include <sspql/learn/greedy.hpp>
#include <sspql/spaces/legal_actions.hpp>

namespace sspql_adaptive_parts_test {

using namespace sspql;

namespace {

constexpr StateId s0{0}, s1{1}, s2{2};
constexpr ActionId east{0}, west{1}, jump{2};

void go(Retrace& retrace, StateId from, ActionId a, StateId to) { retrace.observe({from, a, 0.0, to, false, 1.0}); }

/// How often Greedy takes each of the actions with these scores, of 6000.
std::vector<int> choices(const std::vector<double>& scores, const ActionSet& legal) {
    std::vector<int> chosen(scores.size(), 0);
    Random random(3);
    for (int k = 0; k < 6000; ++k) {
        ++chosen[index(Greedy{}(
            scores.size(), legal, [&](ActionId a) { return scores[index(a)]; }, random))];
    }
    return chosen;
}

}  // namespace

TEST(Retrace, LearnsWhatUndoesWhat) {
    Retrace retrace(3, 3);
    EXPECT_EQ(retrace.rate(s1, west), 0.0) << "never entered";
    go(retrace, s0, east, s1);
    EXPECT_EQ(retrace.heading(s1), east);
    EXPECT_EQ(retrace.heading(s0), no_action) << "not where it led to";
    EXPECT_EQ(retrace.rate(s1, west), 0.0) << "entered by east, of which nothing is known";
    go(retrace, s1, west, s0);
    EXPECT_DOUBLE_EQ(retrace.rate(s1, west), 1.0 / 3.0) << "1 hit, 1 trial and 2 for doubt";
    EXPECT_DOUBLE_EQ(retrace.rate(s1, jump), 0.0);
    go(retrace, s0, east, s1);
    EXPECT_DOUBLE_EQ(retrace.rate(s1, west), 1.0 / 3.0);
    EXPECT_DOUBLE_EQ(retrace.rate(s0, east), 1.0 / 3.0) << "east after west led back to s1";
    go(retrace, s1, west, s2);  // this time it did not
    EXPECT_DOUBLE_EQ(retrace.rate(s1, west), 1.0 / 4.0);
    EXPECT_DOUBLE_EQ(retrace.rate(s2, east), 1.0 / 3.0) << "the same of every state entered by west";
}

TEST(Retrace, StayingAndNewEpisodesLeadNowhere) {
    Retrace retrace(3, 3);
    go(retrace, s0, east, s1);
    retrace.begin_episode();
    EXPECT_EQ(retrace.heading(s1), no_action);
    go(retrace, s1, west, s0);  // not right after
    EXPECT_EQ(retrace.rate(s1, west), 0.0);
    go(retrace, s0, west, s0);  // against a wall
    EXPECT_EQ(retrace.heading(s0), no_action);
    go(retrace, s0, east, s1);
    EXPECT_EQ(retrace.rate(s0, east), 0.0);
}

TEST(Retrace, TheGreatestRateOfTheActionsAStateWasEnteredByCounts) {
    Retrace retrace(3, 3);
    for (int k = 0; k < 8; ++k) {
        go(retrace, s0, east, s1);
        go(retrace, s1, west, s0);
    }
    EXPECT_DOUBLE_EQ(retrace.rate(s1, west), 8.0 / 10.0);
    retrace.begin_episode();
    go(retrace, s0, jump, s1);
    EXPECT_DOUBLE_EQ(retrace.rate(s1, west), 8.0 / 10.0);
    go(retrace, s2, jump, s2);
    EXPECT_EQ(retrace.rate(s2, west), 0.0) << "staying is not entering";
}

TEST(Retrace, GrowsAndWorksForManyActions) {
    Retrace growing(0, 3);
    growing.grow(2);
    go(growing, s0, east, s1);
    go(growing, s1, west, s0);
    growing.grow(3);
    EXPECT_DOUBLE_EQ(growing.rate(s1, west), 1.0 / 3.0);
    for (const std::size_t actions : {64u, 65u}) {
        const ActionId last = action_id(actions - 1);
        Retrace retrace(3, actions);
        go(retrace, s0, last, s1);
        EXPECT_EQ(retrace.heading(s1), last);
        go(retrace, s1, east, s0);
        EXPECT_DOUBLE_EQ(retrace.rate(s1, east), actions == 64 ? 1.0 / 3.0 : 0.0) << actions;
    }
}

TEST(Greedy, TakesTheBestLegalAction) {
    const ActionSet all = ActionSet::all(4);
    EXPECT_EQ(choices({1.0, 3.0, 2.0, -1.0}, all), (std::vector<int>{0, 6000, 0, 0}));
    EXPECT_EQ(choices({-5.0, -3.0, -2.0, -1.0}, all), (std::vector<int>{0, 0, 0, 6000}));
    EXPECT_EQ(choices({1.0, 3.0, 2.0, -1.0}, ActionSet::of(4, {action_id(0), action_id(3)})),
              (std::vector<int>{6000, 0, 0, 0}));
}

TEST(Greedy, DrawsAmongEqualsUniformly) {
    for (const double best : {0.0, 1.0, -7.0, 1e-9}) {
        const auto chosen = choices({best, best - 1.0, best, best}, ActionSet::all(4));
        EXPECT_EQ(chosen[1], 0);
        for (const std::size_t a : {0u, 2u, 3u}) EXPECT_NEAR(chosen[a], 2000, 200) << best;
    }
    const double next = 1.0 + std::numeric_limits<double>::epsilon();
    EXPECT_NEAR(choices({1.0, next}, ActionSet::all(2))[0], 3000, 250) << "equal up to rounding";
    EXPECT_EQ(choices({1.0, 1.0 + 1e-9}, ActionSet::all(2))[0], 0) << "but not up to more";
}

TEST(Greedy, DrawsNothingWithoutEquals) {
    Random random(1), untouched(1);
    const std::array<double, 3> scores{0.3, 0.1, 0.2};
    (void)Greedy{}(
        3, ActionSet::all(3), [&](ActionId a) { return scores[index(a)]; }, random);
    EXPECT_EQ(random.state(), untouched.state());
    (void)Greedy{}(
        3, ActionSet::all(3), [](ActionId) { return 1.0; }, random);
    EXPECT_NE(random.state(), untouched.state());
    static_assert(is_selector_v<Greedy>);
}

TEST(ToldGoals, AreWorthLessTheFartherTheyAre) {
    OptimismScale scale(0.9, {});
    scale.told_goals();
    ToldGoals goals;
    EXPECT_TRUE(goals.empty());
    EXPECT_FALSE(goals.contains(s1));
    goals.set({{s1, 0.0}, {s2, 2.0}, {s2, 5.0}}, scale);
    EXPECT_FALSE(goals.contains(s0));
    EXPECT_TRUE(goals.contains(s1) && goals.contains(s2));
    EXPECT_FALSE(goals.contains(state_id(100)));
    EXPECT_EQ(goals.worth(s1), 1.0);
    EXPECT_NEAR(goals.worth(s2), 0.81, 1e-12) << "told twice, the better one";
    goals.set({{s0, 1.0}}, scale);
    EXPECT_TRUE(goals.contains(s0));
    EXPECT_FALSE(goals.contains(s1) || goals.contains(s2)) << "those before hold no longer";
    goals.set({}, scale);
    EXPECT_TRUE(goals.empty());
    EXPECT_FALSE(goals.contains(s0));
}

TEST(ToldGoals, FollowTheScale) {
    OptimismScale scale(0.9, {});
    scale.told_goals();
    ToldGoals goals;
    goals.set({{s1, 0.0}, {s2, 3.0}}, scale);
    scale.observe_step(-2.0, true);  // steps cost, as it turns out
    scale.told_goals();
    goals.renew(scale);
    EXPECT_EQ(goals.worth(s1), 0.0);
    EXPECT_EQ(goals.worth(s2), -6.0) << "three steps more";
}

}  // namespace sspql_adaptive_parts_test
