// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>
#include <utility>

#include <sspql/core/concepts.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/io/step_log.hpp>
#include <sspql/learn/transition.hpp>
#include <sspql/spaces/action_set.hpp>

namespace sspql {

namespace detail {

template <class A>
using LearnerExpression = decltype(std::declval<A&>().learner());

}  // namespace detail

/// An Agent, or a bare learner, that writes a step log while it acts:
///
///     sspql::StepLog log("run.csv");
///     sspql::Logged robot(agent, log);
///     sspql::run_episode(environment, robot, seed);      or robot.begin, step, end, as always
///
/// A step is logged once it was learnt from, with the action that was carried out (replace_action counts); what the
/// agent refuses is not logged. An end that did not terminate is logged as truncated. Both objects must outlive this
/// one, and everything else is asked of the agent itself. Errors: the agent's, then the log's; after one of the log's
/// the agent has learnt the step and stands where it would stand without a log.
template <class Agent>
class Logged {
public:
    /// Writes what `agent`, an Agent or a learner, does to `log`.
    Logged(Agent& agent, StepLog& log) noexcept : agent_(&agent), log_(&log) {}

    /// Starts an episode: the agent's begin. What the log has of one that was dropped meanwhile goes no further.
    template <class Observation>
    [[nodiscard]] auto begin(const Observation& observation) {
        auto command = agent_->begin(observation);
        log_->abort();  // an episode that somebody dropped behind our back
        return command;
    }
    /// The same with the actions that are legal now.
    template <class Observation>
    [[nodiscard]] auto begin(const Observation& observation, const ActionSet& legal) {
        auto command = agent_->begin(observation, legal);
        log_->abort();
        return command;
    }

    /// The agent's step, and then a line in the log.
    template <class Observation>
    [[nodiscard]] auto step(double reward, const Observation& observation, double weight = 1.0) {
        Transition t = pending(reward, weight);
        auto command = agent_->step(reward, observation, weight);
        t.next = learner().state();
        log_->write(t);
        return command;
    }
    /// The same with the actions that are legal now.
    template <class Observation>
    [[nodiscard]] auto step(double reward, const Observation& observation, const ActionSet& legal,
                            double weight = 1.0) {
        Transition t = pending(reward, weight);
        auto command = agent_->step(reward, observation, legal, weight);
        t.next = learner().state();
        log_->write(t);
        return command;
    }

    /// The agent's end, and then a line in the log.
    template <class Observation>
    void end(double reward, const Observation& observation, bool terminated, double weight = 1.0) {
        Transition t = pending(reward, weight);
        agent_->end(reward, observation, terminated, weight);
        t.next = state_of(observation);
        t.terminated = terminated;
        log_->write(t, !terminated);
    }

    /// Drops the running episode. \throws std::runtime_error if the log cannot be written.
    void abort() {
        agent_->abort();
        log_->abort();
    }

    /// What acts.
    [[nodiscard]] Agent& agent() noexcept { return *agent_; }
    /// Where its steps go.
    [[nodiscard]] StepLog& log() noexcept { return *log_; }

private:
    static constexpr bool is_agent = detail::is_detected_v<detail::LearnerExpression, Agent>;

    [[nodiscard]] const auto& learner() const noexcept {
        if constexpr (is_agent) {
            return std::as_const(*agent_).learner();
        } else {
            return *agent_;
        }
    }

    template <class Observation>
    [[nodiscard]] StateId state_of(const Observation& observation) {
        if constexpr (is_agent) {
            return agent_->state(observation);
        } else {
            return observation;
        }
    }

    /// The step under way, without its outcome.
    [[nodiscard]] Transition pending(double reward, double weight) const {
        log_->require_weight(weight);  // before anything is learnt that could not be logged
        return {learner().state(), learner().action(), reward, no_state, false, weight};
    }

    Agent* agent_;
    StepLog* log_;
};

}  // namespace sspql
