// SPDX-License-Identifier: MIT
#include <sspql/sim/belief.hpp>

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace sim = sspql::sim;

namespace {

sim::SensorParams noise(double factor) {
    sim::SensorParams params;
    params.noise = factor;
    return params;
}

/// All beams read `range`, nothing in view.
sim::SensorReadings blank(double range = 3.0) {
    sim::SensorReadings readings;
    readings.ranges.fill(range);
    return readings;
}

sim::SensorReadings goal_at(double bearing_rad, double range_m, bool whole = true) {
    sim::SensorReadings readings = blank();
    readings.view.goal = sim::Sighting{bearing_rad, range_m, whole};
    return readings;
}

const sim::RangeFinder& finder() {
    static const sim::RangeFinder it;
    return it;
}

}  // namespace

TEST(Belief, KnowsNothingAtFirstAndFollowsTheOdometer) {
    sim::Belief belief;
    EXPECT_FALSE(belief.box());
    EXPECT_FALSE(belief.goal());
    EXPECT_FALSE(belief.is_complete());
    EXPECT_TRUE(belief.robot() == sim::Pose{});
    belief.travelled({1.0, 0.0});
    belief.travelled({0.0, sim::pi / 2.0});
    belief.travelled({0.5, 0.0});
    EXPECT_NEAR(belief.robot().x_m, 1.0, 1e-12);
    EXPECT_NEAR(belief.robot().y_m, 0.5, 1e-12);
    EXPECT_NEAR(belief.robot().heading_rad, sim::pi / 2.0, 1e-12);
}

TEST(Belief, FirstSightPlacesThings) {
    sim::Belief belief;
    belief.travelled({1.0, 0.0});
    sim::SensorReadings readings = goal_at(sim::from_degrees(-20.0), 2.0);
    readings.view.box = sim::Sighting{sim::from_degrees(10.0), 0.0, true};
    readings.ranges.fill(4.0);
    readings.ranges[50] = 0.85;  // the beam at 10 degrees
    belief.look(readings, finder());
    ASSERT_TRUE(belief.is_complete());
    EXPECT_NEAR(belief.goal()->place.x_m, 1.0 + 2.0 * std::cos(sim::from_degrees(20.0)), 1e-12);
    EXPECT_NEAR(belief.goal()->place.y_m, -2.0 * std::sin(sim::from_degrees(20.0)), 1e-12);
    // The box's middle: 0.561 of its side behind what the beam met.
    EXPECT_NEAR(sim::distance_m({1.0, 0.0}, belief.box()->place), 0.85 + 0.561 * 0.3, 1e-12);
    // Its variance, for one degree of bearing and 3 % of the range: the mean of both coordinates.
    const double range = 0.06;
    const double across = 2.0 * sim::from_degrees(1.0);
    EXPECT_NEAR(belief.goal()->variance_m2, 0.5 * (range * range + across * across), 1e-12);
}

TEST(Belief, CorrectsByTheRatioOfVariances) {
    sim::Belief belief(noise(1.0));
    belief.look(goal_at(0.0, 2.0), finder());
    const double variance = belief.goal()->variance_m2;
    belief.look(goal_at(0.0, 2.1), finder());
    // Nearly equal variances (the second, from farther away, a little larger): nearly the middle.
    EXPECT_NEAR(belief.goal()->place.x_m, 2.0475, 0.002);
    EXPECT_NEAR(belief.goal()->variance_m2, variance / 2.0, 0.06 * variance);
    // A part of the edge counts a quarter of that.
    sim::Belief other(noise(1.0));
    other.look(goal_at(0.0, 2.0), finder());
    other.look(goal_at(0.0, 2.1, false), finder());
    EXPECT_NEAR(other.goal()->place.x_m, 2.0185, 0.002);
}

TEST(Belief, ExactSensorsAreBelievedAtOnce) {
    sim::Belief belief(noise(0.0));
    belief.look(goal_at(0.0, 2.0), finder());
    EXPECT_EQ(belief.goal()->variance_m2, 0.0);
    belief.travelled({0.5, 0.3});
    EXPECT_EQ(belief.goal()->variance_m2, 0.0);
    belief.look(goal_at(-0.1, 1.6), finder());
    const sim::Point there = sim::ahead(sim::position(belief.robot()), sim::direction(0.2), 1.6);
    EXPECT_NEAR(sim::distance_m(belief.goal()->place, there), 0.0, 1e-12);
}

TEST(Belief, DriftGrowsWithTheWayAndASightRemovesIt) {
    sim::Belief belief(noise(1.0));
    belief.look(goal_at(0.0, 2.0), finder());
    const double seen = belief.goal()->variance_m2;
    belief.travelled({0.0, 1.0});  // 2 % of a radian at 2 m: 0.04 m
    EXPECT_NEAR(belief.goal()->variance_m2, seen + 0.04 * 0.04, 1e-12);
    belief.travelled({0.5, 0.0});  // 2 % of half a metre
    EXPECT_NEAR(belief.goal()->variance_m2, seen + 0.04 * 0.04 + 0.01 * 0.01, 1e-12);
    for (int i = 0; i < 100; ++i) belief.travelled({0.0, i % 2 == 0 ? 0.5 : -0.5});
    const double drifted = belief.goal()->variance_m2;
    EXPECT_GT(drifted, 10.0 * seen);
    // Seen where it is not believed to be: the robot's heading has drifted. Believe the eyes.
    const double bearing = sim::bearing_rad(belief.robot(), belief.goal()->place) + 0.05;
    const double range = sim::distance_m(sim::position(belief.robot()), belief.goal()->place);
    belief.look(goal_at(bearing, range), finder());
    EXPECT_LT(std::fabs(sim::bearing_rad(belief.robot(), belief.goal()->place) - bearing), 0.01);
    EXPECT_LT(belief.goal()->variance_m2, 1.05 * seen);
}

TEST(Belief, WhatWasMovedIsBelievedAtItsNewPlace) {
    sim::Belief belief(noise(1.0));
    for (int i = 0; i < 50; ++i) belief.look(goal_at(0.0, 2.0), finder());
    belief.look(goal_at(0.4, 2.0), finder());  // 0.8 m to the side
    EXPECT_NEAR(belief.goal()->place.y_m, 2.0 * std::sin(0.4), 1e-12);
}

TEST(Belief, WhatIsMissingThreeTimesIsForgotten) {
    sim::Belief belief(noise(1.0));
    belief.look(goal_at(0.0, 2.0), finder());
    belief.look(blank(), finder());
    belief.look(blank(), finder());
    EXPECT_TRUE(belief.goal());
    belief.look(goal_at(0.0, 2.0), finder());  // a sight starts the count anew
    belief.look(blank(), finder());
    belief.look(blank(), finder());
    EXPECT_TRUE(belief.goal());
    belief.look(blank(), finder());
    EXPECT_FALSE(belief.goal());
    // Out of view it is not missed.
    belief.look(goal_at(0.0, 2.0), finder());
    belief.travelled({0.0, 1.0});
    for (int i = 0; i < 10; ++i) belief.look(blank(), finder());
    EXPECT_TRUE(belief.goal());
}

TEST(Belief, AGoalBehindTheBoxIsNotMissed) {
    sim::Belief belief(noise(1.0));
    sim::SensorReadings both = goal_at(0.0, 2.0);
    both.view.box = sim::Sighting{0.0, 0.0, true};
    both.ranges.fill(0.8);
    belief.look(both, finder());
    sim::SensorReadings box_only = both;
    box_only.view.goal.reset();
    for (int i = 0; i < 10; ++i) belief.look(box_only, finder());
    EXPECT_TRUE(belief.is_complete());
}

TEST(Belief, RefusesNonsense) {
    EXPECT_THROW(sim::Belief(noise(-1.0)), std::invalid_argument);
    EXPECT_THROW(sim::Belief(noise(1.0), 0.0), std::invalid_argument);
}
