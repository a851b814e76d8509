// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include <sspql/core/random.hpp>
#include <sspql/env/time_limit.hpp>
#include <sspql/run/episode.hpp>

#include "experiment/any_learner.hpp"
#include "report/results.hpp"

namespace sspql::experiment {

/// The environment seed of an episode of a run: all learners of a seed meet the same episodes.
[[nodiscard]] inline std::uint64_t episode_seed(std::uint64_t seed, std::size_t episode) {
    return Random(seed, 1000 + episode).bits();
}

/// An agent that measures the time spent in its learner: every `stride`-th step (a clock reading costs as much as a step
/// of Q-learning) and every end of an episode, where planners work.
template <class StatePolicy, class ActionPolicy>
class TimedAgent {
public:
    TimedAgent(StatePolicy states, ActionPolicy actions, std::unique_ptr<AnyLearner> learner)
        : states_(std::move(states)), actions_(std::move(actions)), learner_(std::move(learner)) {}

    template <class Observation>
    auto begin(const Observation& observation) {
        return actions_.decode(learner_->begin(states_.encode(observation)));
    }

    template <class Observation>
    auto step(double reward, const Observation& observation) {
        const StateId s = states_.encode(observation);
        if (++steps_ % stride != 0) return actions_.decode(learner_->step(reward, s));
        const auto begun = Clock::now();
        const ActionId a = learner_->step(reward, s);
        sampled_ns_ += since(begun);
        return actions_.decode(a);
    }

    template <class Observation>
    void end(double reward, const Observation& observation, bool terminated) {
        const StateId s = states_.encode(observation);
        const auto begun = Clock::now();
        learner_->end(reward, s, terminated);
        end_ns_ += since(begun);
    }

    void abort() noexcept {}

    [[nodiscard]] double learning_ns() const noexcept { return sampled_ns_ * stride + end_ns_; }
    [[nodiscard]] AnyLearner& learner() noexcept { return *learner_; }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::uint64_t stride = 8;

    static double since(Clock::time_point begun) {
        return std::chrono::duration<double, std::nano>(Clock::now() - begun).count();
    }

    StatePolicy states_;
    ActionPolicy actions_;
    std::unique_ptr<AnyLearner> learner_;
    std::uint64_t steps_ = 0;
    double sampled_ns_ = 0.0;
    double end_ns_ = 0.0;
};

/// One seed's run of `episodes` episodes. `on_step(episode, step)` sees every environment step.
template <class Environment, class Agent, class Callback>
report::SeedRun run_seed(TimeLimit<Environment>& environment, Agent& agent, std::uint64_t seed, std::size_t episodes,
                         const Callback& on_step) {
    report::SeedRun run;
    run.seed = seed;
    run.episodes.reserve(episodes);
    for (std::size_t episode = 0; episode < episodes; ++episode) {
        const EpisodeResult result = run_episode(environment, agent, episode_seed(seed, episode),
                                                 [&](const auto& step) { on_step(episode, step); });
        report::EpisodeRecord record;
        record.steps = static_cast<std::uint32_t>(result.steps);
        record.total_reward = result.total_reward;
        record.success = result.terminated && result.last_reward > 0.0;
        record.capped = result.truncated && !result.terminated;
        run.episodes.push_back(record);
        run.steps += result.steps;
    }
    run.model_operations = agent.learner().model_operations();
    run.learning_ns = agent.learning_ns();
    return run;
}

}  // namespace sspql::experiment
