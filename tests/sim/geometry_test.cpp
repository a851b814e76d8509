// SPDX-License-Identifier: MIT
#include <sspql/sim/geometry.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>

namespace sim = sspql::sim;

namespace {

bool is_inside(const sim::Square& square, const sim::Point& p) {
    const sim::Point q = sim::in_frame_of(square, p);
    return std::fabs(q.x_m) <= square.half_side_m && std::fabs(q.y_m) <= square.half_side_m;
}

sim::Square random_square(sspql::Random& random) {
    const double x = random.uniform(-0.5, 0.5);
    const double y = random.uniform(-0.5, 0.5);
    const double angle = random.uniform(-sim::pi, sim::pi);
    const double side = random.uniform(0.1, 0.8);
    return sim::square_at({x, y, angle}, side);
}

sim::Point random_point(sspql::Random& random) {
    const double x = random.uniform(-1.5, 1.5);
    const double y = random.uniform(-1.5, 1.5);
    return {x, y};
}

}  // namespace

TEST(RayToSquare, ByHand) {
    const sim::Square upright = sim::square_at({0.0, 0.0, 0.0}, 0.3);
    EXPECT_NEAR(sim::ray_to_square({-1.0, 0.0}, {1.0, 0.0}, upright), 0.85, 1e-15);
    EXPECT_NEAR(sim::ray_to_square({-1.0, 0.15}, {1.0, 0.0}, upright), 0.85, 1e-15);  // along the side: touches
    EXPECT_EQ(sim::ray_to_square({-1.0, 0.16}, {1.0, 0.0}, upright), sim::no_hit);
    EXPECT_EQ(sim::ray_to_square({-1.0, 0.0}, {-1.0, 0.0}, upright), sim::no_hit);  // behind
    EXPECT_EQ(sim::ray_to_square({0.1, 0.0}, {1.0, 0.0}, upright), 0.0);            // from inside
    // Turned by 45 deg its corner is half a diagonal away: 0.15 sqrt(2).
    const sim::Square on_corner = sim::square_at({0.0, 0.0, sim::pi / 4.0}, 0.3);
    EXPECT_NEAR(sim::ray_to_square({-1.0, 0.0}, {1.0, 0.0}, on_corner), 1.0 - 0.15 * std::sqrt(2.0), 1e-12);
}

TEST(RayToSquare, AgreesWithMarching) {
    sspql::Random random(11);
    constexpr double step = 0.0005;
    int hits = 0;
    for (int i = 0; i < 500; ++i) {
        const sim::Square square = random_square(random);
        const sim::Point from = random_point(random);
        const sim::Direction way = sim::direction(random.uniform(-sim::pi, sim::pi));
        double marched = sim::no_hit;
        double deepest = 0.0;  // to skip rays that only graze a corner between two samples
        for (int k = 0; k < 8000; ++k) {
            const double s = step * k;
            if (is_inside(square, sim::ahead(from, way, s))) {
                if (marched == sim::no_hit) marched = s;
                deepest = s;
            }
        }
        const double cast = sim::ray_to_square(from, way, square);
        if (marched == sim::no_hit) {
            if (cast != sim::no_hit) {
                EXPECT_FALSE(is_inside(square, sim::ahead(from, way, cast + 2.0 * step))) << i;
            }
            continue;
        }
        ++hits;
        EXPECT_GE(deepest, cast);
        EXPECT_NEAR(cast, marched, step + 1e-9) << i;
        EXPECT_LE(cast, marched + 1e-9) << i;
    }
    EXPECT_GT(hits, 50);
}

TEST(RayToWalls, ByHandAndOntoTheWall) {
    EXPECT_NEAR(sim::ray_to_walls({0.5, 0.0}, {1.0, 0.0}, 2.5), 2.0, 1e-15);
    EXPECT_NEAR(sim::ray_to_walls({0.5, 0.0}, {-1.0, 0.0}, 2.5), 3.0, 1e-15);
    EXPECT_NEAR(sim::ray_to_walls({0.5, -1.0}, {0.0, -1.0}, 2.5), 1.5, 1e-15);
    EXPECT_EQ(sim::ray_to_walls({2.6, 0.0}, {1.0, 0.0}, 2.5), 0.0);
    sspql::Random random(12);
    for (int i = 0; i < 500; ++i) {
        const sim::Point from = random_point(random);
        const sim::Direction way = sim::direction(random.uniform(-sim::pi, sim::pi));
        const sim::Point hit = sim::ahead(from, way, sim::ray_to_walls(from, way, 2.0));
        EXPECT_NEAR(std::max(std::fabs(hit.x_m), std::fabs(hit.y_m)), 2.0, 1e-12) << i;
    }
}

TEST(CircleGaps, ByHand) {
    const sim::Square square = sim::square_at({0.0, 0.0, 0.0}, 0.3);
    EXPECT_NEAR(sim::circle_square_gap({0.5, 0.1}, 0.2, square), 0.15, 1e-15);               // beside a side
    EXPECT_NEAR(sim::circle_square_gap({0.15 + 0.3, 0.15 + 0.4}, 0.2, square), 0.3, 1e-12);  // off a corner: 3-4-5
    EXPECT_NEAR(sim::circle_square_gap({0.3, 0.0}, 0.2, square), -0.05, 1e-15);              // reaches in
    EXPECT_NEAR(sim::circle_square_gap({0.1, 0.0}, 0.2, square), -0.25, 1e-15);              // centre inside
    EXPECT_NEAR(sim::circle_wall_gap({2.0, -1.0}, 0.2, 2.5), 0.3, 1e-15);
    EXPECT_NEAR(sim::circle_wall_gap({0.0, -2.4}, 0.2, 2.5), -0.1, 1e-15);
}

TEST(CircleGaps, AgreeWithTheNearestPointOfTheOutline) {
    sspql::Random random(13);
    for (int i = 0; i < 300; ++i) {
        const sim::Square square = random_square(random);
        const sim::Point centre = random_point(random);
        if (is_inside(square, centre)) continue;
        double nearest = sim::no_hit;
        constexpr int samples = 400;
        for (int k = 0; k < samples; ++k) {
            const double t = square.half_side_m * (2.0 * k / (samples - 1.0) - 1.0);
            const double h = square.half_side_m;
            for (const sim::Point& own : {sim::Point{t, h}, sim::Point{t, -h}, sim::Point{h, t}, sim::Point{-h, t}}) {
                const sim::Point p{square.centre.x_m + own.x_m * square.axis.x - own.y_m * square.axis.y,
                                   square.centre.y_m + own.x_m * square.axis.y + own.y_m * square.axis.x};
                nearest = std::min(nearest, sim::distance_m(centre, p));
            }
        }
        EXPECT_NEAR(sim::circle_square_gap(centre, 0.2, square), nearest - 0.2, 1e-3) << i;
    }
}

TEST(Fence, ByHand) {
    const sim::Point box{1.0, 1.0};
    EXPECT_NEAR(sim::distance_inside_fence({1.0, 1.0}, {1.0, 0.0}, 5.0, box, 1.3), 1.3, 1e-15);
    EXPECT_EQ(sim::distance_inside_fence({1.0, 1.0}, {1.0, 0.0}, 0.3, box, 1.3), 0.3);
    EXPECT_NEAR(sim::distance_inside_fence({2.0, 1.0}, {-1.0, 0.0}, 5.0, box, 1.3), 2.3, 1e-15);
    EXPECT_EQ(sim::distance_inside_fence({3.0, 1.0}, {1.0, 0.0}, 0.3, box, 1.3), 0.0);   // outside, away
    EXPECT_EQ(sim::distance_inside_fence({3.0, 1.0}, {-1.0, 0.0}, 0.3, box, 1.3), 0.3);  // outside, back
    EXPECT_NEAR(sim::distance_inside_fence({3.0, 1.0}, {-1.0, 0.0}, 9.0, box, 1.3), 3.3, 1e-12);
    EXPECT_NEAR(sim::distance_inside_fence({3.0, 3.0}, {-1.0, 0.0}, 9.0, box, 1.3), 2.0, 1e-12);  // the line misses it
}

TEST(Fence, NeverLeadsFartherOutThanAllowed) {
    sspql::Random random(14);
    for (int i = 0; i < 500; ++i) {
        const sim::Point from = random_point(random);
        const sim::Direction way = sim::direction(random.uniform(-sim::pi, sim::pi));
        const double radius = random.uniform(0.2, 1.5);
        const double most = sim::distance_inside_fence(from, way, 4.0, {}, radius);
        const double start_distance = sim::distance_m({}, from);
        for (int k = 0; k <= 100; ++k) {
            const double d = sim::distance_m({}, sim::ahead(from, way, most * k / 100.0));
            EXPECT_LE(d, std::max(radius, start_distance) + 1e-12);
        }
        if (most < 4.0) {  // one millimetre more would lead out
            const double here = sim::distance_m({}, sim::ahead(from, way, most));
            const double there = sim::distance_m({}, sim::ahead(from, way, most + 1e-3));
            EXPECT_GT(there, radius - 1e-12);
            EXPECT_GT(there, here - 1e-12);
        }
    }
}
