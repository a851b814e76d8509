// SPDX-License-Identifier: MIT
#include <sspql/sim/pusher_spaces.hpp>

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <sspql/spaces/action_policy.hpp>
#include <sspql/spaces/state_policy.hpp>

namespace sim = sspql::sim;
using sspql::action_id;
using sspql::index;
using sspql::state_id;

static_assert(sspql::is_state_policy_v<sim::ApproachState, sim::PusherObservation>);
static_assert(sspql::is_state_policy_v<sim::TurnState, sim::PusherObservation>);
static_assert(sspql::is_action_policy_v<sim::ApproachActions>);
static_assert(sspql::is_action_policy_v<sim::TurnActions>);

TEST(ApproachState, EncodesInTheBoxFrame) {
    const sim::ApproachState policy;
    EXPECT_EQ(policy.size(), 432u);
    // Goal straight up from the box; robot 0.8 m below the box, looking left: behind (sector 6), ring 1,
    // heading 180 - 90 = 90 deg (bin 3). (1 * 12 + 6) * 12 + 3 = 219.
    const sim::PusherObservation seen{{1.0, 0.2, sim::pi}, {1.0, 1.0, 0.4}, {1.0, 2.0}};
    EXPECT_EQ(index(policy.encode(seen)), 219u);
    EXPECT_EQ(policy.describe(state_id(219)), "0.7 m <= r < 1 m, sector 180 deg (A), heading 90 deg");
    sim::PusherObservation no_way = seen;
    no_way.goal = {1.0, 1.0};
    EXPECT_THROW((void)policy.encode(no_way), std::invalid_argument);
    sim::PusherObservation blind = seen;
    blind.robot.heading_rad = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW((void)policy.encode(blind), std::invalid_argument);
}

TEST(TurnState, KeepsTheHeadingOnly) {
    const sim::TurnState policy;
    EXPECT_EQ(policy.size(), 12u);
    for (std::size_t bin = 0; bin < 12; ++bin) {
        const double heading = sim::from_degrees(90.0 + 30.0 * static_cast<double>(bin));
        EXPECT_EQ(index(policy.encode({{0.3, 0.1, heading}, {1.0, 1.0, 0.0}, {1.0, 2.0}})), bin);
    }
    EXPECT_EQ(policy.describe(state_id(11)), "heading 330 deg");
    EXPECT_THROW((void)policy.describe(state_id(12)), std::invalid_argument);
}

TEST(PusherActions, AreThoseOfThePaper) {
    const sim::ApproachActions approach;
    ASSERT_EQ(approach.size(), 4u);
    EXPECT_EQ(approach.decode(action_id(0)).motion, sim::Motion::translate);
    EXPECT_EQ(approach.decode(action_id(0)).amount, 0.3);
    EXPECT_EQ(approach.decode(action_id(1)).motion, sim::Motion::translate);
    EXPECT_EQ(approach.decode(action_id(1)).amount, -0.2);
    EXPECT_EQ(approach.decode(action_id(2)).motion, sim::Motion::rotate);
    EXPECT_DOUBLE_EQ(approach.decode(action_id(2)).amount, sim::pi / 6.0);
    EXPECT_EQ(approach.decode(action_id(3)).motion, sim::Motion::rotate);
    EXPECT_DOUBLE_EQ(approach.decode(action_id(3)).amount, -sim::pi * 25.0 / 180.0);
    EXPECT_EQ(approach.describe(action_id(3)), "turn -25 deg");
    EXPECT_THROW((void)approach.decode(action_id(4)), std::invalid_argument);
    EXPECT_THROW((void)approach.describe(sspql::no_action), std::invalid_argument);

    const sim::TurnActions turn;
    ASSERT_EQ(turn.size(), 2u);
    for (std::size_t a = 0; a < 2; ++a) {
        EXPECT_EQ(turn.decode(action_id(a)).motion, sim::Motion::rotate);
        EXPECT_EQ(turn.decode(action_id(a)).amount, approach.decode(action_id(a + 2)).amount);
        EXPECT_EQ(turn.describe(action_id(a)), approach.describe(action_id(a + 2)));
    }
    EXPECT_THROW((void)turn.decode(action_id(2)), std::invalid_argument);
    EXPECT_THROW((void)turn.describe(action_id(2)), std::invalid_argument);
}
