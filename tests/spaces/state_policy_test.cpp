// SPDX-License-Identifier: MIT
#include <sspql/spaces/state_policy.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

using sspql::state_id;
using sspql::StateId;

namespace {

struct Minimal {
    std::size_t size() const { return 2; }
    StateId encode(bool on) const { return state_id(on ? 1 : 0); }
};
struct Talkative : Minimal {
    std::string describe(StateId s) const { return s == state_id(1) ? "on" : "off"; }
};
struct Growing : Minimal {
    static constexpr bool grows = true;
};
struct Sizeless {
    StateId encode(bool) const { return state_id(0); }
};
struct Blind {
    std::size_t size() const { return 2; }
};
struct WrongId : Blind {
    std::string encode(bool) const { return "on"; }
};

}  // namespace

static_assert(sspql::is_state_policy_v<Minimal, bool>);
static_assert(!sspql::is_state_policy_v<Minimal, std::string>);
static_assert(!sspql::is_state_policy_v<Sizeless, bool>);
static_assert(!sspql::is_state_policy_v<Blind, bool>);
static_assert(!sspql::is_state_policy_v<WrongId, bool>);
static_assert(!sspql::grows_v<Minimal> && sspql::grows_v<Growing>);

TEST(StatePolicy, IsDescribedInItsOwnWordsIfItHasAny) {
    EXPECT_EQ(sspql::describe_state(Minimal{}, state_id(1)), "1");
    EXPECT_EQ(sspql::describe_state(Talkative{}, state_id(1)), "on");
}

TEST(StatePolicy, StatesOutsideAreRefusedWithTheirNumber) {
    EXPECT_EQ(sspql::detail::require_state_of(state_id(3), 4), state_id(3));
    try {
        sspql::detail::require_state_of(state_id(4), 4);
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "state must be below the number of states 4, got 4");
    }
}
