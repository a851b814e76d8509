// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <fstream>
#include <istream>
#include <stdexcept>
#include <string>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/line_reader.hpp>
#include <sspql/io/step_log_reader.hpp>
#include <sspql/learn/learner.hpp>

namespace sspql {

namespace detail {

/// Throws at the field of the current step that the learner could not take.
template <class Learner>
void require_step_for(const Learner& learner, const StepLogReader& log) {
    const Transition& step = log.step().transition;
    std::size_t states = learner.states();
    const auto require_state = [&](StateId s, std::size_t field, const char* name) {
        if (index(s) < states) return;
        if (learner.grows() && index(s) == states) {
            ++states;
            return;
        }
        const std::string number = std::to_string(states);
        log.fail(field, std::string(name) +
                            (learner.grows() ? " must be at most the learner's number of states so far, "
                                             : " must be below the learner's number of states, ") +
                            number + ", got '" + std::to_string(index(s)) + "'");
    };
    require_state(step.state, 2, "state");
    if (index(step.action) >= learner.actions()) {
        log.fail(3, "action must be below the learner's number of actions, " + std::to_string(learner.actions()) +
                        ", got '" + std::to_string(index(step.action)) + "'");
    }
    require_state(step.next, 5, "next");
    if (!(std::fabs(step.reward) <= max_reward)) {
        log.fail(4, "reward must lie in [" + to_text(-max_reward) + ", " + to_text(max_reward) + "], got '" +
                        offending_text(step.reward) + "'");
    }
}

/// Lets a learner live through the current step.
template <class Learner>
void live_through(Learner& learner, const StepLogReader& log) {
    const LoggedStep& logged = log.step();
    const Transition& step = logged.transition;
    if (logged.step == 0) {
        learner.abort();
        static_cast<void>(learner.begin(step.state));
    }
    if (learner.action() != step.action) learner.replace_action(step.action);
    if (step.terminated || logged.truncated) {
        learner.end(step.reward, step.next, step.terminated, step.weight);
    } else {
        static_cast<void>(learner.step(step.reward, step.next, step.weight));
    }
}

}  // namespace detail

/// Learns from a step log as if the learner had lived through it: begin, step and end are called as they were when the
/// log was written, and wherever the learner would have acted differently, replace_action. A new learner with the
/// parameters and the seed of the one that wrote the log from its first step on ends up as its copy, bit for bit, if
/// nothing but logged steps happened (no set_goals, teach, observe, other masks, no episode dropped before its first
/// step). Another learner, with other parameters, ends up with what it makes of the same experience.
///
/// One line at a time is held in memory. A growing learner takes ids in the order of discovery.
/// \throws std::runtime_error "NAME:LINE:COLUMN: ..." for what StepLogReader refuses, for ids that the learner does
/// not have and rewards beyond what learners take; what the learner itself throws. What came before the error was
/// learnt, and no episode is running then: for_each_step checks a log without learning. std::logic_error if an episode
/// is running.
template <class Learner>
StepLogContent replay(std::istream& in, const std::string& name, Learner& learner) {
    if (learner.running()) throw std::logic_error("replay() during an episode: end() or abort() it first");
    StepLogReader log(in, name);
    try {
        while (log.next()) {
            detail::require_step_for(learner, log);
            detail::live_through(learner, log);
        }
    } catch (...) {
        learner.abort();
        throw;
    }
    learner.abort();
    return log.content();
}

/// The same for a file. \throws std::runtime_error also "PATH: cannot be opened".
template <class Learner>
StepLogContent replay(const std::string& path, Learner& learner) {
    std::ifstream file = open_text(path);
    return replay(file, path, learner);
}

}  // namespace sspql
