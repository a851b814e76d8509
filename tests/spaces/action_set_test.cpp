// SPDX-License-Identifier: MIT
#include <sspql/spaces/action_set.hpp>

#include <cstddef>
#include <stdexcept>

#include <gtest/gtest.h>

using sspql::action_id;
using sspql::ActionSet;

TEST(ActionSet, HoldsWhatWasInserted) {
    for (const std::size_t size : {1u, 63u, 64u, 65u, 128u, 200u, 256u}) {
        ActionSet set = ActionSet::none(size);
        EXPECT_TRUE(set.is_empty());
        EXPECT_EQ(set.size(), size);
        for (std::size_t a = 0; a < size; a += 3) set.insert(action_id(a));
        for (std::size_t a = 0; a < size; ++a) EXPECT_EQ(set.contains(action_id(a)), a % 3 == 0) << size << ", " << a;
        EXPECT_EQ(set.count(), (size + 2) / 3);
        for (std::size_t a = 0; a < size; a += 3) set.erase(action_id(a));
        EXPECT_TRUE(set.is_empty());
        EXPECT_EQ(set, ActionSet::none(size));
    }
}

TEST(ActionSet, AllHoldsAllAndNothingBeyond) {
    for (const std::size_t size : {1u, 64u, 100u, 256u}) {
        const ActionSet all = ActionSet::all(size);
        EXPECT_EQ(all.count(), size);
        EXPECT_FALSE(all.is_empty());
        EXPECT_TRUE(all.contains(action_id(size - 1)));
        EXPECT_FALSE(all.contains(action_id(size)));
        EXPECT_FALSE(all.contains(action_id(size + 300)));
    }
}

TEST(ActionSet, LastWordAloneIsNotEmpty) { EXPECT_FALSE(ActionSet::of(256, {action_id(255)}).is_empty()); }

TEST(ActionSet, ComparesSizeAndContent) {
    EXPECT_EQ(ActionSet::of(4, {action_id(1)}), ActionSet::of(4, {action_id(1), action_id(1)}));
    EXPECT_NE(ActionSet::of(4, {action_id(1)}), ActionSet::of(4, {action_id(2)}));
    EXPECT_NE(ActionSet::of(4, {action_id(1)}), ActionSet::of(5, {action_id(1)}));
}

TEST(ActionSet, RefusesSizesAndActionsOutside) {
    EXPECT_THROW((void)ActionSet::none(0), std::invalid_argument);
    EXPECT_THROW((void)ActionSet::all(257), std::invalid_argument);
    EXPECT_THROW((void)ActionSet::of(4, {action_id(4)}), std::invalid_argument);
    ActionSet set = ActionSet::all(4);
    EXPECT_THROW(set.insert(action_id(4)), std::invalid_argument);
    EXPECT_THROW(set.erase(action_id(4)), std::invalid_argument);
    EXPECT_EQ(set, ActionSet::all(4));
}
