// SPDX-License-Identifier: MIT
// Includes nothing of the library but assert.hpp: other headers must see one definition of SSPQL_ASSERT in all files.
#define SSPQL_ENABLE_ASSERTIONS 1
#include <sspql/core/assert.hpp>

#include <gtest/gtest.h>

#if GTEST_HAS_DEATH_TEST
TEST(AssertOnDeathTest, StopsWithPlaceMessageAndCondition) {
    const int legs = 3;
    EXPECT_DEATH(SSPQL_ASSERT(legs == 4, "a table has four legs"),
                 "assert_on_test.cpp:[0-9]+: sspql assertion failed: a table has four legs \\(legs == 4\\)");
}
#endif

TEST(AssertOn, LetsTrueConditionsPassAndEvaluatesThemOnce) {
    int evaluated = 0;
    SSPQL_ASSERT(++evaluated == 1, "evaluated");
    EXPECT_EQ(evaluated, 1);
}
