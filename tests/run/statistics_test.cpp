// SPDX-License-Identifier: MIT
#include <sspql/run/statistics.hpp>

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

using sspql::summarize;
using sspql::Summary;
using sspql::z_score;

TEST(Statistics, MatchTheOnesByHand) {
    const Summary summary = summarize({2, 4, 4, 4, 5, 5, 7, 9});
    EXPECT_EQ(summary.count, 8u);
    EXPECT_DOUBLE_EQ(summary.mean, 5.0);
    EXPECT_DOUBLE_EQ(summary.deviation, std::sqrt(32.0 / 7.0));
    EXPECT_DOUBLE_EQ(summary.error, std::sqrt(32.0 / 7.0 / 8.0));
    const Summary two = summarize({1.0, 3.0});
    EXPECT_DOUBLE_EQ(two.deviation, std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(two.error, 1.0);
}

TEST(Statistics, OfNoneAndOneHaveNoDeviation) {
    EXPECT_EQ(summarize({}).count, 0u);
    EXPECT_EQ(summarize({}).mean, 0.0);
    const Summary one = summarize({3.5});
    EXPECT_EQ(one.count, 1u);
    EXPECT_EQ(one.mean, 3.5);
    EXPECT_EQ(one.deviation, 0.0);
    EXPECT_EQ(one.error, 0.0);
}

TEST(Statistics, DoNotCancelFarFromZero) {
    const Summary summary = summarize({1e9 + 4.0, 1e9 + 7.0, 1e9 + 13.0, 1e9 + 16.0});
    EXPECT_DOUBLE_EQ(summary.mean, 1e9 + 10.0);
    EXPECT_DOUBLE_EQ(summary.deviation, std::sqrt(30.0));
}

TEST(Statistics, EqualValuesDoNotVary) {
    for (const double value : {0.1, 0.7, 1.0 / 3.0, -1e-300}) {
        for (std::size_t n = 2; n < 50; ++n) {
            const Summary summary = summarize(std::vector<double>(n, value));
            EXPECT_EQ(summary.mean, value) << n;
            EXPECT_EQ(summary.deviation, 0.0) << n;
        }
    }
}

TEST(Statistics, ZScoreCountsStandardErrors) {
    const Summary a{4, 10.0, 6.0, 3.0};
    const Summary b{4, 5.0, 8.0, 4.0};
    EXPECT_DOUBLE_EQ(z_score(a, b), 1.0);
    EXPECT_DOUBLE_EQ(z_score(b, a), -1.0);
    EXPECT_EQ(z_score(a, a), 0.0);
    EXPECT_EQ(z_score(summarize({0.1, 0.1, 0.1}), summarize({0.2, 0.2, 0.2})), 0.0) << "neither sample varies";
}
