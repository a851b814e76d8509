// SPDX-License-Identifier: MIT
#include <sspql/sim/box_frame.hpp>

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <sspql/spaces/polar_grid.hpp>

namespace sim = sspql::sim;

namespace {

void expect_pose(const sim::Pose& pose, double x_m, double y_m, double heading_deg) {
    EXPECT_NEAR(pose.x_m, x_m, 1e-12);
    EXPECT_NEAR(pose.y_m, y_m, 1e-12);
    EXPECT_NEAR(std::remainder(pose.heading_rad - sim::from_degrees(heading_deg), 2.0 * sim::pi), 0.0, 1e-12);
}

}  // namespace

TEST(BoxFrame, GoalAlongXOnlyMovesTheOrigin) {
    // phi = 0: p' = p - box = (3 - 1, 4 - 2).
    expect_pose(sim::to_box_frame({3.0, 4.0, 0.5}, {1.0, 2.0}, {5.0, 2.0}), 2.0, 2.0, sim::to_degrees(0.5));
}

TEST(BoxFrame, GoalUp) {
    // Goal straight up: phi = 90 deg. Robot 1 m right of the box: turned by -90 deg it is at (0, -1), right of the way.
    // It looks up = along the way: 0 deg.
    expect_pose(sim::to_box_frame({2.0, 1.0, sim::pi / 2.0}, {1.0, 1.0}, {1.0, 3.0}), 0.0, -1.0, 0.0);
}

TEST(BoxFrame, AllFourQuadrantsOfTheGoal) {
    // Robot 2 m behind the box on the line through the goal, looking along +x: always at (-2, 0), looking -phi.
    // A bare arctan(dy / dx) would take 135 deg for -45 deg and 225 deg for 45 deg.
    for (const double phi_deg : {45.0, 135.0, 225.0, 315.0}) {
        const double phi = sim::from_degrees(phi_deg);
        const sim::Point box{0.3, -0.4};
        const sim::Point goal{0.3 + std::cos(phi), -0.4 + std::sin(phi)};
        const sim::Pose robot{0.3 - 2.0 * std::cos(phi), -0.4 - 2.0 * std::sin(phi), 0.0};
        SCOPED_TRACE(phi_deg);
        expect_pose(sim::to_box_frame(robot, box, goal), -2.0, 0.0, -phi_deg);
    }
}

TEST(BoxFrame, ThreeFourFive) {
    // Goal - box = (3, 4): cos phi = 0.6, sin phi = 0.8. Robot - box = (5, 0): x' = 5 * 0.6 = 3, y' = -5 * 0.8 = -4.
    // Heading 180 deg - 53.130102 deg = 126.869898 deg.
    expect_pose(sim::to_box_frame({6.0, 1.0, sim::pi}, {1.0, 1.0}, {4.0, 5.0}), 3.0, -4.0, 126.86989764584402);
}

TEST(BoxFrame, TheGoalItselfLiesOnPlusX) {
    for (int degrees = 0; degrees < 360; degrees += 7) {
        const double phi = sim::from_degrees(static_cast<double>(degrees));
        const sim::Point goal{1.0 + 1.3 * std::cos(phi), 2.0 + 1.3 * std::sin(phi)};
        expect_pose(sim::to_box_frame({goal.x_m, goal.y_m, phi}, {1.0, 2.0}, goal), 1.3, 0.0, 0.0);
    }
}

TEST(BoxFrame, ThePrintPutsTheRobotAtTheMirrorPoint) {
    // Eq. (10) as printed, in the robot's own frame (robot = origin, looking along +x): dx = -x_box, dy = -y_box and
    // robot' = R(-phi) (-dx, -dy) = R(-phi) (+box), the mirror image through the box of where the robot stands.
    const sim::Point box{1.0, 0.5};
    const sim::Point goal{2.0, 1.5};  // phi = 45 deg
    const double delta_theta = -std::atan((goal.y_m - box.y_m) / (goal.x_m - box.x_m));
    const double dx = -box.x_m;
    const double dy = -box.y_m;
    const double printed_x = (-dx) * std::cos(delta_theta) - (-dy) * std::sin(delta_theta);
    const double printed_y = (-dx) * std::sin(delta_theta) + (-dy) * std::cos(delta_theta);
    const sim::Pose ours = sim::to_box_frame({0.0, 0.0, 0.0}, box, goal);
    // R(-45 deg) (-1, -0.5) = (-1.5, 0.5) / sqrt(2): behind the box, to the left of the way. The print says in front.
    expect_pose(ours, -1.5 / std::sqrt(2.0), 0.5 / std::sqrt(2.0), -45.0);
    EXPECT_NEAR(printed_x, -ours.x_m, 1e-12);
    EXPECT_NEAR(printed_y, -ours.y_m, 1e-12);
    EXPECT_EQ(sim::box_cell(ours).sector, 5u);  // 161.6 deg
    EXPECT_EQ(sim::box_cell(sim::Pose{printed_x, printed_y, 0.0}).sector, 11u);
}

TEST(BoxFrame, RefusesWhatHasNoFrame) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, infinity, -infinity}) {
        EXPECT_THROW((void)sim::to_box_frame({bad, 0.0, 0.0}, {0.0, 0.0}, {1.0, 0.0}), std::invalid_argument);
        EXPECT_THROW((void)sim::to_box_frame({0.0, bad, 0.0}, {0.0, 0.0}, {1.0, 0.0}), std::invalid_argument);
        EXPECT_THROW((void)sim::to_box_frame({0.0, 0.0, bad}, {0.0, 0.0}, {1.0, 0.0}), std::invalid_argument);
        EXPECT_THROW((void)sim::to_box_frame({0.0, 0.0, 0.0}, {bad, 0.0}, {1.0, 0.0}), std::invalid_argument);
        EXPECT_THROW((void)sim::to_box_frame({0.0, 0.0, 0.0}, {0.0, bad}, {1.0, 0.0}), std::invalid_argument);
        EXPECT_THROW((void)sim::to_box_frame({0.0, 0.0, 0.0}, {0.0, 0.0}, {bad, 0.0}), std::invalid_argument);
        EXPECT_THROW((void)sim::to_box_frame({0.0, 0.0, 0.0}, {0.0, 0.0}, {1.0, bad}), std::invalid_argument);
    }
    EXPECT_THROW((void)sim::to_box_frame({0.0, 0.0, 0.0}, {0.5, 0.5}, {0.5, 0.5}), std::invalid_argument);
}

TEST(BoxCells, RingEdges) {
    EXPECT_EQ(sim::ring_of(0.0), 0u);
    EXPECT_EQ(sim::ring_of(std::nextafter(0.7, 0.0)), 0u);
    EXPECT_EQ(sim::ring_of(0.7), 1u);
    EXPECT_EQ(sim::ring_of(std::nextafter(1.0, 0.0)), 1u);
    EXPECT_EQ(sim::ring_of(1.0), 2u);
    EXPECT_EQ(sim::ring_of(100.0), 2u);
}

TEST(BoxCells, BinsAreCentredOnMultiplesOfThirtyDegrees) {
    for (int k = -12; k <= 24; ++k) {
        const auto expected = static_cast<std::size_t>((k + 24) % 12);
        for (const double off_deg : {-14.999, 0.0, 14.999}) {
            EXPECT_EQ(sim::thirty_degree_bin(sim::from_degrees(30.0 * k + off_deg)), expected) << k << " " << off_deg;
        }
    }
    EXPECT_EQ(sim::thirty_degree_bin(sim::pi), 6u);
    EXPECT_EQ(sim::thirty_degree_bin(-sim::pi), 6u);
    EXPECT_EQ(sim::thirty_degree_bin(-1e-18), 0u);
}

TEST(BoxCells, SectorAIsBehindTheBox) {
    EXPECT_TRUE(sim::in_push_sector({-0.5, 0.0, 1.0}));
    EXPECT_TRUE(sim::in_push_sector({-5.0, 1.3, 2.0}));    // 165.4 deg
    EXPECT_TRUE(sim::in_push_sector({-5.0, -1.3, -2.0}));  // -165.4 deg
    EXPECT_FALSE(sim::in_push_sector({-5.0, 1.4, 0.0}));   // 164.4 deg
    EXPECT_FALSE(sim::in_push_sector({0.5, 0.0, 0.0}));
}

TEST(BoxCells, EveryStateIsReachedDescribedAndDecoded) {
    std::set<std::string> texts;
    for (std::size_t ring = 0; ring < 3; ++ring) {
        for (std::size_t sector = 0; sector < 12; ++sector) {
            for (std::size_t bin = 0; bin < 12; ++bin) {
                const double radius = 0.5 + 0.35 * static_cast<double>(ring);  // 0.5, 0.85, 1.2
                const double psi = sim::from_degrees(30.0 * static_cast<double>(sector));
                const double theta = sim::wrap_angle(sim::from_degrees(30.0 * static_cast<double>(bin)));
                const sim::Pose pose{radius * std::cos(psi), radius * std::sin(psi), theta};
                const sspql::StateId s = sim::box_state(sim::box_cell(pose));
                EXPECT_EQ(sspql::index(s), (ring * 12 + sector) * 12 + bin);
                const sim::BoxCell cell = sim::box_cell(s);
                EXPECT_EQ(cell.ring, ring);
                EXPECT_EQ(cell.sector, sector);
                EXPECT_EQ(cell.heading_bin, bin);
                texts.insert(sim::describe_box_state(s));
            }
        }
    }
    EXPECT_EQ(texts.size(), 432u);
    EXPECT_EQ(sim::describe_box_state(sspql::state_id((1 * 12 + 6) * 12 + 1)),
              "0.7 m <= r < 1 m, sector 180 deg (A), heading 30 deg");
    EXPECT_EQ(sim::describe_box_state(sspql::state_id(0)), "r < 0.7 m, sector 0 deg, heading 0 deg");
    EXPECT_EQ(sim::describe_box_state(sspql::state_id(431)), "r >= 1 m, sector 330 deg, heading 330 deg");
    EXPECT_THROW((void)sim::describe_box_state(sspql::state_id(432)), std::invalid_argument);
    EXPECT_THROW((void)sim::box_cell(sspql::no_state), std::invalid_argument);
}

TEST(BoxCells, PositionsAreThoseOfPolarGrid) {
    const sspql::PolarGrid grid(12, {0.7, 1.0});
    for (int i = -13; i <= 13; ++i) {
        for (int j = -13; j <= 13; ++j) {
            const double place[2] = {0.1 * i, 0.1 * j};
            const sim::BoxCell cell = sim::box_cell(sim::Pose{place[0], place[1], 0.0});
            EXPECT_EQ(cell.ring * 12 + cell.sector, sspql::index(grid.encode(place))) << i << " " << j;
        }
    }
}
