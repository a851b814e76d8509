// SPDX-License-Identifier: MIT
#include <sspql/learn/agent.hpp>

#include <array>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/learn/q_learning.hpp>
#include <sspql/spaces/enum_state.hpp>
#include <sspql/spaces/product_state.hpp>
#include <sspql/spaces/uniform_grid.hpp>

namespace sspql_agent_test {

using namespace sspql;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// A robot on a floor of 4 x 4 metres.
struct Scan {
    double x_m = 0.0;
    double y_m = 0.0;
};
struct Drive {
    double x_m = 0.0;
    double y_m = 0.0;
};

auto floor_states() {
    return ProjectedState(UniformGrid<2>({{{0.0, 4.0, 4}, {0.0, 4.0, 4}}}), [](const Scan& scan) {
        return std::array{scan.x_m, scan.y_m};
    });
}

ActionTable<Drive> drives() { return {{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}; }

Scan moved(const Scan& from, const Drive& drive) {
    return {std::min(3.5, std::max(0.5, from.x_m + drive.x_m)), std::min(3.5, std::max(0.5, from.y_m + drive.y_m))};
}

const Scan start{0.5, 0.5};
const Scan home{3.5, 3.5};

template <class A>
std::size_t episode(A& agent, const Scan& to = home) {
    Scan at = start;
    Drive drive = agent.begin(at);
    for (std::size_t steps = 1;; ++steps) {
        at = moved(at, drive);
        const bool there = at.x_m == to.x_m && at.y_m == to.y_m;
        if (there || steps == 500) {
            agent.end(there ? 1.0 : 0.0, at, there);
            return steps;
        }
        drive = agent.step(0.0, at);
    }
}

}  // namespace

TEST(Agent, LearnsInTheRobotsOwnLanguage) {
    Agent robot(floor_states(), drives());
    for (int k = 0; k < 30; ++k) (void)episode(robot);
    EXPECT_LE(episode(robot), 10u);
    const Drive best = robot.best(Scan{3.5, 2.5});
    EXPECT_EQ(best.x_m, 0.0);
    EXPECT_EQ(best.y_m, 1.0);
    EXPECT_EQ(robot.learner().states(), 16u);
    EXPECT_EQ(robot.learner().actions(), 4u);
    EXPECT_FALSE(robot.learner().grows());
}

TEST(Agent, SaysWhatItsLearnerSays) {
    Agent robot(floor_states(), drives());
    AdaptiveSspql<> learner(16, 4);
    auto states = floor_states();
    Scan at = start;
    Drive drive = robot.begin(at);
    ActionId a = learner.begin(states.encode(at));
    for (int k = 0; k < 200; ++k) {
        EXPECT_EQ(drive.x_m, drives().decode(a).x_m);
        EXPECT_EQ(drive.y_m, drives().decode(a).y_m);
        at = moved(at, drive);
        drive = robot.step(0.125, at, 2.0);
        a = learner.step(0.125, states.encode(at), 2.0);
    }
    EXPECT_EQ(robot.learner().q().matrix(), learner.q().matrix());
    EXPECT_EQ(robot.terms(at, a).sum(), learner.terms(states.encode(at), a).sum());
    EXPECT_EQ(robot.state(at), states.encode(at));
}

TEST(Agent, IsMadeInEveryWay) {
    const Agent defaults(floor_states(), drives());
    static_assert(std::is_same_v<decltype(defaults.learner()), const AdaptiveSspql<>&>);
    const Agent published(floor_states(), drives(), paper());
    static_assert(std::is_same_v<decltype(published.learner()), const Sspql<>&>);
    const Agent with_params(floor_states(), drives(), SspqlParams<>::ssp_only());
    EXPECT_EQ(with_params.learner().params().w_q, 0.0);
    const Agent rival(floor_states(), drives(), QLearningParams<>{});
    static_assert(std::is_same_v<decltype(rival.learner()), const QLearning<>&>);
    const Agent seeded(floor_states(), drives(), QLearningParams<>{}, 7);
    static_assert(std::is_same_v<decltype(seeded.learner()), const QLearning<>&>);
    Agent by_braces(floor_states(), drives(), {}, 7);
    static_assert(std::is_same_v<decltype(by_braces), Agent<decltype(floor_states()), ActionTable<Drive>, AdaptiveSspql<>>>);
    Agent<EnumState<int>, ActionTable<char>, QLearning<>> named(EnumState<int>(3), {'l', 'r'});
    EXPECT_EQ(named.actions().size(), 2u);
    EXPECT_EQ(named.states().size(), 3u);
    QLearningParams<> bad;
    bad.gamma = 2.0;
    EXPECT_THROW(Agent(floor_states(), drives(), bad), std::invalid_argument);
}

TEST(Agent, SeedsDiffer) {
    Agent a(floor_states(), drives(), SspqlParams<>{}, 1);
    Agent b(floor_states(), drives(), SspqlParams<>{}, 1);
    Agent c(floor_states(), drives(), SspqlParams<>{}, 2);
    std::vector<std::size_t> of_a;
    std::vector<std::size_t> of_b;
    std::vector<std::size_t> of_c;
    for (int k = 0; k < 10; ++k) {
        of_a.push_back(episode(a));
        of_b.push_back(episode(b));
        of_c.push_back(episode(c));
    }
    EXPECT_EQ(of_a, of_b);
    EXPECT_NE(of_a, of_c);
}

TEST(Agent, RefusedCallsChangeNothingThatWasLearnt) {
    Agent robot(floor_states(), drives());
    for (int k = 0; k < 3; ++k) (void)episode(robot);
    Agent twin = robot;
    EXPECT_THROW((void)robot.step(0.0, start), std::logic_error);
    EXPECT_THROW((void)robot.begin(Scan{not_a_number, 0.0}), std::invalid_argument);
    EXPECT_FALSE(robot.learner().running());
    (void)robot.begin(start);
    (void)twin.begin(start);
    EXPECT_THROW((void)robot.step(not_a_number, start), std::invalid_argument);
    EXPECT_THROW((void)robot.step(0.0, Scan{0.0, not_a_number}), std::invalid_argument);
    EXPECT_THROW((void)robot.step(0.0, start, 0.0), std::invalid_argument);
    EXPECT_THROW((void)robot.begin(start), std::logic_error);
    EXPECT_THROW(robot.end(0.0, Scan{not_a_number, 0.0}, true), std::invalid_argument);
    robot.end(0.0, start, false);
    twin.end(0.0, start, false);
    for (int k = 0; k < 5; ++k) EXPECT_EQ(episode(robot), episode(twin));
    EXPECT_EQ(robot.learner().q().matrix(), twin.learner().q().matrix());
}

TEST(Agent, AbortsReplacesAndObserves) {
    Agent robot(floor_states(), drives(), QLearningParams<>{});
    (void)robot.begin(start);
    robot.abort();
    EXPECT_FALSE(robot.learner().running());
    (void)robot.begin(start);
    robot.replace_action(action_id(2));
    EXPECT_THROW(robot.replace_action(action_id(4)), std::invalid_argument);
    (void)robot.step(1.0, Scan{0.5, 1.5});
    EXPECT_DOUBLE_EQ(robot.terms(start, action_id(2)).q, 0.8);
    robot.observe(Scan{2.5, 2.5}, action_id(0), 0.5, Scan{3.5, 2.5}, false);
    EXPECT_DOUBLE_EQ(robot.terms(Scan{2.5, 2.5}, action_id(0)).q, 0.4);
    EXPECT_TRUE(robot.learner().running());
    EXPECT_EQ(robot.learner().state(), robot.state(Scan{0.5, 1.5}));
}

TEST(Agent, TakesGoalsAsObservations) {
    Agent robot(floor_states(), drives());
    const ActionTable<Drive> table = drives();
    for (double x = 0.5; x < 4.0; ++x) {
        for (double y = 0.5; y < 4.0; ++y) {
            for (std::size_t a = 0; a < 4; ++a) {
                const Scan from{x, y};
                robot.observe(from, action_id(a), 0.0, moved(from, table.decode(action_id(a))), false);
            }
        }
    }
    for (const Scan& goal : {home, Scan{3.5, 0.5}, Scan{0.5, 2.5}}) {
        robot.set_goals(std::vector<Scan>{goal});
        EXPECT_EQ(episode(robot, goal), static_cast<std::size_t>(goal.x_m + goal.y_m - 1.0));
    }
}

TEST(Agent, ObeysTheMaskOfEachObservation) {
    Agent robot(floor_states(), drives());
    const ActionSet up = ActionSet::of(4, {action_id(2)});
    const ActionSet sideways = ActionSet::of(4, {action_id(0), action_id(1)});
    EXPECT_EQ(robot.begin(start, up).y_m, 1.0);
    for (int k = 0; k < 200; ++k) {
        EXPECT_EQ(robot.step(0.1, Scan{0.5, 1.5}, sideways).y_m, 0.0);
        EXPECT_EQ(robot.step(0.1, start).y_m, 1.0) << "the last mask holds";
    }
    EXPECT_EQ(robot.step(0.1, start, ActionSet::of(4, {action_id(3)}), 2.0).y_m, -1.0);
    EXPECT_THROW((void)robot.step(0.1, start, ActionSet::none(4)), std::invalid_argument);
    EXPECT_THROW((void)robot.step(0.1, start, ActionSet::all(5)), std::invalid_argument);
    EXPECT_EQ(robot.best(start).y_m, -1.0);
}

}  // namespace sspql_agent_test
