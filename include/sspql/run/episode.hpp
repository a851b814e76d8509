// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include <sspql/core/concepts.hpp>
#include <sspql/env/environment.hpp>

namespace sspql {

/// How one episode went.
struct EpisodeResult {
    std::size_t steps = 0;      ///< of the environment
    double total_reward = 0.0;  ///< undiscounted return
    double last_reward = 0.0;   ///< that of the last step
    bool terminated = false;    ///< the task itself ended
    bool truncated = false;     ///< cut short, as by TimeLimit
};

/// Does nothing; what run_episode calls after each step, and run_episodes after each episode, unless told otherwise.
struct NoCallback {
    /// Does nothing.
    template <class... What>
    void operator()(const What&...) const noexcept {}
};

namespace detail {

template <class Agent, class Environment>
using BeginExpression =
    std::decay_t<decltype(std::declval<Agent&>().begin(std::declval<Environment&>().reset(std::uint64_t{})))>;

/// One error for what is missing: without the command that begin tells, nothing can be said about the step.
template <class Environment, class Agent, bool begins>
struct EpisodeRequirements : EnvironmentRequirements<Environment, detected_t<BeginExpression, Agent, Environment>> {};

template <class Environment, class Agent>
struct EpisodeRequirements<Environment, Agent, false> {
    static_assert(is_detected_v<BeginExpression, Agent, Environment>,
                  "sspql: this Agent lacks `Command begin(const Observation&)` for this Environment's observation");
};

}  // namespace detail

/// One learning episode: resets the environment with `seed` and lets the agent act until the environment terminates or
/// truncates (wrap it in a TimeLimit if it might do neither). `on_step(step)` is called after each environment step.
/// Agent: anything with begin(observation), step(reward, observation), end(reward, observation, terminated), abort().
/// If the environment, the agent or the callback throws, the agent's episode is aborted and the exception passes on.
template <class Environment, class Agent, class Callback = NoCallback>
EpisodeResult run_episode(Environment& environment, Agent& agent, std::uint64_t seed, Callback&& on_step = {}) {
    constexpr bool begins = detail::is_detected_v<detail::BeginExpression, Agent, Environment> ||
                            !detail::is_detected_v<detail::ResetExpression, Environment>;
    [[maybe_unused]] const detail::EpisodeRequirements<Environment, Agent, begins> checked{};
    using Command = detail::detected_t<detail::BeginExpression, Agent, Environment>;
    EpisodeResult result;
    if constexpr (is_environment_v<Environment, Command>) {  // else the requirement above stays the only error
        try {
            Command command = agent.begin(environment.reset(seed));
            for (;;) {
                const auto step = environment.step(command);
                ++result.steps;
                result.total_reward += step.reward;
                result.last_reward = step.reward;
                on_step(step);
                if (step.terminated || step.truncated) {
                    result.terminated = step.terminated;
                    result.truncated = step.truncated;
                    agent.end(step.reward, step.observation, step.terminated);
                    return result;
                }
                command = agent.step(step.reward, step.observation);
            }
        } catch (...) {
            agent.abort();
            throw;
        }
    }
    return result;
}

/// `episodes` learning episodes, the k-th (from 0) with the environment seed `seed + k`. `on_episode(result, agent)` is
/// called after each; see CheckpointEvery.
template <class Environment, class Agent, class Callback = NoCallback>
std::vector<EpisodeResult> run_episodes(Environment& environment, Agent& agent, std::size_t episodes,
                                        std::uint64_t seed, Callback&& on_episode = {}) {
    std::vector<EpisodeResult> results;
    results.reserve(episodes);
    for (std::size_t k = 0; k < episodes; ++k) {
        results.push_back(run_episode(environment, agent, seed + k));
        on_episode(results.back(), agent);
    }
    return results;
}

}  // namespace sspql
