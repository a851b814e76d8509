// SPDX-License-Identifier: MIT
#include <sspql/learn/agent.hpp>

#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <sspql/learn/q_learning.hpp>
#include <sspql/spaces/hashed_state.hpp>
#include <sspql/spaces/product_state.hpp>

namespace sspql_agent_growing_test {

using namespace sspql;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

const ActionTable<int> turns{-1, 1};

/// Rooms "r0" to "r9" in a row; right of r9 is the exit.
std::string room(int number) { return "r" + std::to_string(number); }

template <class A>
std::size_t episode(A& agent) {
    int at = 0;
    int turn = agent.begin(room(at));
    for (std::size_t steps = 1;; ++steps) {
        at = at + turn < 0 ? 0 : at + turn;
        if (at == 10) {
            agent.end(1.0, std::string("exit"), true);
            return steps;
        }
        turn = agent.step(0.0, room(at));
    }
}

}  // namespace

TEST(GrowingAgent, DiscoversItsStates) {
    Agent robot(HashedState<std::string>{}, turns);
    EXPECT_TRUE(robot.learner().grows());
    EXPECT_EQ(robot.learner().states(), 0u);
    const std::size_t first = episode(robot);
    EXPECT_EQ(robot.learner().states(), 11u);
    EXPECT_EQ(robot.states().size(), 11u);
    for (int k = 0; k < 20; ++k) (void)episode(robot);
    EXPECT_EQ(episode(robot), 10u) << "first episode: " << first;
    EXPECT_EQ(robot.learner().states(), 11u);
}

TEST(GrowingAgent, TheNextCallWorksAfterOneWasRefusedWithANewKey) {
    Agent robot(HashedState<std::string>{}, turns);
    EXPECT_THROW((void)robot.step(0.0, room(5)), std::logic_error) << "the key is known from here";
    EXPECT_EQ(robot.learner().states(), robot.states().size());
    (void)robot.begin(room(0));
    EXPECT_THROW((void)robot.begin(room(1)), std::logic_error);
    EXPECT_THROW((void)robot.step(not_a_number, room(2)), std::invalid_argument);
    EXPECT_THROW((void)robot.step(0.0, room(3), -1.0), std::invalid_argument);
    EXPECT_THROW((void)robot.step(0.0, room(4), ActionSet::none(2)), std::invalid_argument);
    EXPECT_THROW(robot.end(not_a_number, room(6), true), std::invalid_argument);
    EXPECT_THROW(robot.observe(room(7), action_id(2), 0.0, room(8), true), std::invalid_argument);
    EXPECT_EQ(robot.learner().states(), robot.states().size());
    EXPECT_NO_THROW((void)robot.step(0.0, room(9)));
    EXPECT_NO_THROW(robot.end(1.0, std::string("exit"), true));
    EXPECT_LE(episode(robot), 1000u);
}

TEST(GrowingAgent, ObserveDiscoversBothStates) {
    Agent robot(HashedState<std::string>{}, turns);
    robot.observe(room(0), action_id(1), 0.0, room(1), false);
    robot.observe(room(1), action_id(1), 1.0, room(2), true);
    EXPECT_EQ(robot.learner().states(), 3u);
    EXPECT_EQ(robot.best(room(0)), 1);
    EXPECT_EQ(robot.best(room(1)), 1);
}

TEST(GrowingAgent, TakesAPolicyThatKnowsSomeStatesAlready) {
    HashedState<std::string> states;
    for (int k = 0; k < 5; ++k) (void)states.encode(room(k));
    Agent robot(states, turns, QLearningParams<>{}, 1);
    EXPECT_NO_THROW((void)robot.begin(room(3)));
    EXPECT_EQ(robot.learner().states(), 5u);
    EXPECT_NO_THROW((void)robot.step(0.0, std::string("new")));
    EXPECT_EQ(robot.learner().states(), 6u);
}

TEST(GrowingAgent, GrowsBehindAProjection) {
    struct Badge {
        int number = 0;
        double time_s = 0.0;
    };
    Agent robot(ProjectedState(HashedState<int>{}, [](const Badge& badge) { return badge.number; }), turns);
    (void)robot.begin(Badge{100, 0.0});
    (void)robot.step(0.0, Badge{200, 1.0});
    (void)robot.step(0.0, Badge{100, 2.0});
    EXPECT_EQ(robot.learner().states(), 2u);
}

TEST(GrowingAgent, GoalsNeverSeenBecomeStates) {
    Agent robot(HashedState<std::string>{}, turns);
    robot.set_goals(std::vector<std::string>{"exit"});
    EXPECT_EQ(robot.learner().states(), 1u);
    for (int k = 0; k < 10; ++k) (void)episode(robot);
    EXPECT_EQ(episode(robot), 10u);
}

}  // namespace sspql_agent_growing_test
