// SPDX-License-Identifier: MIT
#include <sspql/sim/rectangle.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/sim/robot_body.hpp>

namespace sim = sspql::sim;
using sim::Rectangle;

namespace {

Rectangle at(double x, double y, double angle_deg, double half_length = 0.2, double half_width = 0.1) {
    return {{x, y}, sim::direction(sim::from_degrees(angle_deg)), half_length, half_width};
}

}  // namespace

TEST(Rectangle, CornersAndExtent) {
    const auto corners = sim::corners_of(at(1.0, 2.0, 90.0));
    EXPECT_NEAR(corners[0].x_m, 0.9, 1e-12);  // front left of a rectangle that looks up
    EXPECT_NEAR(corners[0].y_m, 2.2, 1e-12);
    EXPECT_NEAR(corners[2].x_m, 1.1, 1e-12);  // rear right
    EXPECT_NEAR(corners[2].y_m, 1.8, 1e-12);
    EXPECT_NEAR(sim::half_extent_m(at(0, 0, 0), {1.0, 0.0}), 0.2, 1e-12);
    EXPECT_NEAR(sim::half_extent_m(at(0, 0, 90), {1.0, 0.0}), 0.1, 1e-12);
    EXPECT_NEAR(sim::half_extent_m(at(0, 0, 45), {1.0, 0.0}), 0.3 * std::sqrt(0.5), 1e-12);
}

TEST(Rectangle, GapsByHand) {
    EXPECT_NEAR(sim::rectangle_gap(at(0, 0, 0), at(1, 0, 0)), 0.6, 1e-12);      // face to face
    EXPECT_NEAR(sim::rectangle_gap(at(0, 0, 0), at(0, 1, 90)), 0.7, 1e-12);     // 1 - 0.1 - 0.2
    EXPECT_NEAR(sim::rectangle_gap(at(0, 0, 0), at(0.7, 0.6, 0)), 0.5, 1e-12);  // corner to corner: 3, 4, 5
    EXPECT_NEAR(sim::rectangle_gap(at(0, 0, 0), at(0.3, 0, 0)), -0.1, 1e-12);
    EXPECT_NEAR(sim::rectangle_gap(at(0, 0, 0), at(0.4, 0, 0)), 0.0, 1e-12);
    // The corner of one at 45 degrees points at the side of the other: 1 - 0.2 - 0.3 sqrt(1/2).
    EXPECT_NEAR(sim::rectangle_gap(at(0, 0, 0), at(1, 0, 45, 0.15, 0.15)), 0.8 - 0.3 * std::sqrt(0.5), 1e-12);
}

TEST(Rectangle, GapIsSymmetricAndNoLongerThanAnySampledDistance) {
    sspql::Random random(1);
    int apart = 0;
    for (int i = 0; i < 300; ++i) {
        const double x = random.uniform(-0.7, 0.7);
        const double y = random.uniform(-0.7, 0.7);
        const Rectangle a = at(0.0, 0.0, random.uniform(-180.0, 180.0), 0.2, 0.172);
        const Rectangle b = at(x, y, random.uniform(-180.0, 180.0), 0.15, 0.15);
        const double gap = sim::rectangle_gap(a, b);
        EXPECT_NEAR(gap, sim::rectangle_gap(b, a), 1e-12) << i;
        if (gap <= 0.0) continue;
        ++apart;
        // Points of b's outline, seen from a.
        double least = 10.0;
        const auto corners = sim::corners_of(b);
        for (std::size_t side = 0; side < 4; ++side) {
            const sim::Point& from = corners[side];
            const sim::Point& to = corners[(side + 1) % 4];
            for (int k = 0; k <= 60; ++k) {
                const double t = k / 60.0;
                const sim::Point p =
                    sim::in_frame_of(a, {from.x_m + t * (to.x_m - from.x_m), from.y_m + t * (to.y_m - from.y_m)});
                const double dx = std::max(std::fabs(p.x_m) - a.half_length_m, 0.0);
                const double dy = std::max(std::fabs(p.y_m) - a.half_width_m, 0.0);
                least = std::min(least, std::sqrt(dx * dx + dy * dy));
            }
        }
        EXPECT_LE(gap, least + 1e-12) << i;
        EXPECT_GE(gap, least - 0.006) << i;  // samples are 5 mm apart
    }
    EXPECT_GT(apart, 100);
}

TEST(RobotBody, ARectangleHasAFlatFront) {
    sim::RobotBody body;
    body.shape = sim::BodyShape::rectangle;
    EXPECT_NEAR(sim::outline_m(body, 0.0), 0.2, 1e-12);
    EXPECT_NEAR(sim::outline_m(body, sim::pi / 2.0), 0.172, 1e-12);
    EXPECT_NEAR(sim::outline_m(body, sim::from_degrees(30.0)), 0.2 / std::cos(sim::from_degrees(30.0)), 1e-12);
    EXPECT_NEAR(sim::reach_m(body), std::sqrt(0.2 * 0.2 + 0.172 * 0.172), 1e-12);
    const sim::Square box = sim::square_at({}, 0.3);
    EXPECT_NEAR(sim::box_gap_m(body, {-1.0, 0.0, 0.0}, box), 0.65, 1e-12);
    EXPECT_NEAR(sim::box_gap_m(body, {-1.0, 0.0, sim::pi / 2.0}, box), 0.678, 1e-12);
    EXPECT_NEAR(sim::wall_gap_m(body, {2.0, 0.0, 0.0}, 2.5), 0.3, 1e-12);
    EXPECT_NEAR(sim::wall_gap_m(body, {2.0, 0.0, sim::pi / 2.0}, 2.5), 0.328, 1e-12);
}
