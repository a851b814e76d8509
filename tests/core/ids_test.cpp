// SPDX-License-Identifier: MIT
#include <sspql/core/ids.hpp>

#include <cstddef>
#include <stdexcept>
#include <type_traits>

#include <gtest/gtest.h>

using sspql::ActionId;
using sspql::StateId;

static_assert(sizeof(StateId) == 4 && sizeof(ActionId) == 4);
static_assert(!std::is_convertible_v<StateId, ActionId>, "a state does not pass for an action");
static_assert(!std::is_convertible_v<int, StateId> && !std::is_convertible_v<StateId, int>);
static_assert(sspql::index(sspql::state_id(7)) == 7 && sspql::index(sspql::action_id(7)) == 7);

TEST(Ids, AreIndices) {
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}, std::size_t{1000000}, sspql::max_ids - 1}) {
        EXPECT_EQ(sspql::index(sspql::state_id(i)), i);
        EXPECT_EQ(sspql::index(sspql::action_id(i)), i);
    }
}

TEST(Ids, NoneIsBeyondEveryId) {
    EXPECT_EQ(sspql::index(sspql::no_state), sspql::max_ids);
    EXPECT_EQ(sspql::index(sspql::no_action), sspql::max_ids);
    EXPECT_LT(sspql::state_id(sspql::max_ids - 1), sspql::no_state);
}

TEST(Ids, CountsLeaveRoomForNone) {
    EXPECT_EQ(sspql::detail::require_id_count("n", 1), 1u);
    EXPECT_EQ(sspql::detail::require_id_count("n", 4294967294u), 4294967294u);
    EXPECT_THROW(sspql::detail::require_id_count("n", 0), std::invalid_argument);
    EXPECT_THROW(sspql::detail::require_id_count("n", 4294967295u), std::invalid_argument);
}
