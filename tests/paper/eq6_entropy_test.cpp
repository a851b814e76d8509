// SPDX-License-Identifier: MIT
// Eq. 6: H(s,a) = - sum_s' P(s'|s,a) log P(s'|s,a), in nats
#include <sspql/model/probability.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include <sspql/model/transition_counts.hpp>

using sspql::ActionId;
using sspql::CountCell;
using sspql::entropy;
using sspql::FadingCell;
using sspql::StateId;
using sspql::TransitionCounts;

namespace {

constexpr ActionId a0{0}, a1{1};
constexpr StateId s0{0}, s1{1}, s2{2}, s3{3};
constexpr double ln2 = 0.6931471805599453;

}  // namespace

// (1/2, 1/4, 1/4): 1/2 ln 2 + 2 x 1/4 x 2 ln 2 = 1.5 ln 2. In bits it would be 1.5.
TEST(Eq6Entropy, IsInNats) {
    TransitionCounts<CountCell> counts(4, 1);
    for (const StateId next : {s1, s1, s2, s3}) counts.record(s0, a0, next);
    EXPECT_DOUBLE_EQ(entropy(counts, s0, a0), 1.5 * ln2);
}

TEST(Eq6Entropy, IsZeroForACertainOutcome) {
    TransitionCounts<CountCell> counts(2, 1);
    for (int i = 0; i < 7; ++i) counts.record(s0, a0, s1);
    EXPECT_EQ(entropy(counts, s0, a0), 0.0);
}

TEST(Eq6Entropy, IsZeroForAnActionNeverTried) {
    const TransitionCounts<CountCell> counts(2, 1);
    EXPECT_EQ(entropy(counts, s0, a0), 0.0);
}

// s2 and s3 are successors of s0 by a1 only: for a0 their P is 0, and 0 log 0 = 0. a0: (1/2, 1/2) over s0 and s1.
TEST(Eq6Entropy, OutcomesOfOtherActionsCountForNothing) {
    TransitionCounts<CountCell> counts(4, 2);
    counts.record(s0, a1, s2);
    counts.record(s0, a1, s3);
    counts.record(s0, a0, s0);
    counts.record(s0, a0, s1);
    EXPECT_DOUBLE_EQ(entropy(counts, s0, a0), ln2);
    EXPECT_DOUBLE_EQ(entropy(counts, s0, a1), ln2);
}

// n equally likely outcomes have the largest entropy, ln n.
TEST(Eq6Entropy, OfUniformOutcomesIsTheLogOfTheirNumber) {
    TransitionCounts<CountCell> counts(100, 10);
    for (std::uint32_t next = 0; next < 100; ++next) {
        counts.record(s0, ActionId{9}, StateId{next});
        EXPECT_NEAR(entropy(counts, s0, ActionId{9}), std::log(next + 1.0), 1e-12);
    }
}

// (3/4, 1/4) whatever the counts are worth: 3/4 ln 4/3 + 1/4 ln 4 = 0.5623351446
TEST(Eq6Entropy, DependsOnSharesOnly) {
    TransitionCounts<FadingCell> counts(3, 1);
    for (const StateId next : {s1, s2, s1, s1}) counts.record(s0, a0, next);
    EXPECT_NEAR(entropy(counts, s0, a0), 0.5623351446, 1e-10);
    counts.fade(s0, a0, 0.3, 0.01);
    EXPECT_NEAR(entropy(counts, s0, a0), 0.5623351446, 1e-10);
}
