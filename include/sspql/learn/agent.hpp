// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <sspql/core/concepts.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/learn/adaptive_sspql.hpp>
#include <sspql/learn/sspql.hpp>
#include <sspql/learn/transition.hpp>
#include <sspql/spaces/action_policy.hpp>
#include <sspql/spaces/action_set.hpp>
#include <sspql/spaces/state_policy.hpp>

namespace sspql {

namespace detail {

struct AgentArchive;  // io/checkpoint.hpp

}  // namespace detail

/// A learner that speaks the robot's own language: observations in, commands out.
///
///     sspql::Agent robot(state_policy, action_policy);          learns with the adaptive planner
///     sspql::Agent robot(state_policy, action_policy, sspql::paper());              with SSPQL as published
///     sspql::Agent robot(state_policy, action_policy, sspql::QLearningParams<>{}, seed);
///
///     Command c = robot.begin(observation);                     an episode
///     c = robot.step(reward, observation);   ...
///     robot.end(reward, observation, terminated);
///
/// StatePolicy turns an observation into a state, ActionPolicy an action into a command, Learner does the rest; see
/// their files for what they must offer. The learner gets a fixed number of states where the StatePolicy knows it, and
/// grows with one that discovers them (HashedState). A call may carry the set of actions that are legal now; the last
/// set given for a state holds.
///
/// Everything is held by value. Errors, complexity and threads are the Learner's, plus what encode and decode throw; a
/// refused call changes nothing that was learnt.
template <class StatePolicy, class ActionPolicy, class Learner = AdaptiveSspql<>>
class Agent {
    static_assert(detail::is_detected_convertible_v<std::size_t, detail::SizeExpression, StatePolicy>,
                  "sspql: this StatePolicy lacks `std::size_t size() const`");
    static_assert(detail::is_detected_convertible_v<std::size_t, detail::ActionSizeExpression, ActionPolicy>,
                  "sspql: this ActionPolicy lacks `std::size_t size() const`");
    static_assert(detail::is_detected_v<detail::DecodeExpression, ActionPolicy>,
                  "sspql: this ActionPolicy lacks `Command decode(sspql::ActionId) const`");

public:
    /// The learner's parameters, by name.
    using Params = typename Learner::Params;
    /// What the robot is told to do: what the ActionPolicy decodes to.
    using Command = CommandOf<ActionPolicy>;

    /// Knows nothing yet. `seed` is the learner's: where the same things happen, the same seed acts alike.
    /// \throws std::invalid_argument for policies without states or actions, or parameters out of range.
    Agent(StatePolicy states, ActionPolicy actions, Params params = {}, std::uint64_t seed = 0)
        : states_(std::move(states)),
          actions_(std::move(actions)),
          learner_(state_count(), action_count(), std::move(params), seed) {}

    /// Starts an episode: the first command.
    template <class Observation>
    [[nodiscard]] Command begin(const Observation& observation) {
        return decode(learner_.begin(encode(observation)));
    }
    /// The same where only `legal` may be chosen in this state, from now on.
    template <class Observation>
    [[nodiscard]] Command begin(const Observation& observation, const ActionSet& legal) {
        const StateId s = encode(observation);
        learner_.set_legal_actions(s, legal);
        return decode(learner_.begin(s));
    }

    /// The last command brought `reward` and led to `observation`, at the cost of `weight` (1 counts steps): the next
    /// command.
    template <class Observation>
    [[nodiscard]] Command step(double reward, const Observation& observation, double weight = 1.0) {
        return decode(learner_.step(reward, encode(observation), weight));
    }
    /// The same where only `legal` may be chosen in the state of `observation`, from now on.
    template <class Observation>
    [[nodiscard]] Command step(double reward, const Observation& observation, const ActionSet& legal,
                               double weight = 1.0) {
        const StateId s = encode(observation);
        learner_.set_legal_actions(s, legal);
        return decode(learner_.step(reward, s, weight));
    }

    /// Ends the episode. `terminated`: the task itself ended (goal or failure), not the operator or a time limit.
    template <class Observation>
    void end(double reward, const Observation& observation, bool terminated, double weight = 1.0) {
        learner_.end(reward, encode(observation), terminated, weight);
    }

    /// Drops the running episode after an emergency stop; what was learnt stays.
    void abort() noexcept { learner_.abort(); }

    /// Another action than the chosen one is being carried out.
    void replace_action(ActionId a) { learner_.replace_action(a); }

    /// Learns from a step that somebody else took.
    template <class Observation>
    void observe(const Observation& observation, ActionId a, double reward, const Observation& next, bool terminated,
                 double weight = 1.0) {
        const StateId s = encode(observation);
        const StateId s2 = encode(next);
        learner_.observe(s, a, reward, s2, terminated, weight);
    }

    /// A trainer's hint: here, this action. See ValueLearner::teach.
    template <class Observation>
    void teach(const Observation& observation, ActionId a, double strength = 1.0) {
        learner_.teach(encode(observation), a, strength);
    }

    /// The best command known here: no exploration, nothing learnt.
    template <class Observation>
    [[nodiscard]] Command best(const Observation& observation) {
        return decode(learner_.best(encode(observation)));
    }

    /// Why: the terms of eq. 8 for an action here.
    template <class Observation>
    [[nodiscard]] ActionTerms terms(const Observation& observation, ActionId a) {
        return learner_.terms(encode(observation), a);
    }

    /// Other goals from now on, given as observations of equal worth; the model stays. See Learner::set_goals.
    template <class Observation>
    void set_goals(const std::vector<Observation>& observations) {
        std::vector<Goal> goals;
        for (const Observation& observation : observations) goals.push_back({encode(observation), 0.0});
        learner_.set_goals(goals);
    }

    /// The state of an observation. A StatePolicy that grows may add it.
    template <class Observation>
    [[nodiscard]] StateId state(const Observation& observation) {
        return encode(observation);
    }

    /// The learner, for all that an Agent does not do itself.
    [[nodiscard]] Learner& learner() noexcept { return learner_; }
    /// The same for reading.
    [[nodiscard]] const Learner& learner() const noexcept { return learner_; }
    /// The StatePolicy.
    [[nodiscard]] const StatePolicy& states() const noexcept { return states_; }
    /// The ActionPolicy.
    [[nodiscard]] const ActionPolicy& actions() const noexcept { return actions_; }

private:
    friend detail::AgentArchive;

    // The static_asserts name what is missing; `if constexpr` keeps it the only error.

    [[nodiscard]] StateCount state_count() const {
        if constexpr (grows_v<StatePolicy>) {
            return StateCount::growing();
        } else if constexpr (detail::is_detected_v<detail::SizeExpression, StatePolicy>) {
            return StateCount(static_cast<std::size_t>(states_.size()));
        } else {
            return StateCount::growing();
        }
    }

    [[nodiscard]] std::size_t action_count() const {
        if constexpr (detail::is_detected_v<detail::ActionSizeExpression, ActionPolicy>) {
            return static_cast<std::size_t>(actions_.size());
        } else {
            return 0;
        }
    }

    template <class Observation>
    [[nodiscard]] StateId encode(const Observation& observation) {
        constexpr bool encodes =
            detail::is_detected_convertible_v<StateId, detail::EncodeExpression, StatePolicy, Observation>;
        static_assert(encodes, "sspql: this StatePolicy lacks `sspql::StateId encode(const Observation&)` for the "
                               "observation it was given");
        if constexpr (encodes) {
            const StateId s = states_.encode(observation);
            // A new key counts as a state at once, even if the call it came with is refused.
            if constexpr (grows_v<StatePolicy>) learner_.grow(states_.size());
            return s;
        } else {
            return no_state;
        }
    }

    [[nodiscard]] Command decode(ActionId a) const {
        if constexpr (detail::is_detected_v<detail::DecodeExpression, ActionPolicy>) {
            return actions_.decode(a);
        } else {
            static_cast<void>(a);
            return Command{};
        }
    }

    StatePolicy states_;
    ActionPolicy actions_;
    Learner learner_;
};

template <class StatePolicy, class ActionPolicy>
Agent(StatePolicy, ActionPolicy) -> Agent<StatePolicy, ActionPolicy, AdaptiveSspql<>>;

template <class StatePolicy, class ActionPolicy, class Params>
Agent(StatePolicy, ActionPolicy, Params) -> Agent<StatePolicy, ActionPolicy, typename Params::Learner>;

template <class StatePolicy, class ActionPolicy, class Params>
Agent(StatePolicy, ActionPolicy, Params, std::uint64_t) -> Agent<StatePolicy, ActionPolicy, typename Params::Learner>;

}  // namespace sspql
