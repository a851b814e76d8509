// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <sspql/core/assert.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/spaces/action_set.hpp>

namespace sspql {

/// One way in which an action may turn out: with this probability the state is `next`, after this reward, and if
/// `terminal`, the episode has ended.
struct Outcome {
    StateId next{};            ///< the state it leads to
    double probability = 1.0;  ///< of this outcome given (s,a), in (0, 1]
    double reward = 0.0;       ///< that it brings, finite
    bool terminal = false;     ///< whether it ends the episode
};

/// A Markov decision process that is known exactly: P(s',r,terminal|s,a) and the states in which episodes start (all
/// alike). Immutable; made by TransitionTableBuilder, which checks it. The counterpart of TransitionCounts, which is
/// what a learner found out; exact values come from learn/exact_values.hpp.
///
/// A state has the actions for which outcomes are listed; states that only terminal outcomes enter need none. So the
/// table is itself a LegalActions (`allowed`). Ids are asserted, not checked.
/// Memory: 4 bytes per (s,a) and 32 per outcome. All members O(1) unless they say otherwise.
class TransitionTable {
public:
    /// The outcomes of one (s,a), ordered by next state, reward, terminal. A view, valid as long as the table.
    class Outcomes {
    public:
        /// The outcomes from `first` up to `last`, which is none of them.
        Outcomes(const Outcome* first, const Outcome* last) noexcept : first_(first), last_(last) {}
        /// The first outcome.
        [[nodiscard]] const Outcome* begin() const noexcept { return first_; }
        /// Past the last outcome.
        [[nodiscard]] const Outcome* end() const noexcept { return last_; }
        /// How many outcomes there are.
        [[nodiscard]] std::size_t size() const noexcept { return static_cast<std::size_t>(last_ - first_); }
        /// Whether there are none: the state does not have the action.
        [[nodiscard]] bool empty() const noexcept { return first_ == last_; }
        /// Outcome i, 0 to size() - 1.
        [[nodiscard]] const Outcome& operator[](std::size_t i) const noexcept { return first_[i]; }

    private:
        const Outcome* first_;
        const Outcome* last_;
    };

    /// The actions of one state. A view, valid as long as the table.
    class Allowed {
    public:
        /// Those a < `actions` with offsets[a] < offsets[a + 1]: they have outcomes.
        Allowed(const std::uint32_t* offsets, std::size_t actions) noexcept : offsets_(offsets), actions_(actions) {}
        /// Whether the state has the action; false also for ids outside.
        [[nodiscard]] bool contains(ActionId a) const noexcept {
            return index(a) < actions_ && offsets_[index(a)] < offsets_[index(a) + 1];
        }

    private:
        const std::uint32_t* offsets_;
        std::size_t actions_;
    };

    /// The number of states.
    [[nodiscard]] std::size_t states() const noexcept { return states_; }
    /// The number of actions.
    [[nodiscard]] std::size_t actions() const noexcept { return actions_; }

    /// Outcomes of all (s,a) together.
    [[nodiscard]] std::size_t size() const noexcept { return outcomes_.size(); }

    /// Empty if s does not have this action.
    [[nodiscard]] Outcomes outcomes(StateId s, ActionId a) const noexcept {
        SSPQL_ASSERT(index(s) < states_ && index(a) < actions_, "ids within range");
        const std::uint32_t* at = offsets_.data() + index(s) * actions_ + index(a);
        return {outcomes_.data() + at[0], outcomes_.data() + at[1]};
    }

    /// The actions of s.
    [[nodiscard]] Allowed allowed(StateId s) const noexcept {
        SSPQL_ASSERT(index(s) < states_, "ids within range");
        return {offsets_.data() + index(s) * actions_, actions_};
    }

    /// Whether s has any action.
    [[nodiscard]] bool has_actions(StateId s) const noexcept {
        SSPQL_ASSERT(index(s) < states_, "ids within range");
        return offsets_[index(s) * actions_] < offsets_[(index(s) + 1) * actions_];
    }

    /// The actions of s as a mask for Learner::set_legal_actions; empty for a state without actions. O(actions).
    /// \throws std::invalid_argument for a table of more than ActionSet::most actions.
    [[nodiscard]] ActionSet action_set(StateId s) const {
        ActionSet set = ActionSet::none(actions_);
        for (std::size_t a = 0; a < actions_; ++a) {
            if (allowed(s).contains(action_id(a))) set.insert(action_id(a));
        }
        return set;
    }

    /// The states in which episodes start, each as often as the others; ascending, never empty.
    [[nodiscard]] const std::vector<StateId>& starts() const noexcept { return starts_; }

    /// The greatest reward of a terminal outcome; none if nothing ever ends.
    [[nodiscard]] std::optional<double> best_terminal_reward() const noexcept { return best_terminal_reward_; }

    /// Whether an episode that ended with this reward was a success: the reward is > 0 or, in a table without such
    /// terminal rewards, not less than the best terminal one.
    [[nodiscard]] bool is_success(double terminal_reward) const noexcept {
        if (!best_terminal_reward_) return false;
        return *best_terminal_reward_ > 0.0 ? terminal_reward > 0.0 : terminal_reward >= *best_terminal_reward_;
    }

private:
    friend class TransitionTableBuilder;
    TransitionTable(std::size_t states, std::size_t actions) : states_(states), actions_(actions) {}

    std::size_t states_;
    std::size_t actions_;
    std::vector<std::uint32_t> offsets_;  // of (s,a) into outcomes_, and the end
    std::vector<Outcome> outcomes_;
    std::vector<StateId> starts_;
    std::optional<double> best_terminal_reward_;
};

}  // namespace sspql
