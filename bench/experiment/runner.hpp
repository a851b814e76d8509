// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
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

/// The time this thread has computed, in ns: unlike the time of day it stands still while another thread runs.
[[nodiscard]] double thread_time_ns();

/// What reading the clock adds to a measurement, in ns.
[[nodiscard]] double clock_cost_ns();

/// An agent that measures the time spent in its learner: every `stride`-th step (a clock reading costs more than a step
/// of Q-learning) and every end of an episode, where planners work.
template <class StatePolicy, class ActionPolicy>
class TimedAgent {
public:
    TimedAgent(StatePolicy states, ActionPolicy actions, AnyLearner& learner)
        : states_(std::move(states)), actions_(std::move(actions)), learner_(learner), clock_cost_ns_(clock_cost_ns()) {}

    template <class Observation>
    auto begin(const Observation& observation) {
        return actions_.decode(learner_.begin(states_.encode(observation)));
    }

    template <class Observation>
    auto step(double reward, const Observation& observation) {
        const StateId s = states_.encode(observation);
        if (++steps_ % stride != 0) return actions_.decode(learner_.step(reward, s));
        const double begun = thread_time_ns();
        const ActionId a = learner_.step(reward, s);
        sampled_ns_ += since(begun);
        return actions_.decode(a);
    }

    template <class Observation>
    void end(double reward, const Observation& observation, bool terminated) {
        const StateId s = states_.encode(observation);
        const double begun = thread_time_ns();
        learner_.end(reward, s, terminated);
        end_ns_ += since(begun);
    }

    void abort() noexcept { learner_.abort(); }

    [[nodiscard]] double learning_ns() const noexcept { return sampled_ns_ * static_cast<double>(stride) + end_ns_; }
    [[nodiscard]] std::uint64_t model_operations() const { return learner_.model_operations(); }

private:
    static constexpr std::uint64_t stride = 8;

    [[nodiscard]] double since(double begun) const {
        const double spent = thread_time_ns() - begun - clock_cost_ns_;
        return spent > 0.0 ? spent : 0.0;
    }

    StatePolicy states_;
    ActionPolicy actions_;
    AnyLearner& learner_;
    double clock_cost_ns_;
    std::uint64_t steps_ = 0;
    double sampled_ns_ = 0.0;
    double end_ns_ = 0.0;
};

/// How long a run is, and what counts as success.
struct RunPlan {
    std::size_t episodes = 0;
    std::size_t steps_per_episode = 0;    ///< an episode is cut there
    std::size_t total_steps = 0;          ///< > 0: the run is this many steps instead of `episodes` episodes
    std::vector<std::uint64_t> report_at; ///< steps after which the reward collected so far is noted
    std::function<bool(double terminal_reward)> is_success = [](double reward) { return reward > 0.0; };
};

/// Cuts the run of an environment by setting `truncated` when a number of steps was made in all episodes.
template <class Environment>
class RunLimit {
public:
    RunLimit(Environment& environment, std::size_t total_steps) : environment_(environment), left_(total_steps) {}

    auto reset(std::uint64_t seed) { return environment_.reset(seed); }

    template <class Command>
    auto step(const Command& command) {
        auto step = environment_.step(command);
        if (left_ > 0 && --left_ == 0) {
            step.truncated = true;
            over_ = true;
        }
        return step;
    }

    [[nodiscard]] bool over() const noexcept { return over_; }

private:
    Environment& environment_;
    std::size_t left_;  // 0: no limit
    bool over_ = false;
};

/// One seed's run; episode k (from 0) has the environment seed episode_seed(seed, first_episode + k).
template <class Environment, class Agent>
report::SeedRun run_seed(Environment& environment, Agent& agent, std::uint64_t seed, std::size_t first_episode,
                         const RunPlan& plan) {
    report::SeedRun run;
    run.seed = seed;
    run.episodes.reserve(plan.episodes);
    const std::uint64_t operations_before = agent.model_operations();
    const double learning_before = agent.learning_ns();
    TimeLimit limited(RunLimit<Environment>(environment, plan.total_steps), plan.steps_per_episode);
    double collected = 0.0;
    const auto note = [&](const auto& step) {
        ++run.steps;
        collected += step.reward;
        if (run.reward_at.size() < plan.report_at.size() && plan.report_at[run.reward_at.size()] == run.steps) {
            run.reward_at.push_back(collected);
        }
    };
    for (std::size_t k = 0; plan.total_steps > 0 ? !limited.environment().over() : k < plan.episodes; ++k) {
        const EpisodeResult result = run_episode(limited, agent, episode_seed(seed, first_episode + k), note);
        report::EpisodeRecord record;
        record.steps = static_cast<std::uint32_t>(result.steps);
        record.total_reward = result.total_reward;
        record.success = result.terminated && plan.is_success(result.last_reward);
        record.capped = result.truncated && !result.terminated && !limited.environment().over();
        run.episodes.push_back(record);
    }
    run.model_operations = agent.model_operations() - operations_before;
    run.learning_ns = agent.learning_ns() - learning_before;
    return run;
}

}  // namespace sspql::experiment
