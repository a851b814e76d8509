// SPDX-License-Identifier: MIT
#include <sspql/spaces/action_policy.hpp>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

using sspql::action_id;
using sspql::ActionId;
using sspql::ActionTable;
using sspql::EnumActions;

namespace {

struct Drive {
    double left = 0.0;
    double right = 0.0;
};
enum class Move { north, east, south, west };

struct Spoken {
    std::size_t size() const { return 1; }
    Move decode(ActionId) const { return Move::north; }
    std::string describe(ActionId) const { return "go north"; }
};
struct Sizeless {
    Move decode(ActionId) const { return Move::north; }
};
struct Mute {
    std::size_t size() const { return 1; }
};

}  // namespace

static_assert(sspql::is_action_policy_v<ActionTable<Drive>>);
static_assert(sspql::is_action_policy_v<EnumActions<Move>>);
static_assert(!sspql::is_action_policy_v<Sizeless> && !sspql::is_action_policy_v<Mute>);
static_assert(std::is_same_v<sspql::CommandOf<ActionTable<Drive>>, Drive>, "by value");
static_assert(std::is_same_v<sspql::CommandOf<EnumActions<Move>>, Move>);

TEST(ActionTable, DecodesToTheListedCommand) {
    const ActionTable<Drive> table{{1.0, 1.0}, {-1.0, 1.0}, {1.0, -1.0}};
    EXPECT_EQ(table.size(), 3u);
    EXPECT_EQ(table.decode(action_id(1)).left, -1.0);
    EXPECT_EQ(table.decode(action_id(2)).right, -1.0);
    EXPECT_EQ(ActionTable<int>(std::vector<int>(300, 7)).decode(action_id(299)), 7);
}

TEST(ActionTable, RefusesAnEmptyListAndActionsOutside) {
    EXPECT_THROW(ActionTable<int>(std::vector<int>{}), std::invalid_argument);
    const ActionTable<int> table{5, 6};
    EXPECT_THROW((void)table.decode(sspql::no_action), std::invalid_argument);
    try {
        (void)table.decode(action_id(2));
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "action must be below the number of actions 2, got 2");
    }
}

TEST(EnumActions, DecodesToTheValue) {
    const EnumActions<Move> moves(4);
    EXPECT_EQ(moves.size(), 4u);
    EXPECT_EQ(moves.decode(action_id(0)), Move::north);
    EXPECT_EQ(moves.decode(action_id(3)), Move::west);
    EXPECT_THROW((void)moves.decode(action_id(4)), std::invalid_argument);
    EXPECT_THROW(EnumActions<Move>(0), std::invalid_argument);
    EXPECT_EQ(EnumActions<int>(10).decode(action_id(9)), 9);
}

TEST(ActionPolicy, IsDescribedInItsOwnWordsIfItHasAny) {
    EXPECT_EQ(sspql::describe_action(Spoken{}, action_id(0)), "go north");
    EXPECT_EQ(sspql::describe_action(EnumActions<Move>(4), action_id(2)), "2");
}
