// SPDX-License-Identifier: MIT
// Includes nothing of the library but assert.hpp: other headers must see one definition of SSPQL_ASSERT in all files.
#include <stdexcept>

#define SSPQL_ASSERT(condition, message) ((condition) ? static_cast<void>(0) : throw std::logic_error(message))
#include <sspql/core/assert.hpp>

#include <gtest/gtest.h>

TEST(AssertReplaced, GoesWhereTheUserSendsIt) {
    EXPECT_THROW(SSPQL_ASSERT(1 > 2, "mine"), std::logic_error);
    EXPECT_NO_THROW(SSPQL_ASSERT(2 > 1, "mine"));
}
