// SPDX-License-Identifier: MIT
// Includes nothing of the library but assert.hpp: other headers must see one definition of SSPQL_ASSERT in all files.
#define SSPQL_ENABLE_ASSERTIONS 0
#include <sspql/core/assert.hpp>

#include <gtest/gtest.h>

TEST(AssertOff, CostsNothingAndEvaluatesNothing) {
    [[maybe_unused]] int evaluated = 0;
    SSPQL_ASSERT(++evaluated == 7, "not evaluated");
    EXPECT_EQ(evaluated, 0);
}

TEST(AssertOff, IsAnExpression) {
    const int value = (SSPQL_ASSERT(false, "off"), 5);
    EXPECT_EQ(value, 5);
}
