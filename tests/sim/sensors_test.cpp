// SPDX-License-Identifier: MIT
// Sensors against numbers worked out by hand.
#include <sspql/sim/sensors/sensor_suite.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <sspql/sim/box2d_backend.hpp>
#include <sspql/sim/kinematic_backend.hpp>

namespace sim = sspql::sim;
using sim::Scene;
using sim::SensorParams;

namespace {

SensorParams exact() {
    SensorParams params;
    params.noise = 0.0;
    return params;
}

/// A round robot of radius 0.2, a box of side 0.3 in the middle, the goal 1.3 m behind it.
Scene scene_with(const sim::Pose& robot, const sim::Pose& box = {}, const sim::Point& goal = {1.3, 0.0}) {
    return {robot, sim::square_at(box, 0.3), box.heading_rad, goal, sim::RobotBody{}, 2.5};
}

}  // namespace

TEST(SonarRing, ReadsBoxAndWallsByHand) {
    const sim::SonarRing ring(exact());
    sspql::Random random(1);
    const auto readings = ring.read(scene_with({-1.0, 0.0, 0.0}), random);
    EXPECT_NEAR(readings[0], 1.0 - 0.2 - 0.15, 1e-12);            // the box ahead
    EXPECT_NEAR(readings[8], 1.5 - 0.2, 1e-12);                   // the wall behind, at -2.5
    EXPECT_NEAR(readings[4], 2.5 - 0.2, 1e-12);                   // the wall on the left
    EXPECT_NEAR(readings[12], 2.5 - 0.2, 1e-12);                  // ... and on the right
    EXPECT_NEAR(readings[6], 1.5 * std::sqrt(2.0) - 0.2, 1e-12);  // 135 degrees: the rear wall
    EXPECT_NEAR(sim::SonarRing::bearing_rad(8), sim::pi, 1e-12);
    EXPECT_NEAR(sim::SonarRing::bearing_rad(15), sim::from_degrees(-22.5), 1e-12);
    // Turned by one sonar's spacing the same things are read by the neighbours.
    const auto turned = ring.read(scene_with({-1.0, 0.0, sim::from_degrees(22.5)}), random);
    EXPECT_NEAR(turned[15], 0.65, 1e-12);
    EXPECT_NEAR(turned[7], 1.3, 1e-12);
}

TEST(SonarRing, ARectangularRobotsSonarsSitOnItsOutline) {
    Scene scene = scene_with({-1.0, 0.0, 0.0});
    scene.body.shape = sim::BodyShape::rectangle;
    sspql::Random random(1);
    const auto readings = sim::SonarRing(exact()).read(scene, random);
    EXPECT_NEAR(readings[0], 1.0 - 0.20 - 0.15, 1e-12);
    EXPECT_NEAR(readings[4], 2.5 - 0.172, 1e-12);
}

TEST(SonarRing, RangeIsLimitedAndReadingsAreNeverNegative) {
    SensorParams params;
    params.sonar_range_m = 1.0;
    params.sonar_noise_m = 0.5;
    sspql::Random random(3);
    for (int i = 0; i < 50; ++i) {
        for (const double reading : sim::SonarRing(params).read(scene_with({-0.4, 0.0, 0.0}), random)) {
            EXPECT_GE(reading, 0.0);
            EXPECT_LE(reading, 1.0);
        }
    }
}

TEST(RangeFinder, ScansByHand) {
    const sim::RangeFinder finder(exact());
    sspql::Random random(1);
    const auto readings = finder.read(scene_with({-1.0, 0.0, 0.0}), random);
    EXPECT_NEAR(finder.bearing_rad(0), sim::from_degrees(-90.0), 1e-12);
    EXPECT_NEAR(finder.bearing_rad(45), 0.0, 1e-12);
    EXPECT_NEAR(finder.bearing_rad(46), sim::from_degrees(2.0), 1e-12);
    EXPECT_NEAR(readings[45], 0.85, 1e-12);
    EXPECT_NEAR(readings[0], 2.5, 1e-9);
    EXPECT_NEAR(readings[90], 2.5, 1e-9);
    // The box spans atan(0.15 / 0.85) = 10.01 degrees to either side: beams at 10 degrees hit it, at 12 miss it.
    EXPECT_NEAR(readings[50], 0.85 / std::cos(sim::from_degrees(10.0)), 1e-12);
    EXPECT_NEAR(readings[51],
                2.5 / std::sin(sim::from_degrees(12.0)) > 3.5 / std::cos(sim::from_degrees(12.0))
                    ? 3.5 / std::cos(sim::from_degrees(12.0))
                    : 2.5 / std::sin(sim::from_degrees(12.0)),
                1e-12);
    EXPECT_NEAR(finder.nearest_m(readings, 0.0, sim::from_degrees(30.0)), 0.85, 1e-12);
    EXPECT_NEAR(finder.nearest_m(readings, sim::from_degrees(12.0), sim::from_degrees(2.0)), readings[50], 1e-12);
    EXPECT_NEAR(finder.nearest_m(readings, sim::from_degrees(-170.0), 0.01), readings[0], 1e-12);
}

TEST(Camera, BearingsAndFieldOfViewEdges) {
    const sim::Camera camera(exact());
    sspql::Random random(1);
    // The box 1 m ahead, the goal beside it, seen at atan2(0.5, 2) to the left.
    const auto view = camera.look(scene_with({-1.0, 0.0, 0.0}, {}, {1.0, 0.5}), random);
    ASSERT_TRUE(view.box && view.goal);
    EXPECT_NEAR(view.box->bearing_rad, 0.0, 1e-12);
    EXPECT_NEAR(view.goal->bearing_rad, std::atan2(0.5, 2.0), 1e-12);
    EXPECT_NEAR(view.goal->range_m, std::sqrt(4.25), 1e-12);
    // Turned by just less than 30 degrees both ways the box is still there, by just more it is gone.
    for (const double side : {-1.0, 1.0}) {
        EXPECT_TRUE(camera.sees_box(scene_with({-1.0, 0.0, side * sim::from_degrees(29.999)})));
        EXPECT_FALSE(camera.sees_box(scene_with({-1.0, 0.0, side * sim::from_degrees(30.001)})));
    }
    EXPECT_FALSE(camera.sees_box(scene_with({-1.0, 0.0, sim::pi})));
}

TEST(Camera, TheBoxHidesTheGoal) {
    const sim::Camera camera(exact());
    // Robot 1 m before the box: its near corners at 0.85 m stand 0.15 to each side. On the line through a corner the
    // goal's plane at 2.3 m is hidden up to 0.15 * 2.3 / 0.85 = 0.406 m; the goal's sides stand 0.3 m off its centre.
    EXPECT_EQ(camera.goal_sides_in_view(scene_with({-1.0, 0.0, 0.0})), 0);
    EXPECT_EQ(camera.goal_sides_in_view(scene_with({-1.0, 0.0, 0.0}, {}, {1.3, 0.09})), 0);  // side at 0.39: hidden
    EXPECT_EQ(camera.goal_sides_in_view(scene_with({-1.0, 0.0, 0.0}, {}, {1.3, 0.15})), 1);  // 0.45: the left one shows
    EXPECT_EQ(camera.goal_sides_in_view(scene_with({-1.0, 0.0, 0.0}, {}, {1.3, -0.15})), 1);
    EXPECT_EQ(camera.goal_sides_in_view(scene_with({-1.0, 0.0, 0.0}, {}, {1.3, 0.42})), 2);  // the centre shows
    // The box in the middle of the goal: both sides show. The goal before the box: nothing hides it.
    EXPECT_EQ(camera.goal_sides_in_view(scene_with({-1.0, 0.0, 0.0}, {}, {0.0, 0.0})), 2);
    EXPECT_EQ(camera.goal_sides_in_view(scene_with({-1.5, 0.0, 0.0}, {}, {-0.6, 0.0})), 2);
    // Close to the box nothing of a goal behind it is left.
    EXPECT_EQ(camera.goal_sides_in_view(scene_with({-0.36, 0.0, 0.0})), 0);
    EXPECT_TRUE(camera.sees_box(scene_with({-0.36, 0.0, 0.0})));
}

TEST(Camera, AWallHidesWhatIsBehindIt) {
    const sim::Camera camera(exact());
    EXPECT_EQ(camera.goal_sides_in_view(scene_with({1.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}, {2.4, 0.0})), 2);
    EXPECT_EQ(camera.goal_sides_in_view(scene_with({1.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}, {2.6, 0.0})), 0);
    // Half behind the wall on the left: the right side is enough.
    EXPECT_EQ(camera.goal_sides_in_view(scene_with({0.0, 2.0, 0.0}, {-1.0, 0.0, 0.0}, {2.0, 2.6})), 1);
    EXPECT_FALSE(camera.sees_box(scene_with({1.0, 0.0, 0.0}, {2.7, 0.0, 0.0})));
}

TEST(Odometer, DistanceTurnAndBack) {
    const sim::Pose from{1.0, 2.0, 0.5};
    for (const sim::Travel travel : {sim::Travel{0.3, 0.2}, {-0.2, 0.0}, {0.0, -1.0}}) {
        const sim::Pose to = sim::moved(from, travel);
        const sim::Travel back = sim::travel_between(from, to);
        EXPECT_NEAR(back.distance_m, travel.distance_m, 1e-12);
        EXPECT_NEAR(back.turn_rad, travel.turn_rad, 1e-12);
    }
    // Wheels do not feel a slide to the side.
    EXPECT_NEAR(sim::travel_between({0.0, 0.0, 0.0}, {0.1, 0.05, 0.0}).distance_m, 0.1, 1e-12);
    sspql::Random random(1);
    const sim::Travel read = sim::Odometer(exact()).read({0.0, 0.0, 3.1}, {0.0, 0.0, -3.1}, random);
    EXPECT_NEAR(read.turn_rad, 2.0 * sim::pi - 6.2, 1e-12);
}

TEST(SensorSuite, OneFactorScalesAllNoise) {
    const Scene scene = scene_with({-1.0, 0.3, -0.2}, {}, {1.3, 1.0});
    sim::SensorSuite none(exact());
    none.reset(7);
    const sim::SensorReadings truth = none.look(scene);
    const sim::Travel travel = none.travelled({}, {0.3, 0.0, 0.1});
    ASSERT_TRUE(truth.view.box && truth.view.goal);
    for (const double factor : {1.0, 2.0}) {
        double sonar = 0.0;
        double scan = 0.0;
        double bearing = 0.0;
        double range = 0.0;
        double distance = 0.0;
        double turn = 0.0;
        SensorParams params;
        params.noise = factor;
        sim::SensorSuite suite(params);
        suite.reset(7);
        constexpr int n = 4000;
        const auto square = [](double x) { return x * x / n; };
        for (int i = 0; i < n; ++i) {
            const sim::SensorReadings read = suite.look(scene);
            const sim::Travel way = suite.travelled({}, {0.3, 0.0, 0.1});
            sonar += square(read.sonars[3] - truth.sonars[3]);
            scan += square(read.ranges[20] - truth.ranges[20]);
            bearing += square(read.view.box->bearing_rad - truth.view.box->bearing_rad);
            range += square(read.view.goal->range_m / truth.view.goal->range_m - 1.0);
            distance += square(way.distance_m / travel.distance_m - 1.0);
            turn += square(way.turn_rad / travel.turn_rad - 1.0);
        }
        EXPECT_NEAR(std::sqrt(sonar), 0.01 * factor, 0.0006 * factor);
        EXPECT_NEAR(std::sqrt(scan), 0.01 * factor, 0.0006 * factor);
        EXPECT_NEAR(std::sqrt(bearing), sim::from_degrees(1.0) * factor, 0.06 * sim::from_degrees(1.0) * factor);
        EXPECT_NEAR(std::sqrt(range), 0.03 * factor, 0.0018 * factor);
        EXPECT_NEAR(std::sqrt(distance), 0.02 * factor, 0.0012 * factor);
        EXPECT_NEAR(std::sqrt(turn), 0.02 * factor, 0.0012 * factor);
    }
}

TEST(SensorSuite, SameSeedSameReadingsAndDrawsDoNotDependOnTheView) {
    const Scene seen = scene_with({-1.0, 0.3, 0.0}, {}, {1.3, 1.0});
    const Scene unseen = scene_with({-1.0, 0.3, sim::pi}, {}, {1.3, 1.0});
    sim::SensorSuite a;
    sim::SensorSuite b;
    a.reset(5);
    b.reset(5);
    static_cast<void>(a.look(seen));
    static_cast<void>(b.look(unseen));
    const sim::SensorReadings x = a.look(seen);
    const sim::SensorReadings y = b.look(seen);
    EXPECT_EQ(x.sonars, y.sonars);
    EXPECT_EQ(x.ranges, y.ranges);
    EXPECT_EQ(x.view.goal->range_m, y.view.goal->range_m);
    b.reset(6);
    EXPECT_NE(b.look(seen).sonars, x.sonars);
}

TEST(Scene, IsTheSameOnBothBackends) {
    sim::PusherParams params;
    params.body.shape = sim::BodyShape::rectangle;
    sim::KinematicBackend plain(params);
    sim::Box2dBackend physics(params);
    const sim::Pose robot{-1.25, 0.5, -0.5};  // exact in single precision, as Box2D keeps it
    plain.reset(robot, {0.25, 0.0, 0.5}, {1.5, 0.5});
    physics.reset(robot, {0.25, 0.0, 0.5}, {1.5, 0.5});
    sspql::Random first(1);
    sspql::Random second(1);
    const auto a = sim::SonarRing(exact()).read(sim::scene_of(plain), first);
    const auto b = sim::SonarRing(exact()).read(sim::scene_of(physics), second);
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-9) << i;
    EXPECT_EQ(sim::scene_of(plain).goal, sim::scene_of(physics).goal);
}

TEST(SensorParams, RefuseWhatIsNone) {
    const auto refused = [](auto change) {
        SensorParams params;
        change(params);
        EXPECT_THROW(sim::SensorSuite{params}, std::invalid_argument);
    };
    refused([](auto& p) { p.noise = -1.0; });
    refused([](auto& p) { p.noise = std::numeric_limits<double>::quiet_NaN(); });
    refused([](auto& p) { p.camera_field_rad = 0.0; });
    refused([](auto& p) { p.camera_field_rad = 4.0; });
    refused([](auto& p) { p.scan_range_m = 0.0; });
    refused([](auto& p) { p.odometry_turn_noise = -0.1; });
    refused([](auto& p) { p.goal_radius_m = 0.0; });
}
