// SPDX-License-Identifier: MIT
#include <sspql/sim/mission/mission_start.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace sim = sspql::sim;

namespace {

sim::PusherParams mission_world() {
    sim::PusherParams params;
    params.body.shape = sim::BodyShape::rectangle;
    return params;
}

std::string refusal(const sim::Point& box, const sim::Point& goal) {
    try {
        sim::require_pushable(mission_world(), box, goal);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST(MissionStart, RandomOnesKeepTheRules) {
    const sim::PusherParams params = mission_world();
    const sim::StartRules rules;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        sspql::Random random(seed);
        const sim::MissionStart start = sim::random_mission_start(params, random);
        EXPECT_LE(std::max(std::fabs(start.box.x_m), std::fabs(start.box.y_m)), 2.5 - rules.box_wall_m) << seed;
        EXPECT_LE(std::max(std::fabs(start.goal.x_m), std::fabs(start.goal.y_m)), 2.5 - rules.goal_wall_m) << seed;
        EXPECT_GE(sim::distance_m(sim::position(start.box), start.goal), rules.goal_box_m) << seed;
        EXPECT_GE(sim::box_gap_m(params.body, start.robot, sim::square_at(start.box, 0.3)), 0.1) << seed;
        EXPECT_GE(sim::wall_gap_m(params.body, start.robot, 2.5), 0.1 - 1e-12) << seed;
        EXPECT_NO_THROW(sim::require_pushable(params, sim::position(start.box), start.goal)) << seed;
        sspql::Random again(seed);
        EXPECT_TRUE(sim::random_mission_start(params, again).robot == start.robot) << seed;
    }
}

TEST(MissionStart, GivenPlacesStay) {
    sspql::Random random(1);
    const sim::Point box{0.5, -0.5};
    const sim::Point goal{1.8, 0.3};
    const sim::MissionStart start = sim::random_mission_start(mission_world(), random, &box, &goal);
    EXPECT_TRUE(sim::position(start.box) == box);
    EXPECT_TRUE(start.goal == goal);
    const sim::MissionStart other = sim::random_mission_start(mission_world(), random, &box, nullptr);
    EXPECT_TRUE(sim::position(other.box) == box);
    const sim::Point corner{2.2, 2.2};
    EXPECT_THROW(sim::random_mission_start(mission_world(), random, &corner, &goal), std::invalid_argument);
}

TEST(MissionStart, SaysWhatCannotBeReached) {
    EXPECT_EQ(refusal({0.0, 0.0}, {1.3, 0.0}), "accepted");
    EXPECT_TRUE(has(refusal({2.2, 2.2}, {0.0, 0.0}), "the box at (2.2, 2.2) cannot be pushed towards the goal"));
    EXPECT_EQ(refusal({2.2, 0.0}, {2.2, 1.5}), "accepted");  // along the wall there is room behind it ...
    EXPECT_TRUE(has(refusal({2.2, 0.0}, {0.0, 0.0}), "no room behind it, at (2.75, 0)"));  // ... away from it none
    EXPECT_TRUE(has(refusal({0.0, 0.0}, {2.6, 0.0}), "the goal at (2.6, 0) is unreachable"));
    EXPECT_TRUE(has(refusal({0.0, 0.0}, {2.4, 0.0}), "unreachable"));
    EXPECT_TRUE(has(refusal({2.4, 0.0}, {0.0, 0.0}), "reaches into a wall"));
    EXPECT_TRUE(has(refusal({0.0, 0.0}, {0.0, 0.0}), "already"));
    EXPECT_TRUE(has(refusal({NAN, 0.0}, {0.0, 0.0}), "finite"));
}
