// SPDX-License-Identifier: MIT
#include <sspql/spaces/hashed_state.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

using sspql::HashedState;
using sspql::index;
using sspql::state_id;

namespace {

/// Two integers that all fall into the same bucket, compared without regard to their order.
struct Pair {
    int a = 0;
    int b = 0;
};
struct BadHash {
    std::size_t operator()(const Pair&) const { return 1; }
};
struct Unordered {
    bool operator()(const Pair& x, const Pair& y) const {
        return (x.a == y.a && x.b == y.b) || (x.a == y.b && x.b == y.a);
    }
};

}  // namespace

static_assert(sspql::grows_v<HashedState<int>>);
static_assert(sspql::is_state_policy_v<HashedState<std::string>, std::string>);

TEST(HashedState, GivesIdsInTheOrderOfDiscovery) {
    HashedState<std::string> state;
    EXPECT_EQ(state.size(), 0u);
    EXPECT_EQ(index(state.encode("kitchen")), 0u);
    EXPECT_EQ(index(state.encode("hall")), 1u);
    EXPECT_EQ(index(state.encode("kitchen")), 0u);
    EXPECT_EQ(state.size(), 2u);
}

TEST(HashedState, FindsWithoutAdding) {
    HashedState<int> state;
    (void)state.encode(10);
    EXPECT_EQ(state.find(10), state_id(0));
    EXPECT_EQ(state.find(11), std::nullopt);
    EXPECT_EQ(state.size(), 1u);
}

TEST(HashedState, GivesTheKeyOfAState) {
    HashedState<int> state;
    for (int key = 100; key > 0; --key) (void)state.encode(key);
    for (std::size_t s = 0; s < 100; ++s) {
        EXPECT_EQ(state.key(state_id(s)), 100 - static_cast<int>(s));
        EXPECT_EQ(state.encode(state.key(state_id(s))), state_id(s));
    }
    EXPECT_THROW((void)state.key(state_id(100)), std::invalid_argument);
    EXPECT_THROW((void)state.key(sspql::no_state), std::invalid_argument);
}

TEST(HashedState, TakesTheUsersHashAndEquality) {
    HashedState<Pair, BadHash, Unordered> state;
    EXPECT_EQ(index(state.encode({1, 2})), 0u);
    EXPECT_EQ(index(state.encode({2, 1})), 0u);
    EXPECT_EQ(index(state.encode({2, 2})), 1u);
    EXPECT_EQ(index(state.encode({3, 1})), 2u);
    EXPECT_EQ(state.size(), 3u);
}

TEST(HashedState, CopiesAreIndependent) {
    HashedState<int> state;
    (void)state.encode(1);
    HashedState<int> copy = state;
    (void)copy.encode(2);
    EXPECT_EQ(state.size(), 1u);
    EXPECT_EQ(copy.size(), 2u);
    EXPECT_EQ(index(copy.encode(1)), 0u);
}

TEST(HashedState, ReservingChangesNothing) {
    HashedState<int> state;
    state.reserve(1000);
    EXPECT_EQ(state.size(), 0u);
    EXPECT_EQ(index(state.encode(4)), 0u);
}
