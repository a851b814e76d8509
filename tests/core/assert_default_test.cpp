// SPDX-License-Identifier: MIT
#include <sspql/core/assert.hpp>

#include <gtest/gtest.h>

#if !defined(SSPQL_ENABLE_ASSERTIONS)
#error "assert.hpp must decide"
#endif

TEST(AssertDefault, IsOnInDebugAndSanitizerBuilds) {
#if !defined(NDEBUG) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    EXPECT_EQ(SSPQL_ENABLE_ASSERTIONS, 1);
#elif !defined(__has_feature)
    EXPECT_EQ(SSPQL_ENABLE_ASSERTIONS, 0);
#endif
}
