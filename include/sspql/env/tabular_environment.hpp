// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/random.hpp>
#include <sspql/env/environment.hpp>
#include <sspql/model/transition_table.hpp>

namespace sspql {

/// Environment: a TransitionTable acted out. Observation: the state (EnumState<StateId>(table.states())); command: the
/// action (EnumActions<ActionId>(table.actions())).
///
/// Chance: reset(seed) draws the start from RandomStream::environment, each step takes exactly one number from
/// RandomStream::noise, also where only one outcome is possible. A step is O(outcomes of (s,a)), without allocation.
class TabularEnvironment {
public:
    /// The agent is nowhere until reset().
    explicit TabularEnvironment(TransitionTable table) : table_(std::move(table)), noise_(0, RandomStream::noise) {}

    /// Starts an episode; all of its chance comes from the seed. \returns the start.
    StateId reset(std::uint64_t seed) {
        Random start(seed, RandomStream::environment);
        noise_ = Random(seed, RandomStream::noise);
        state_ = table_.starts()[start.below(table_.starts().size())];
        running_ = true;
        return state_;
    }

    /// Draws an outcome of the action.
    /// \throws std::logic_error before reset() and after the end of an episode; std::invalid_argument for an action
    /// that the state does not have. Nothing has changed then.
    Step<StateId> step(ActionId a) {
        if (!running_) throw std::logic_error("step() outside an episode: reset() first");
        if (!table_.allowed(state_).contains(a)) {
            throw_invalid("action", "be one of state " + std::to_string(index(state_)), index(a));
        }
        const Outcome& outcome = draw(table_.outcomes(state_, a));
        state_ = outcome.next;
        running_ = !outcome.terminal;
        return {outcome.next, outcome.reward, outcome.terminal, false};
    }

    /// The table that is acted out.
    [[nodiscard]] const TransitionTable& table() const noexcept { return table_; }

    /// Number of states.
    [[nodiscard]] std::size_t size() const noexcept { return table_.states(); }

    /// Where the agent is; no_state before the first reset().
    [[nodiscard]] StateId state() const noexcept { return state_; }

private:
    /// The last outcome takes what rounding leaves.
    const Outcome& draw(TransitionTable::Outcomes outcomes) noexcept {
        double rest = noise_.uniform();
        std::size_t i = 0;
        while (i + 1 < outcomes.size() && rest >= outcomes[i].probability) rest -= outcomes[i++].probability;
        return outcomes[i];
    }

    TransitionTable table_;
    Random noise_;
    StateId state_ = no_state;
    bool running_ = false;
};

}  // namespace sspql
