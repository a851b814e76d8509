// SPDX-License-Identifier: MIT
#include <sspql/sim/pose.hpp>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace sim = sspql::sim;

TEST(WrapAngle, KeepsWhatLiesInTheHalfOpenTurn) {
    for (const double angle : {0.0, 1.0, -1.0, 3.0, -3.0, sim::pi}) EXPECT_EQ(sim::wrap_angle(angle), angle);
}

TEST(WrapAngle, MinusPiIsPi) {
    EXPECT_EQ(sim::wrap_angle(-sim::pi), sim::pi);
    EXPECT_EQ(sim::wrap_angle(3.0 * sim::pi), sim::pi);
    EXPECT_EQ(sim::wrap_angle(-3.0 * sim::pi), sim::pi);
}

TEST(WrapAngle, TakesWholeTurnsOff) {
    for (int turns = -5; turns <= 5; ++turns) {
        for (int degrees = -179; degrees <= 180; ++degrees) {
            const double angle = sim::from_degrees(static_cast<double>(degrees));
            EXPECT_NEAR(sim::wrap_angle(angle + 2.0 * sim::pi * turns), angle, 1e-13) << degrees << " deg, " << turns;
        }
    }
}

TEST(WrapAngle, NotANumberStaysOne) {
    EXPECT_TRUE(std::isnan(sim::wrap_angle(std::numeric_limits<double>::quiet_NaN())));
    EXPECT_TRUE(std::isnan(sim::wrap_angle(std::numeric_limits<double>::infinity())));
}

TEST(Direction, TurnsReversesAndLeads) {
    // 30 deg turned by 60 deg looks along +y.
    const sim::Direction up =
        sim::turned(sim::direction(sim::from_degrees(30.0)), sim::direction(sim::from_degrees(60.0)));
    EXPECT_NEAR(up.x, 0.0, 1e-15);
    EXPECT_NEAR(up.y, 1.0, 1e-15);
    const sim::Point p = sim::ahead({1.0, 2.0}, sim::reversed(up), 0.5);
    EXPECT_NEAR(p.x_m, 1.0, 1e-15);
    EXPECT_NEAR(p.y_m, 1.5, 1e-15);
    EXPECT_DOUBLE_EQ(sim::distance_m({1.0, 1.0}, {4.0, 5.0}), 5.0);
}

TEST(Pose, ComparesAllMembersAndKnowsFinite) {
    const sim::Pose pose{1.0, 2.0, 3.0};
    EXPECT_TRUE(pose == (sim::Pose{1.0, 2.0, 3.0}));
    EXPECT_TRUE(pose != (sim::Pose{1.5, 2.0, 3.0}));
    EXPECT_TRUE(pose != (sim::Pose{1.0, 2.5, 3.0}));
    EXPECT_TRUE(pose != (sim::Pose{1.0, 2.0, 3.5}));
    EXPECT_TRUE(sim::position(pose) == (sim::Point{1.0, 2.0}));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(sim::is_finite(pose));
    EXPECT_FALSE(sim::is_finite(sim::Pose{nan, 0.0, 0.0}));
    EXPECT_FALSE(sim::is_finite(sim::Pose{0.0, nan, 0.0}));
    EXPECT_FALSE(sim::is_finite(sim::Pose{0.0, 0.0, nan}));
}
