// SPDX-License-Identifier: MIT
#include <sspql/sim/robot_body.hpp>

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace sim = sspql::sim;

TEST(RobotBody, GapsOfACircle) {
    const sim::RobotBody body{0.25};
    EXPECT_DOUBLE_EQ(sim::outline_m(body, 1.0), 0.25);
    EXPECT_NEAR(sim::box_gap_m(body, {0.0, 0.65, 2.0}, sim::square_at({}, 0.3)), 0.25, 1e-15);
    EXPECT_NEAR(sim::wall_gap_m(body, {-2.0, 0.0, 2.0}, 2.5), 0.25, 1e-15);
}

TEST(RobotBody, RefusesARadiusThatIsNone) {
    for (const double bad :
         {0.0, -0.2, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_THROW(sim::RobotBody{bad}.validate(), std::invalid_argument) << bad;
    }
    EXPECT_NO_THROW(sim::RobotBody{}.validate());
}
