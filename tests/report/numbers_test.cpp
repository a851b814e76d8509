// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "report/escape.hpp"
#include "report/numbers.hpp"

namespace sspql::report {
namespace {

TEST(Numbers, FixedShortAndExact) {
    EXPECT_EQ(fixed_text(12.3, 2), "12.30");
    EXPECT_EQ(fixed_text(-0.001, 2), "0.00");
    EXPECT_EQ(fixed_text(-1.0, 0), "-1");
    EXPECT_EQ(fixed_text(1e300, 0).size(), 301u);
    EXPECT_EQ(fixed_text(std::nan(""), 2), "n/a");
    EXPECT_EQ(short_text(12.300, 3), "12.3");
    EXPECT_EQ(short_text(100.0, 3), "100");
    EXPECT_EQ(short_text(100.0, 0), "100");
    EXPECT_EQ(short_text(-0.0, 2), "0");
    EXPECT_EQ(exact_text(0.1), "0.1");
    EXPECT_EQ(exact_text(-std::numeric_limits<double>::infinity()), "");
}

TEST(Escape, MarkupBecomesText) {
    EXPECT_EQ(escaped("<b>\"a\" & 'b'</b>"), "&lt;b&gt;&quot;a&quot; &amp; &#39;b&#39;&lt;/b&gt;");
    EXPECT_EQ(escaped(std::string("a\x01\tb\n", 5)), "a\xEF\xBF\xBD\tb\n");
    EXPECT_EQ(escaped("\xCE\xB3"), "\xCE\xB3");
}

}  // namespace
}  // namespace sspql::report
