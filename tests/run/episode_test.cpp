// SPDX-License-Identifier: MIT
#include <sspql/run/episode.hpp>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/env/time_limit.hpp>
#include <sspql/learn/agent.hpp>
#include <sspql/spaces/action_policy.hpp>
#include <sspql/spaces/enum_state.hpp>

using sspql::EpisodeResult;
using sspql::run_episode;
using sspql::run_episodes;
using sspql::TimeLimit;

namespace {

/// 0 to `length`; a step costs 0.25, the end pays 2. Fails in the step number `fail_at` of an episode.
struct Corridor {
    int length = 4;
    int fail_at = -1;
    int at = 0;
    int steps = 0;
    std::vector<std::uint64_t> seeds{};
    int reset(std::uint64_t seed) {
        seeds.push_back(seed);
        steps = 0;
        return at = 0;
    }
    sspql::Step<int> step(const int& move) {
        if (++steps == fail_at) throw std::runtime_error("motor lost");
        at += move;
        return {at, at == length ? 2.0 : -0.25, at == length, false};
    }
};

/// Always goes right, and writes down what it is told.
struct Scribe {
    std::string log{};
    int begin(int o) {
        log += "b" + std::to_string(o);
        return 1;
    }
    int step(double, int o) {
        log += " s" + std::to_string(o);
        return 1;
    }
    void end(double, int o, bool terminated) { log += " e" + std::to_string(o) + (terminated ? "T" : "-"); }
    void abort() noexcept { log += " a"; }
};

}  // namespace

TEST(RunEpisode, TellsTheAgentWhatHappened) {
    Corridor corridor;
    Scribe scribe;
    const EpisodeResult result = run_episode(corridor, scribe, 17);
    EXPECT_EQ(scribe.log, "b0 s1 s2 s3 e4T");
    EXPECT_EQ(corridor.seeds, std::vector<std::uint64_t>{17});
    EXPECT_EQ(result.steps, 4u);
    EXPECT_EQ(result.total_reward, 2.0 - 0.75);
    EXPECT_EQ(result.last_reward, 2.0);
    EXPECT_TRUE(result.terminated);
    EXPECT_FALSE(result.truncated);
}

TEST(RunEpisode, ATruncatedEpisodeEndsWithoutTermination) {
    TimeLimit corridor(Corridor{100}, 3);
    Scribe scribe;
    const EpisodeResult result = run_episode(corridor, scribe, 1);
    EXPECT_EQ(scribe.log, "b0 s1 s2 e3-");
    EXPECT_EQ(result.steps, 3u);
    EXPECT_FALSE(result.terminated);
    EXPECT_TRUE(result.truncated);
}

TEST(RunEpisode, BothFlagsMeanTerminated) {
    TimeLimit corridor(Corridor{3}, 3);
    Scribe scribe;
    const EpisodeResult result = run_episode(corridor, scribe, 1);
    EXPECT_EQ(scribe.log, "b0 s1 s2 e3T");
    EXPECT_TRUE(result.terminated);
    EXPECT_TRUE(result.truncated);
}

TEST(RunEpisode, ShowsEveryStepToTheCallback) {
    Corridor corridor;
    Scribe scribe;
    std::vector<int> seen;
    double reward = 0.0;
    (void)run_episode(corridor, scribe, 1, [&](const sspql::Step<int>& step) {
        seen.push_back(step.observation);
        reward += step.reward;
    });
    EXPECT_EQ(seen, (std::vector<int>{1, 2, 3, 4}));
    EXPECT_EQ(reward, 1.25);
}

TEST(RunEpisode, AbortsTheAgentWhenTheEnvironmentThrows) {
    Corridor corridor{4, 3};
    Scribe scribe;
    EXPECT_THROW((void)run_episode(corridor, scribe, 1), std::runtime_error);
    EXPECT_EQ(scribe.log, "b0 s1 s2 a");
}

TEST(RunEpisode, AbortsTheAgentWhenTheCallbackThrows) {
    Corridor corridor;
    Scribe scribe;
    const auto stop = [](const auto& step) {
        if (step.observation == 2) throw std::string("stop button");
    };
    EXPECT_THROW((void)run_episode(corridor, scribe, 1, stop), std::string);
    EXPECT_EQ(scribe.log, "b0 s1 a");
}

TEST(RunEpisode, ALearningAgentGoesOnAfterAFailure) {
    TimeLimit corridor(Corridor{3, 2}, 50);
    sspql::Agent agent(sspql::EnumState<int>(4), sspql::ActionTable<int>{1, 0});
    EXPECT_THROW((void)run_episode(corridor, agent, 1), std::runtime_error);
    EXPECT_FALSE(agent.learner().running());
    corridor.environment().fail_at = -1;
    const auto results = run_episodes(corridor, agent, 20, 1);
    EXPECT_TRUE(results.back().terminated);
    EXPECT_LE(results.back().steps, 4u);
}

TEST(RunEpisodes, SeedsEachEpisodeByItsNumber) {
    Corridor corridor;
    Scribe scribe;
    const auto results = run_episodes(corridor, scribe, 3, 40);
    EXPECT_EQ(corridor.seeds, (std::vector<std::uint64_t>{40, 41, 42}));
    EXPECT_EQ(results.size(), 3u);
    for (const EpisodeResult& result : results) EXPECT_EQ(result.steps, 4u);
    EXPECT_TRUE(run_episodes(corridor, scribe, 0, 1).empty());
}
