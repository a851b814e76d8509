// SPDX-License-Identifier: MIT
// The predetermined sub-tasks, search and push, on beliefs made by hand.
#include <sspql/sim/mission/push_controller.hpp>
#include <sspql/sim/mission/search_controller.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace sim = sspql::sim;
using sim::Motion;
using sim::Outcome;
using sim::PusherCommand;

namespace {

sim::Belief knowing(const sim::Pose& robot, const sim::Point& box = {}, const sim::Point& goal = {1.5, 0.0}) {
    sim::Belief belief;
    belief.know(robot, box, goal);
    return belief;
}

sim::SonarRing::Readings free_way(double everywhere) {
    sim::SonarRing::Readings sonars;
    sonars.fill(everywhere);
    return sonars;
}

sim::PushController beginning(const sim::Belief& belief) {
    sim::PushController push;
    push.begin(belief);
    return push;
}

}  // namespace

TEST(SearchController, TurnsOnceAroundThenTravelsWhereThereIsRoom) {
    sim::SearchController search;
    search.begin();
    sim::SonarRing::Readings sonars = free_way(0.5);
    sonars[6] = 3.0;
    const sim::Belief nothing;
    for (int round = 0; round < 2; ++round) {
        double turned = 0.0;
        for (int i = 0; i < 8; ++i) {
            const auto command = search.next(nothing, sonars);
            ASSERT_TRUE(command);
            EXPECT_EQ(command->motion, Motion::rotate);
            turned += command->amount;
        }
        EXPECT_NEAR(turned, 2.0 * sim::pi, 1e-12);
        const auto turn = search.next(nothing, sonars);
        ASSERT_TRUE(turn);
        EXPECT_EQ(turn->motion, Motion::rotate);
        EXPECT_NEAR(turn->amount, sim::SonarRing::bearing_rad(6), 1e-12);
        const auto leg = search.next(nothing, sonars);
        ASSERT_TRUE(leg);
        EXPECT_EQ(leg->motion, Motion::translate);
        EXPECT_NEAR(leg->amount, sim::SearchController::longest_leg_m, 1e-12);
    }
}

TEST(SearchController, PassesTheBoxThatMayHideTheGoal) {
    sim::SensorReadings readings;
    readings.ranges.fill(1.0);
    readings.view.box = sim::Sighting{0.0, 0.0, true};
    sim::Belief belief;
    belief.look(readings, sim::RangeFinder());
    ASSERT_TRUE(belief.box());
    sim::SearchController search;
    search.begin();
    const sim::SonarRing::Readings sonars = free_way(1.5);
    for (int i = 0; i < 8; ++i) static_cast<void>(search.next(belief, sonars));
    const auto turn = search.next(belief, sonars);
    ASSERT_TRUE(turn);
    EXPECT_NEAR(std::fabs(turn->amount), sim::pi / 2.0, 1e-9);  // across, neither to it nor away
}

TEST(SearchController, ComesNearOnceBothAreBelieved) {
    sim::SearchController search;
    search.begin();
    const sim::SonarRing::Readings sonars = free_way(1.0);
    EXPECT_FALSE(search.next(knowing({-1.1, 0.0, 2.0}), sonars));
    const auto turn = search.next(knowing({-2.0, 0.0, 0.5}), sonars);
    ASSERT_TRUE(turn);
    EXPECT_EQ(turn->motion, Motion::rotate);
    EXPECT_NEAR(turn->amount, -0.5, 1e-12);
    const auto drive = search.next(knowing({-1.5, 0.0, 0.1}), sonars);
    ASSERT_TRUE(drive);
    EXPECT_EQ(drive->motion, Motion::translate);
    EXPECT_NEAR(drive->amount, 0.4, 1e-12);
}

TEST(PushController, DrivesStraightOnTheLine) {
    const sim::Belief belief = knowing({-0.8, 0.0, 0.0});
    const sim::PushStep step = beginning(belief).next(belief);
    EXPECT_FALSE(step.over);
    EXPECT_EQ(step.command.motion, Motion::translate);
    EXPECT_NEAR(step.command.amount, 0.06, 1e-12);
    EXPECT_NEAR(step.command.curve_rad, 0.0, 1e-12);
}

TEST(PushController, SteersForTheLineBeforeContact) {
    // 0.1 m to the left, parallel: heading wish -atan2(0.1, 0.3) = -0.32 rad, turned on the spot.
    const sim::Belief beside = knowing({-1.0, 0.1, 0.0});
    sim::PushStep step = beginning(beside).next(beside);
    EXPECT_EQ(step.command.motion, Motion::rotate);
    EXPECT_NEAR(step.command.amount, -std::atan2(0.1, 0.3), 1e-12);
    // On that heading already: straight on.
    const sim::Belief on_course = knowing({-1.0, 0.1, -std::atan2(0.1, 0.3)});
    step = beginning(on_course).next(on_course);
    EXPECT_EQ(step.command.motion, Motion::translate);
    EXPECT_NEAR(step.command.curve_rad, 0.0, 1e-12);
    // 0.05 m beside the line: a curve.
    const sim::Belief a_little = knowing({-1.0, 0.05, 0.0});
    step = beginning(a_little).next(a_little);
    EXPECT_EQ(step.command.motion, Motion::translate);
    EXPECT_NEAR(step.command.curve_rad, -std::atan2(0.05, 0.3), 1e-12);
}

TEST(PushController, OnlyHoldsTheHeadingInContact) {
    const sim::Belief belief = knowing({-0.37, 0.1, 0.1});
    sim::PushController push = beginning(belief);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(push.next(belief).command.amount, -0.2, 1e-12) << i;  // run-up asked for
    const sim::PushStep step = push.next(belief);  // none was possible: push on
    EXPECT_EQ(step.command.motion, Motion::translate);
    EXPECT_NEAR(step.command.curve_rad, -0.1, 1e-12);
}

TEST(PushController, EndsAtTheGoalPastItOrBesideTheBox) {
    const auto outcome = [](const sim::Pose& robot, const sim::Point& box) {
        const sim::Belief start = knowing({-0.8, 0.0, 0.0});
        sim::PushController push = beginning(start);
        static_cast<void>(push.next(start));
        const sim::Belief now = knowing(robot, box);
        const sim::PushStep step = push.next(now);
        EXPECT_TRUE(step.over);
        return step.outcome;
    };
    EXPECT_EQ(outcome({1.1, 0.0, 0.0}, {1.46, 0.0}), Outcome::success);
    EXPECT_EQ(outcome({1.2, 0.15, 0.0}, {1.5, 0.15}), Outcome::success);  // beside its centre, but in it
    EXPECT_EQ(outcome({1.2, 0.4, 0.0}, {1.5, 0.4}), Outcome::push_past_goal);
    EXPECT_EQ(outcome({-0.2, 0.2, 0.0}, {0.0, 0.0}), Outcome::push_off_axis);  // the box at -45 degrees
    EXPECT_EQ(outcome({1.1, 0.2, 0.0}, {1.35, 0.0}), Outcome::success);        // ... near the goal: no harm
}

TEST(PushController, GivesUpWithoutProgress) {
    const sim::Belief belief = knowing({-0.37, 0.0, 0.0});
    sim::PushController push = beginning(belief);
    int commands = 0;
    sim::PushStep step = push.next(belief);
    for (; !step.over && commands < 100; ++commands) step = push.next(belief);
    EXPECT_EQ(step.outcome, Outcome::push_stuck);
    EXPECT_EQ(commands, 26);
}
