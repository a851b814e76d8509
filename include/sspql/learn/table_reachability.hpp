// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/model/transition_table.hpp>

/// \file
/// Questions about a TransitionTable that need no numbers: where can one get to, and from where is one sure to arrive?
/// All O(states x actions + outcomes) time and memory, except sure_pairs.

namespace sspql::detail {

/// The non-terminal edges of a table backwards: into each state, the pairs (s,a) that may lead there. Pair (s,a) has
/// the number s * actions + a. Only pairs with `uses(s, a)`.
class IncomingPairs {
public:
    template <class Uses>
    IncomingPairs(const TransitionTable& table, const Uses& uses) : offsets_(table.states() + 1, 0) {
        for_each_edge(table, uses, [&](std::size_t, StateId next) { ++offsets_[index(next) + 1]; });
        for (std::size_t s = 1; s < offsets_.size(); ++s) offsets_[s] += offsets_[s - 1];
        pairs_.resize(offsets_.back());
        std::vector<std::size_t> at(offsets_.begin(), offsets_.end() - 1);
        for_each_edge(table, uses, [&](std::size_t pair, StateId next) { pairs_[at[index(next)]++] = pair; });
    }

    /// Calls f(pair) for every pair that may lead to s; more than once where several of its outcomes do.
    template <class F>
    void for_each(std::size_t s, F&& f) const {
        for (std::size_t i = offsets_[s]; i < offsets_[s + 1]; ++i) f(pairs_[i]);
    }

private:
    template <class Uses, class F>
    static void for_each_edge(const TransitionTable& table, const Uses& uses, F&& f) {
        for (std::size_t pair = 0; pair < table.states() * table.actions(); ++pair) {
            const StateId s = state_id(pair / table.actions());
            const ActionId a = action_id(pair % table.actions());
            if (!uses(s, a)) continue;
            for (const Outcome& outcome : table.outcomes(s, a)) {
                if (!outcome.terminal) f(pair, outcome.next);
            }
        }
    }

    std::vector<std::size_t> offsets_;
    std::vector<std::size_t> pairs_;
};

/// 1 for every state that an episode may visit, terminal outcomes not counted.
inline std::vector<char> reachable_states(const TransitionTable& table) {
    std::vector<char> reached(table.states(), 0);
    std::vector<StateId> todo = table.starts();
    for (const StateId s : todo) reached[index(s)] = 1;
    while (!todo.empty()) {
        const StateId s = todo.back();
        todo.pop_back();
        for (std::size_t a = 0; a < table.actions(); ++a) {
            for (const Outcome& outcome : table.outcomes(s, action_id(a))) {
                if (outcome.terminal || reached[index(outcome.next)] != 0) continue;
                reached[index(outcome.next)] = 1;
                todo.push_back(outcome.next);
            }
        }
    }
    return reached;
}

/// 1 for every state from which some way of acting may end the episode.
inline std::vector<char> states_that_can_end(const TransitionTable& table) {
    std::vector<char> can(table.states(), 0);
    std::vector<std::size_t> todo;
    const auto reach = [&](std::size_t pair) {
        const std::size_t s = pair / table.actions();
        if (can[s] != 0) return;
        can[s] = 1;
        todo.push_back(s);
    };
    for (std::size_t pair = 0; pair < table.states() * table.actions(); ++pair) {
        for (const Outcome& outcome :
             table.outcomes(state_id(pair / table.actions()), action_id(pair % table.actions()))) {
            if (outcome.terminal) reach(pair);
        }
    }
    const IncomingPairs incoming(table, [](StateId, ActionId) { return true; });
    while (!todo.empty()) {
        const std::size_t s = todo.back();
        todo.pop_back();
        incoming.for_each(s, reach);
    }
    return can;
}

/// Which states and pairs are left once nothing can go wrong any more.
struct SurePairs {
    std::vector<char> state;  ///< 1: some way of choosing among the sure pairs arrives with probability 1
    std::vector<char> pair;   ///< 1: (s,a), number s * actions + a, never leaves the sure states
};

/// The states from which the episode can be made to end with a `target(outcome)` with probability 1, choosing among the
/// pairs with `uses(s, a)`; de Alfaro's "almost sure" reachability: pairs that may lead to a state from which the
/// target cannot be reached are dropped until nothing changes. O(rounds x (states x actions + outcomes)), at most as
/// many rounds as states, a few in practice.
template <class Uses, class Target>
SurePairs sure_pairs(const TransitionTable& table, const Uses& uses, const Target& target) {
    const std::size_t actions = table.actions();
    SurePairs sure{std::vector<char>(table.states(), 0), std::vector<char>(table.states() * actions, 0)};
    std::vector<char> hits(sure.pair.size(), 0);  // pairs that may end with the target
    for (std::size_t pair = 0; pair < sure.pair.size(); ++pair) {
        const StateId s = state_id(pair / actions);
        const ActionId a = action_id(pair % actions);
        if (table.outcomes(s, a).empty() || !uses(s, a)) continue;
        sure.pair[pair] = 1;
        for (const Outcome& outcome : table.outcomes(s, a)) {
            if (!outcome.terminal) continue;
            if (target(outcome)) {
                hits[pair] = 1;
            } else {
                sure.pair[pair] = 0;
            }
        }
        sure.state[index(s)] = 1;
    }
    const IncomingPairs incoming(table, uses);
    std::vector<std::size_t> todo;
    for (;;) {
        // From where can the target be reached at all?
        std::vector<char> reaches(table.states(), 0);
        const auto reach = [&](std::size_t pair) {
            if (sure.pair[pair] == 0 || reaches[pair / actions] != 0) return;
            reaches[pair / actions] = 1;
            todo.push_back(pair / actions);
        };
        for (std::size_t pair = 0; pair < hits.size(); ++pair) {
            if (hits[pair] != 0) reach(pair);
        }
        while (!todo.empty()) {
            const std::size_t s = todo.back();
            todo.pop_back();
            incoming.for_each(s, reach);
        }
        // Drop what leads elsewhere.
        bool dropped = false;
        for (std::size_t s = 0; s < table.states(); ++s) {
            if (reaches[s] != 0) continue;
            dropped = dropped || sure.state[s] != 0;
            sure.state[s] = 0;
            for (std::size_t a = 0; a < actions; ++a) sure.pair[s * actions + a] = 0;
            incoming.for_each(s, [&](std::size_t pair) { sure.pair[pair] = 0; });
        }
        if (!dropped) return sure;
    }
}

}  // namespace sspql::detail
