// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <sspql/core/assert.hpp>
#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/learn/action_selector.hpp>
#include <sspql/learn/transition.hpp>
#include <sspql/model/transition_counts.hpp>
#include <sspql/paths/shortest_paths.hpp>
#include <sspql/spaces/action_set.hpp>
#include <sspql/spaces/legal_actions.hpp>

namespace sspql {

/// The largest reward and the largest cost of a step.
inline constexpr double max_reward = 1e100;

/// The interface all learners share: ids in, ids out, no environment in sight. An episode is
///
///     a = begin(s);                       choose the first action
///     a = step(reward, s);   ...          learn from the action's outcome, choose the next one
///     end(reward, s, terminated);         learn from the last outcome; `terminated` as in Step
///
/// Besides, at any time: `observe` learns from a step somebody else took, `best` chooses without learning,
/// `terms` says why. Every call checks what it is given before anything changes: a refused call leaves the learner as
/// it was, and the right call can follow.
///
/// Errors: std::logic_error for calls in a wrong order; std::invalid_argument for an id outside, a reward that is NaN or
/// beyond 1e100 either way (sums of larger ones could overflow), a weight outside [1e-30, 1e30], a mask without actions;
/// std::runtime_error where a user's LegalActions allow nothing. Threads: none inside; one thread per learner, const
/// members may run together.
///
/// For implementers (CRTP). Derived supplies, to this base as a friend:
///
///     void add_states(std::size_t n)        make room for n states in all
///     ActionId select(StateId)              choose with exploration
///     void learn(const Transition&)         an outcome; ids and numbers are checked
///     ActionId advance(const Transition& t) optional: learn(t), then select(t.next), which is the default
///     void episode_begun()                  optional: before the first choice of an episode
///     void episode_ended()                  after the last learn of an episode
///     void legal_actions_changed(StateId)   optional: another mask holds
///     double value(StateId, ActionId) const what best() maximises
///     void goals_changed(const std::vector<Goal>&)   other goals hold from now on; empty: discover them
template <class Derived, class LegalActions>
class Learner {
    static_assert(is_legal_actions_v<LegalActions>,
                  "sspql: these LegalActions lack `legal.allowed(StateId).contains(ActionId) -> bool`");

public:
    /// Starts an episode in s.
    [[nodiscard]] ActionId begin(StateId s) {
        if (running()) throw std::logic_error("begin() during an episode: end() or abort() it first");
        const std::size_t states = admitted(s, states_, "state");
        require_choice(s);
        grow_to(states);
        derived().episode_begun();
        state_ = s;
        action_ = derived().select(s);
        return action_;
    }

    /// The chosen action brought `reward` and led to `next`, at the cost of `weight`. Learns, then chooses again.
    [[nodiscard]] ActionId step(double reward, StateId next, double weight = 1.0) {
        const Transition t = outcome(reward, next, false, weight, "step()");
        const ActionId a = derived().advance(t);
        state_ = next;
        action_ = a;
        return a;
    }

    /// The same for the last action of an episode. `terminated`: the task ended; otherwise somebody cut it short, and
    /// `next` keeps its future value.
    void end(double reward, StateId next, bool terminated, double weight = 1.0) {
        derived().learn(outcome(reward, next, terminated, weight, "end()"));
        action_ = no_action;
        derived().episode_ended();
    }

    /// Drops the running episode and the action whose outcome nobody will tell. What was learnt before stays. Does
    /// nothing between episodes.
    void abort() noexcept { action_ = no_action; }

    /// Not the chosen action but `a` is being carried out (a safety layer or an operator stepped in); the next step or
    /// end reports the outcome of `a`.
    void replace_action(ActionId a) {
        if (!running()) throw std::logic_error("replace_action() before begin()");
        action_ = detail::require_action_of(a, actions_);
    }

    /// Learns from a step that somebody else took: a teacher, a log. The running episode is not affected. A terminated
    /// one counts as the end of an episode.
    void observe(StateId s, ActionId a, double reward, StateId next, bool terminated, double weight = 1.0) {
        detail::require_action_of(a, actions_);
        require_outcome(reward, weight);
        const std::size_t states = admitted(next, admitted(s, states_, "state"), "next state");
        if (!terminated) require_choice(next);
        grow_to(states);
        derived().learn({s, a, reward, next, terminated, weight});
        if (terminated) derived().episode_ended();
    }

    /// The best action known in s: no noise, no bonus, nothing learnt; the least id on ties.
    [[nodiscard]] ActionId best(StateId s) const {
        require_known(s);
        require_choice(s);
        return detail::argmax(actions_, legal_.allowed(s), [&](ActionId a) { return derived().value(s, a); });
    }

    /// Other goals from now on, reached before or not; they replace those discovered by rewards, and an empty list goes
    /// back to discovering. What was learnt about the world stays and is used at once; values learnt from rewards for
    /// the old goals, and a trainer's hints, are reset.
    /// \throws std::invalid_argument for a state outside or an offset that is not finite and >= 0.
    void set_goals(const std::vector<Goal>& goals) {
        std::size_t states = states_;
        for (const Goal& goal : goals) states = admitted(goal.state, states, "goal");
        detail::require_goals(goals, states);
        grow_to(states);
        derived().goals_changed(goals);
    }

    /// Which actions s has; the last mask of each state holds. Only where LegalActions can keep masks.
    /// \throws std::invalid_argument for an empty mask, or one whose size is not the number of actions.
    template <class L = LegalActions>
    void set_legal_actions(StateId s, const ActionSet& mask) {
        static_assert(stores_masks_v<L>, "sspql: these LegalActions keep no masks; LegalActionTable does");
        const std::size_t states = admitted(s, states_, "state");
        if (mask.size() != actions_) throw_invalid("size of the mask", "be " + std::to_string(actions_), mask.size());
        if (mask.is_empty()) throw_invalid("mask of state " + std::to_string(index(s)), "allow an action; actions", 0);
        grow_to(states);
        bool changed = false;  // a robot that tells its mask with every step seldom tells anything new
        const auto& allowed = legal_.allowed(s);
        for (std::size_t a = 0; a < actions_; ++a) {
            changed = changed || allowed.contains(action_id(a)) != mask.contains(action_id(a));
        }
        if (!changed) return;
        if constexpr (stores_masks_v<L>) legal_.set(s, mask);  // else the static_assert stays the only error
        derived().legal_actions_changed(s);
    }

    /// Adds states up to `states` in all, for a learner that grows. \throws std::invalid_argument if it does not grow.
    void grow(std::size_t states) {
        if (states <= states_) return;
        if (!grows_) throw_invalid("number of states", "stay " + std::to_string(states_), states);
        detail::require_id_count("number of states", states);
        grow_to(states);
    }

    /// The number of states; of those known so far, if it grows.
    [[nodiscard]] std::size_t states() const noexcept { return states_; }
    /// The number of actions.
    [[nodiscard]] std::size_t actions() const noexcept { return actions_; }
    /// Whether it takes new states.
    [[nodiscard]] bool grows() const noexcept { return grows_; }

    /// Whether an episode is under way.
    [[nodiscard]] bool running() const noexcept { return action_ != no_action; }

    /// The state in which the running episode's last action was chosen; between episodes it means nothing.
    [[nodiscard]] StateId state() const noexcept { return state_; }
    /// The running episode's last action; no_action between episodes.
    [[nodiscard]] ActionId action() const noexcept { return action_; }

    /// Which actions the states have.
    [[nodiscard]] const LegalActions& legal_actions() const noexcept { return legal_; }

protected:
    Learner(StateCount states, std::size_t actions, LegalActions legal)
        : legal_(std::move(legal)),
          states_(states.initial()),
          actions_(detail::require_id_count("number of actions", actions)),
          grows_(states.grows()) {
        if constexpr (std::is_same_v<LegalActions, LegalActionTable>) {
            if (legal_.actions() != 0 && legal_.actions() != actions_) {
                throw_invalid("size of the masks in legal_actions", "be " + std::to_string(actions_), legal_.actions());
            }
        }
    }
    ~Learner() = default;
    Learner(const Learner&) = default;
    Learner(Learner&&) noexcept = default;
    Learner& operator=(const Learner&) = default;
    Learner& operator=(Learner&&) noexcept = default;

    [[nodiscard]] LegalActions& legal() noexcept { return legal_; }
    [[nodiscard]] const LegalActions& legal() const noexcept { return legal_; }

    template <class Archive>
    void serialize(Archive& archive) {
        archive.section("episode", [&] {
            archive(state_, action_);
            archive.policy("legal actions", legal_);
            archive.require(state_ == no_state || index(state_) < states_, "the episode is in a state that is none");
            archive.require(action_ == no_action || (index(action_) < actions_ && state_ != no_state),
                            "the episode's action is none");
            if constexpr (std::is_same_v<LegalActions, LegalActionTable>) {
                archive.require(legal_.actions() == 0 || legal_.actions() == actions_, "masks have another size");
            }
        });
    }

    void episode_begun() noexcept {}
    void legal_actions_changed(StateId /*s*/) noexcept {}

    ActionId advance(const Transition& t) {
        derived().learn(t);
        return derived().select(t.next);
    }

    /// Throws unless s is one of the states there are.
    void require_known(StateId s) const {
        if (index(s) >= states_) refuse_state(s, "state");
    }

    void require_known(StateId s, ActionId a) const {
        require_known(s);
        detail::require_action_of(a, actions_);
    }

    /// The number of states once s is among them, `states` of which there are already.
    [[nodiscard]] std::size_t admitted(StateId s, std::size_t states, const char* what) const {
        if (index(s) < states) return states;
        if (!(grows_ && index(s) == states)) refuse_state(s, what);
        return states + 1;
    }

    void grow_to(std::size_t states) {
        if (states <= states_) return;
        derived().add_states(states);
        states_ = states;
    }

private:
    Derived& derived() noexcept { return static_cast<Derived&>(*this); }
    const Derived& derived() const noexcept { return static_cast<const Derived&>(*this); }

    [[noreturn]] void refuse_state(StateId s, const char* what) const {
        throw_invalid(what, grows_ ? "be at most the number of states so far, " + std::to_string(states_)
                                   : "be below the number of states " + std::to_string(states_),
                      index(s));
    }

    static void require_outcome(double reward, double weight) {
        if (!(std::fabs(reward) <= max_reward)) {  // one comparison a step; then which of the two it is
            require_finite("reward", reward);
            require_in("reward", reward, -max_reward, max_reward);
        }
        require_in("weight", weight, min_weight, max_weight);
    }

    /// A user's own LegalActions may allow nothing; ours never do.
    void require_choice(StateId s) const {
        if constexpr (!std::is_same_v<LegalActions, AllActions> && !std::is_same_v<LegalActions, LegalActionTable>) {
            const auto allowed = legal_.allowed(s);
            for (std::size_t a = 0; a < actions_; ++a) {
                if (allowed.contains(action_id(a))) return;
            }
            throw std::runtime_error("no legal action in state " + std::to_string(index(s)));
        } else {
            static_cast<void>(s);
        }
    }

    /// The outcome of the pending action, checked.
    Transition outcome(double reward, StateId next, bool terminated, double weight, const char* call) {
        if (!running()) throw std::logic_error(std::string(call) + " before begin()");
        require_outcome(reward, weight);
        const std::size_t states = admitted(next, states_, "next state");
        if (!terminated) require_choice(next);
        grow_to(states);
        return {state_, action_, reward, next, terminated, weight};
    }

    LegalActions legal_;
    std::size_t states_;
    std::size_t actions_;
    bool grows_;
    StateId state_ = no_state;
    ActionId action_ = no_action;
};

}  // namespace sspql
