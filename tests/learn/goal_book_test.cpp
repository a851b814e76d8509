// SPDX-License-Identifier: MIT
#include <sspql/learn/goal_book.hpp>

#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

namespace sspql_goal_book_test {

using sspql::Goal;
using sspql::GoalBook;
using sspql::state_id;
using sspql::StateId;

namespace {

/// A step into `next`.
sspql::Transition into(std::size_t next, double reward, bool terminated) {
    sspql::Transition t;
    t.next = state_id(next);
    t.reward = reward;
    t.terminated = terminated;
    return t;
}

std::vector<std::size_t> goals(const GoalBook& book) {
    std::vector<std::size_t> states;
    for (const Goal& goal : book.goals()) states.push_back(sspql::index(goal.state));
    return states;
}

using States = std::vector<std::size_t>;

}  // namespace

TEST(GoalBook, AGoalIsWhereAnEpisodeEndedWithAReward) {
    GoalBook book(10);
    EXPECT_EQ(goals(book), States{});
    book.observe(into(3, 0.0, false));
    book.observe(into(4, 1.0, true));
    book.observe(into(2, 0.5, true));
    book.observe(into(4, 1.0, true));
    EXPECT_EQ(goals(book), (States{4, 2})) << "each once, in the order they were found";
    EXPECT_EQ(book.goals()[0].offset, 0.0);
}

TEST(GoalBook, OtherTerminalStatesAreHazards) {
    GoalBook book(10);
    book.observe(into(5, 0.0, true));
    book.observe(into(6, -1.0, true));
    EXPECT_EQ(goals(book), States{});
    book.observe(into(7, 1.0, true));
    EXPECT_EQ(goals(book), States{7});
}

TEST(GoalBook, EveryTerminalStateIsAGoalOnceStepsHadCosts) {
    GoalBook book(10);
    book.observe(into(5, 0.0, true));
    EXPECT_EQ(goals(book), States{});
    book.observe(into(1, -1.0, false));
    EXPECT_EQ(goals(book), States{5}) << "also those seen before the first cost";
    book.observe(into(6, -1.0, true));
    EXPECT_EQ(goals(book), (States{5, 6}));
}

TEST(GoalBook, OnceRewardedStaysRewarded) {
    GoalBook book(10);
    book.observe(into(5, 1.0, true));
    book.observe(into(5, 0.0, true));
    EXPECT_EQ(goals(book), States{5});
    book.observe(into(6, 0.0, true));
    book.observe(into(6, 2.0, true));
    EXPECT_EQ(goals(book), (States{5, 6}));
}

TEST(GoalBook, PassingThroughWithoutTerminatingForgetsAGoal) {
    GoalBook book(10);
    book.observe(into(5, 1.0, true));
    book.observe(into(6, 1.0, true));
    book.observe(into(5, 0.0, false));
    EXPECT_EQ(goals(book), States{6});
    book.observe(into(5, 0.0, true));
    EXPECT_EQ(goals(book), States{6}) << "a hazard now";
    book.observe(into(5, 1.0, true));
    EXPECT_EQ(goals(book), (States{6, 5}));
}

TEST(GoalBook, GivenGoalsHoldAloneUntilTheyAreTakenBack) {
    GoalBook book(10);
    book.observe(into(5, 1.0, true));
    book.set({{state_id(1), 0.5}, {state_id(2)}});
    EXPECT_EQ(goals(book), (States{1, 2}));
    EXPECT_EQ(book.goals()[0].offset, 0.5);
    book.observe(into(6, 1.0, true));
    book.observe(into(1, 0.0, false));
    EXPECT_EQ(goals(book), (States{1, 2})) << "passing through a given goal does not forget it";
    book.set({});
    EXPECT_EQ(goals(book), (States{5, 6})) << "found in the meantime, too";
}

TEST(GoalBook, Grows) {
    GoalBook book;
    book.reserve(20);
    book.grow(3);
    book.observe(into(2, 1.0, true));
    book.grow(20);
    book.grow(5);
    book.observe(into(19, 1.0, true));
    EXPECT_EQ(goals(book), (States{2, 19}));
}

}  // namespace sspql_goal_book_test
