// SPDX-License-Identifier: MIT
#include <sspql/env/time_limit.hpp>

#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include <gtest/gtest.h>

using sspql::TimeLimit;

namespace {

/// Counts up; terminates at `goal`.
struct Counter {
    int goal = 1000;
    int at = 0;
    std::uint64_t seed = 0;
    int reset(std::uint64_t s) {
        seed = s;
        return at = 0;
    }
    sspql::Step<int> step(const int& move) {
        at += move;
        return {at, 0.5, at >= goal, false};
    }
};

}  // namespace

static_assert(sspql::is_environment_v<TimeLimit<Counter>, int>);

TEST(TimeLimit, TruncatesAtExactlyTheLastStep) {
    TimeLimit limited(Counter{}, 5);
    EXPECT_EQ(limited.max_steps(), 5u);
    for (int episode = 0; episode < 3; ++episode) {
        EXPECT_EQ(limited.reset(7), 0);
        EXPECT_EQ(limited.steps(), 0u);
        for (std::size_t k = 1; k <= 5; ++k) {
            const auto step = limited.step(1);
            EXPECT_EQ(step.observation, static_cast<int>(k));
            EXPECT_EQ(step.reward, 0.5);
            EXPECT_EQ(step.truncated, k == 5) << "step " << k;
            EXPECT_FALSE(step.terminated);
            EXPECT_EQ(limited.steps(), k);
        }
    }
}

TEST(TimeLimit, SetsBothFlagsWhenTheLastStepTerminates) {
    TimeLimit limited(Counter{5}, 5);
    (void)limited.reset(1);
    for (int k = 0; k < 4; ++k) {
        const auto step = limited.step(1);
        EXPECT_FALSE(step.terminated || step.truncated);
    }
    const auto step = limited.step(1);
    EXPECT_TRUE(step.terminated);
    EXPECT_TRUE(step.truncated);
}

TEST(TimeLimit, LeavesAnEarlierEndAlone) {
    TimeLimit limited(Counter{2}, 5);
    (void)limited.reset(1);
    (void)limited.step(1);
    const auto step = limited.step(1);
    EXPECT_TRUE(step.terminated);
    EXPECT_FALSE(step.truncated);
}

TEST(TimeLimit, KeepsWhatTheInnerEnvironmentTruncated) {
    TimeLimit inner(Counter{}, 2);
    TimeLimit outer(inner, 10);
    (void)outer.reset(1);
    EXPECT_FALSE(outer.step(1).truncated);
    EXPECT_TRUE(outer.step(1).truncated);
}

TEST(TimeLimit, PassesTheSeedOnAndShowsTheInnerEnvironment) {
    TimeLimit limited(Counter{}, 5);
    (void)limited.reset(99);
    EXPECT_EQ(limited.environment().seed, 99u);
    limited.environment().at = 3;
    const auto& constant = limited;
    EXPECT_EQ(constant.environment().at, 3);
}

TEST(TimeLimit, RefusesNoSteps) { EXPECT_THROW(TimeLimit(Counter{}, 0), std::invalid_argument); }
