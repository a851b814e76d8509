// SPDX-License-Identifier: MIT
#include "report/learner_statistics.hpp"

#include <algorithm>
#include <limits>

namespace sspql::report {

namespace {

constexpr std::size_t late_episodes = 20;

/// a / b, NaN when there is nothing to divide by.
double quotient(double a, double b) { return b > 0.0 ? a / b : std::numeric_limits<double>::quiet_NaN(); }

/// What a stretch of one seed's episodes adds up to.
struct Totals {
    double steps = 0.0;
    double reward = 0.0;
    double successes = 0.0;
    double episodes = 0.0;
    std::uint64_t capped = 0;
};

/// Over episodes first, ..., last - 1 (from 0); `last` may lie beyond the end.
Totals totals_of(const SeedRun& run, std::size_t first, std::size_t last) {
    Totals totals;
    for (std::size_t i = first; i < std::min(last, run.episodes.size()); ++i) {
        const EpisodeRecord& episode = run.episodes[i];
        totals.steps += static_cast<double>(episode.steps);
        totals.reward += episode.total_reward;
        totals.successes += episode.success ? 1.0 : 0.0;
        totals.episodes += 1.0;
        totals.capped += episode.capped ? 1u : 0u;
    }
    return totals;
}

std::size_t common_episodes(const LearnerRuns& learner) {
    if (learner.runs.empty()) return 0;
    std::size_t least = learner.runs.front().episodes.size();
    for (const SeedRun& run : learner.runs) least = std::min(least, run.episodes.size());
    return least;
}

Summary steps_of_episode(const LearnerRuns& learner, std::size_t episode) {
    std::vector<double> steps;
    steps.reserve(learner.runs.size());
    for (const SeedRun& run : learner.runs) steps.push_back(static_cast<double>(run.episodes[episode].steps));
    return summarize(steps);
}

std::vector<RewardPoint> rewards_of(const LearnerRuns& learner, const std::vector<std::uint64_t>& report_at) {
    std::vector<RewardPoint> points;
    for (std::size_t i = 0; i < report_at.size(); ++i) {
        std::vector<double> rewards;
        for (const SeedRun& run : learner.runs) {
            if (i < run.reward_at.size()) rewards.push_back(run.reward_at[i]);
        }
        if (!rewards.empty()) points.push_back({report_at[i], summarize(rewards)});
    }
    return points;
}

}  // namespace

LearnerStatistics statistics_of(const LearnerRuns& learner, const std::vector<std::uint64_t>& report_at) {
    LearnerStatistics result;
    result.name = learner.name;
    result.seeds = learner.runs.size();
    result.episodes = common_episodes(learner);

    Totals everything;
    Totals late_everything;
    double steps = 0.0;
    double operations = 0.0;
    double nanoseconds = 0.0;
    std::vector<double> late_returns;
    std::vector<double> mean_returns;
    for (const SeedRun& run : learner.runs) {
        const std::size_t n = run.episodes.size();
        const Totals all = totals_of(run, 0, n);
        const Totals late = totals_of(run, n - std::min(late_episodes, n), n);
        result.total_steps_of.push_back(all.steps);
        result.first5_steps_of.push_back(totals_of(run, 0, 5).steps);
        result.first30_steps_of.push_back(totals_of(run, 0, 30).steps);
        result.late_steps_of.push_back(quotient(late.steps, late.episodes));
        late_returns.push_back(quotient(late.reward, late.episodes));
        mean_returns.push_back(quotient(all.reward, all.episodes));
        everything.successes += all.successes;
        everything.episodes += all.episodes;
        everything.capped += all.capped;
        late_everything.successes += late.successes;
        late_everything.episodes += late.episodes;
        steps += static_cast<double>(run.steps);
        operations += static_cast<double>(run.model_operations);
        nanoseconds += run.learning_ns;
    }

    result.total_steps = summarize(result.total_steps_of);
    result.first5_steps = summarize(result.first5_steps_of);
    result.first30_steps = summarize(result.first30_steps_of);
    result.late_steps = summarize(result.late_steps_of);
    result.late_return = summarize(late_returns);
    result.mean_return = summarize(mean_returns);
    result.success_rate = quotient(everything.successes, everything.episodes);
    result.late_success_rate = quotient(late_everything.successes, late_everything.episodes);
    result.capped_episodes = everything.capped;
    result.all_episodes = static_cast<std::uint64_t>(everything.episodes);
    result.model_ops_per_step = quotient(operations, steps);
    result.learn_ns_per_step = quotient(nanoseconds, steps);
    for (std::size_t episode = 0; episode < result.episodes; ++episode) {
        const Summary summary = steps_of_episode(learner, episode);
        if (episode == 0) result.first_episode = summary;
        result.curve.mean.push_back(summary.mean);
        result.curve.deviation.push_back(summary.deviation);
    }
    result.cumulative_reward = rewards_of(learner, report_at);
    return result;
}

std::vector<LearnerStatistics> statistics_of(const PhaseRuns& phase) {
    std::vector<LearnerStatistics> all;
    all.reserve(phase.learners.size());
    for (const LearnerRuns& learner : phase.learners) all.push_back(statistics_of(learner, phase.report_at));
    return all;
}

}  // namespace sspql::report
