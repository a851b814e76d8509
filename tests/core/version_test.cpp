// SPDX-License-Identifier: MIT
#include <sspql/core/version.hpp>

#include <string>

#include <gtest/gtest.h>

TEST(Version, TextIsMadeOfItsNumbers) {
    const std::string expected = std::to_string(SSPQL_VERSION_MAJOR) + "." + std::to_string(SSPQL_VERSION_MINOR) + "." +
                                 std::to_string(SSPQL_VERSION_PATCH);
    EXPECT_EQ(SSPQL_VERSION, expected);
}

TEST(Version, NumbersCanBeComparedByThePreprocessor) {
#if SSPQL_VERSION_MAJOR > 0 || SSPQL_VERSION_MINOR >= 1
    SUCCEED();
#else
    FAIL() << SSPQL_VERSION;
#endif
}
