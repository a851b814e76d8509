// SPDX-License-Identifier: MIT
#include <sspql/spaces/legal_actions.hpp>

#include <cstddef>
#include <stdexcept>

#include <gtest/gtest.h>

using sspql::action_id;
using sspql::ActionId;
using sspql::ActionSet;
using sspql::AllActions;
using sspql::LegalActionTable;
using sspql::state_id;
using sspql::StateId;

namespace {

/// A user's: a number of the least action of each state.
struct AtLeast {
    struct Allowed {
        std::size_t least;
        bool contains(ActionId a) const { return sspql::index(a) >= least; }
    };
    Allowed allowed(StateId s) const { return {sspql::index(s)}; }
};
struct Nothing {};
struct WrongAnswer {
    int allowed(StateId) const { return 0; }
};

bool allows(const LegalActionTable& table, std::size_t s, std::size_t a) {
    return table.allowed(state_id(s)).contains(action_id(a));
}

}  // namespace

static_assert(sspql::is_legal_actions_v<LegalActionTable> && sspql::stores_masks_v<LegalActionTable>);
static_assert(sspql::is_legal_actions_v<AllActions> && !sspql::stores_masks_v<AllActions>);
static_assert(sspql::is_legal_actions_v<AtLeast> && !sspql::stores_masks_v<AtLeast>);
static_assert(!sspql::is_legal_actions_v<Nothing> && !sspql::is_legal_actions_v<WrongAnswer>);
static_assert(AllActions{}.allowed(state_id(3)).contains(action_id(99)));

TEST(LegalActionTable, AllowsEverythingWhereNoMaskWasGiven) {
    LegalActionTable table;
    EXPECT_EQ(table.actions(), 0u);
    EXPECT_TRUE(allows(table, 0, 0));
    EXPECT_TRUE(allows(table, 4000000000u, 250));
    table.set(state_id(5), ActionSet::of(3, {action_id(1)}));
    EXPECT_EQ(table.actions(), 3u);
    for (const std::size_t s : {0u, 4u, 6u, 1000u}) {
        for (std::size_t a = 0; a < 3; ++a) EXPECT_TRUE(allows(table, s, a)) << s;
    }
}

TEST(LegalActionTable, LastMaskOfAStateHolds) {
    LegalActionTable table;
    table.set(state_id(2), ActionSet::of(3, {action_id(0)}));
    table.set(state_id(1), ActionSet::of(3, {action_id(1)}));
    table.set(state_id(2), ActionSet::of(3, {action_id(2)}));
    EXPECT_FALSE(allows(table, 2, 0));
    EXPECT_FALSE(allows(table, 2, 1));
    EXPECT_TRUE(allows(table, 2, 2));
    EXPECT_TRUE(allows(table, 1, 1));
    EXPECT_FALSE(allows(table, 1, 2));
}

TEST(LegalActionTable, KeepsMasksOfMoreThan64Actions) {
    for (const std::size_t actions : {64u, 65u, 130u, 256u}) {
        LegalActionTable table;
        table.reserve(50, actions);
        for (std::size_t s = 0; s < 50; ++s) {
            ActionSet mask = ActionSet::none(actions);
            for (std::size_t a = s % 2; a < actions; a += 2 + s % 5) mask.insert(action_id(a));
            table.set(state_id(s), mask);
        }
        for (std::size_t s = 0; s < 50; ++s) {
            for (std::size_t a = 0; a < actions; ++a) {
                EXPECT_EQ(allows(table, s, a), a >= s % 2 && (a - s % 2) % (2 + s % 5) == 0) << s << ", " << a;
            }
        }
    }
}

TEST(LegalActionTable, RefusesEmptyMasksAndOtherSizes) {
    LegalActionTable table;
    EXPECT_THROW(table.set(state_id(0), ActionSet::none(3)), std::invalid_argument);
    table.set(state_id(0), ActionSet::of(3, {action_id(2)}));
    EXPECT_THROW(table.set(state_id(1), ActionSet::all(4)), std::invalid_argument);
    EXPECT_THROW(table.set(state_id(0), ActionSet::none(3)), std::invalid_argument);
    EXPECT_FALSE(allows(table, 0, 0)) << "a refused mask changes nothing";
    EXPECT_TRUE(allows(table, 0, 2));
}

TEST(LegalActionTable, ClearedTakesMasksOfAnotherSize) {
    LegalActionTable table;
    table.set(state_id(3), ActionSet::of(3, {action_id(2)}));
    table.clear();
    EXPECT_TRUE(allows(table, 3, 0));
    EXPECT_EQ(table.actions(), 0u);
    table.set(state_id(3), ActionSet::of(100, {action_id(99)}));
    EXPECT_FALSE(allows(table, 3, 98));
    EXPECT_TRUE(allows(table, 3, 99));
    EXPECT_TRUE(allows(table, 2, 98));
}

TEST(LegalActions, CanBeTheUsersOwn) {
    const AtLeast legal;
    EXPECT_FALSE(legal.allowed(state_id(2)).contains(action_id(1)));
    EXPECT_TRUE(legal.allowed(state_id(2)).contains(action_id(2)));
}
