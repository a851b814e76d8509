// SPDX-License-Identifier: MIT
#include <sspql/sim/guard.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace sim = sspql::sim;

TEST(Guard, FrontSonarsSeeTheBoxAhead) {
    const sim::Guard guard{sim::PusherParams{}};
    const sim::Square box = sim::square_at({}, 0.3);
    // Robot at x = -1, radius 0.2, box side at -0.15: the front sonar at -0.8 reads 0.65.
    EXPECT_NEAR(guard.reading_m({-1.0, 0.0}, sim::direction(0.0), true, box), 0.65, 1e-12);
    // Backwards it looks at the wall 2.5 - 1 - 0.2 = 1.3 behind; looking away from the box the roles change.
    EXPECT_NEAR(guard.reading_m({-1.0, 0.0}, sim::direction(0.0), false, box), 1.3, 1e-12);
    EXPECT_NEAR(guard.reading_m({-1.0, 0.0}, {-1.0, 0.0}, false, box), 0.65, 1e-12);
    EXPECT_NEAR(guard.reading_m({-1.0, 0.0}, {-1.0, 0.0}, true, box), 1.3, 1e-12);
}

TEST(Guard, ACornerBetweenTheRaysIsNotSeen) {
    sim::PusherParams params;
    params.guard_angles_rad = {0.0, sim::from_degrees(30.0), sim::from_degrees(-30.0)};
    const sim::Guard guard(params);
    // A small box in the middle between the 0 and the 30 degree ray, 0.4 m off: no ray meets it.
    const double bearing = sim::from_degrees(15.0);
    const sim::Square unseen = sim::square_at({0.4 * std::cos(bearing), 0.4 * std::sin(bearing), bearing}, 0.05);
    EXPECT_GT(guard.reading_m({0.0, 0.0}, sim::direction(0.0), true, unseen), 2.0);
    // The same box on the 30 degree ray: 0.4 - 0.2 - 0.025.
    const double on_ray = sim::from_degrees(30.0);
    const sim::Square seen = sim::square_at({0.4 * std::cos(on_ray), 0.4 * std::sin(on_ray), on_ray}, 0.05);
    EXPECT_NEAR(guard.reading_m({0.0, 0.0}, sim::direction(0.0), true, seen), 0.175, 1e-12);
}

TEST(Guard, SeesWalls) {
    const sim::Guard guard{sim::PusherParams{}};
    const sim::Square far_box = sim::square_at({-2.0, -2.0, 0.0}, 0.3);
    EXPECT_NEAR(guard.reading_m({2.26, 0.0}, sim::direction(0.0), true, far_box), 0.04, 1e-12);
}
