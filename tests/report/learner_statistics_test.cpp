// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fabricated_results.hpp"
#include "report/learner_statistics.hpp"

namespace sspql::report {
namespace {

TEST(LearnerStatistics, SumsAndErrorsByHand) {
    // Sums of all six episodes 21 and 27, of the first five 15 and 25.
    const LearnerRuns learner{"q", {run_of(1, {1, 2, 3, 4, 5, 6}), run_of(2, {5, 5, 5, 5, 5, 2})}};
    const LearnerStatistics s = statistics_of(learner, {});
    EXPECT_EQ(s.name, "q");
    EXPECT_EQ(s.seeds, 2u);
    EXPECT_EQ(s.episodes, 6u);
    EXPECT_EQ(s.total_steps_of, (std::vector<double>{21.0, 27.0}));
    EXPECT_EQ(s.first5_steps_of, (std::vector<double>{15.0, 25.0}));
    EXPECT_EQ(s.first30_steps_of, s.total_steps_of);
    EXPECT_DOUBLE_EQ(s.total_steps.mean, 24.0);
    EXPECT_DOUBLE_EQ(s.total_steps.deviation, std::sqrt(18.0));  // (9 + 9) / (2 - 1)
    EXPECT_DOUBLE_EQ(s.total_steps.error, 3.0);
    EXPECT_DOUBLE_EQ(s.first5_steps.mean, 20.0);
    // All six episodes are late: 21 / 6 and 27 / 6 an episode.
    EXPECT_DOUBLE_EQ(s.late_steps.mean, 4.0);
    EXPECT_DOUBLE_EQ(s.first_episode.mean, 3.0);
    EXPECT_DOUBLE_EQ(s.curve.mean[5], 4.0);
    EXPECT_DOUBLE_EQ(s.curve.deviation[0], std::sqrt(8.0));  // 1 and 5 about 3
    EXPECT_DOUBLE_EQ(s.model_ops_per_step, 2.0);
    EXPECT_DOUBLE_EQ(s.learn_ns_per_step, 100.0);
}

TEST(LearnerStatistics, LateAreTheLastTwentyEpisodes) {
    SeedRun run = run_of(1, std::vector<std::uint32_t>(35, 10));
    for (std::size_t i = 0; i < 15; ++i) run.episodes[i] = {1000, -5.0, false, true};
    const LearnerStatistics s = statistics_of(LearnerRuns{"q", {run}}, {});
    EXPECT_DOUBLE_EQ(s.late_steps.mean, 10.0);
    EXPECT_DOUBLE_EQ(s.late_return.mean, 1.0);
    EXPECT_DOUBLE_EQ(s.mean_return.mean, (15 * -5.0 + 20 * 1.0) / 35.0);
    EXPECT_DOUBLE_EQ(s.success_rate, 20.0 / 35.0);
    EXPECT_DOUBLE_EQ(s.late_success_rate, 1.0);
    EXPECT_EQ(s.capped_episodes, 15u);
    EXPECT_DOUBLE_EQ(s.first5_steps.mean, 5000.0);  // capped episodes count their steps
    EXPECT_DOUBLE_EQ(s.first30_steps.mean, 15150.0);
    EXPECT_DOUBLE_EQ(s.total_steps.mean, 15200.0);
}

TEST(LearnerStatistics, SeedsOfDifferentLengthShareTheShorterCurve) {
    const LearnerStatistics s = statistics_of(LearnerRuns{"q", {run_of(1, {4, 4, 4}), run_of(2, {2})}}, {});
    EXPECT_EQ(s.episodes, 1u);
    EXPECT_EQ(s.curve.mean, (std::vector<double>{3.0}));
    EXPECT_EQ(s.total_steps_of, (std::vector<double>{12.0, 2.0}));
    EXPECT_EQ(s.all_episodes, 4u);
}

TEST(LearnerStatistics, RewardAtReportedSteps) {
    LearnerRuns learner{"q", {run_of(1, {4}), run_of(2, {2})}};
    learner.runs[0].reward_at = {1.0, 10.0};
    learner.runs[1].reward_at = {3.0, 20.0};
    const LearnerStatistics s = statistics_of(learner, {1000, 3000});
    ASSERT_EQ(s.cumulative_reward.size(), 2u);
    EXPECT_EQ(s.cumulative_reward[1].step, 3000u);
    EXPECT_DOUBLE_EQ(s.cumulative_reward[1].reward.mean, 15.0);
    EXPECT_DOUBLE_EQ(s.cumulative_reward[1].reward.error, 5.0);
    EXPECT_TRUE(statistics_of(LearnerRuns{"q", {run_of(1, {4})}}, {1000}).cumulative_reward.empty());
}

TEST(LearnerStatistics, NothingMeasuredIsNotANumber) {
    const LearnerStatistics none = statistics_of(LearnerRuns{"q", {}}, {});
    EXPECT_EQ(none.seeds, 0u);
    EXPECT_TRUE(none.curve.mean.empty());
    EXPECT_TRUE(std::isnan(none.success_rate));
    const LearnerStatistics empty = statistics_of(LearnerRuns{"q", {run_of(1, {})}}, {});
    EXPECT_TRUE(std::isnan(empty.late_steps.mean));
    EXPECT_TRUE(std::isnan(empty.model_ops_per_step));
    EXPECT_EQ(empty.first_episode.count, 0u);
}

}  // namespace
}  // namespace sspql::report
