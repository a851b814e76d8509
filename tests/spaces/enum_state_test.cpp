// SPDX-License-Identifier: MIT
#include <sspql/spaces/enum_state.hpp>

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <sspql/spaces/state_policy.hpp>

using sspql::EnumState;
using sspql::index;
using sspql::state_id;

namespace {

enum class Light { red, amber, green };
enum class Signed : int { below = -1, zero = 0, one = 1 };

}  // namespace

static_assert(sspql::is_state_policy_v<EnumState<Light>, Light>);
static_assert(!sspql::is_state_policy_v<EnumState<Light>, std::string>);

TEST(EnumState, IdIsTheValue) {
    const EnumState<Light> lights(3);
    EXPECT_EQ(lights.size(), 3u);
    EXPECT_EQ(index(lights.encode(Light::red)), 0u);
    EXPECT_EQ(index(lights.encode(Light::green)), 2u);
    const EnumState<bool> flag(2);
    EXPECT_EQ(index(flag.encode(true)), 1u);
    const EnumState<std::uint8_t> bytes(256);
    EXPECT_EQ(index(bytes.encode(255)), 255u);
}

TEST(EnumState, RefusesValuesOutside) {
    const EnumState<int> numbers(10);
    EXPECT_EQ(index(numbers.encode(9)), 9u);
    EXPECT_THROW((void)numbers.encode(10), std::invalid_argument);
    EXPECT_THROW((void)numbers.encode(-1), std::invalid_argument);
    EXPECT_THROW((void)numbers.encode(std::numeric_limits<int>::min()), std::invalid_argument);
    EXPECT_THROW((void)EnumState<Signed>(2).encode(Signed::below), std::invalid_argument);
    EXPECT_THROW((void)EnumState<std::uint64_t>(2).encode(~std::uint64_t{0}), std::invalid_argument);
    try {
        (void)numbers.encode(12);
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "observation must lie between 0 and 9, got 12");
    }
}

TEST(EnumState, RefusesSizesOutside) {
    EXPECT_THROW(EnumState<int>(0), std::invalid_argument);
    EXPECT_THROW(EnumState<std::uint64_t>(4294967295u), std::invalid_argument);
    EXPECT_EQ(EnumState<std::uint64_t>(4294967294u).size(), 4294967294u);
}

TEST(EnumState, DescribesByNumber) { EXPECT_EQ(sspql::describe_state(EnumState<int>(5), state_id(3)), "3"); }
