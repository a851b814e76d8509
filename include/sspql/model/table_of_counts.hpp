// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/model/transition_counts.hpp>
#include <sspql/model/transition_table.hpp>
#include <sspql/model/transition_table_builder.hpp>

namespace sspql {

/// The counts read as if they were the truth: P(s'|s,a) = N(s,a,s') / N(s,a) (eq. 4), rewards from
/// `double reward(StateId s, ActionId a, StateId next, const Cell&)`, terminal as last seen. A state has the actions
/// that were tried in it; episodes start in any state that has some. Where a state was entered in which nothing was tried
/// yet, nothing is known of what follows: such outcomes become terminal. O(n log n) in the number of (s,a,s').
/// \throws std::invalid_argument if nothing was counted yet, or for a reward that is not finite.
template <class Cell, class Reward>
[[nodiscard]] TransitionTable table_of(const TransitionCounts<Cell>& counts, const Reward& reward) {
    TransitionTableBuilder builder(counts.states(), counts.actions());
    std::vector<char> tried(counts.states(), 0);
    for (std::size_t s = 0; s < counts.states(); ++s) {
        for (std::size_t a = 0; a < counts.actions(); ++a) {
            if (counts.n(state_id(s), action_id(a)) > typename Cell::Number{0}) tried[s] = 1;
        }
    }
    std::vector<double> totals(counts.actions());
    for (std::size_t i = 0; i < counts.states(); ++i) {
        const StateId s = state_id(i);
        // Summed here: fading leaves N(s,a) a rounding away from its parts.
        totals.assign(counts.actions(), 0.0);
        counts.for_each_successor(s, [&](const auto& successor) {
            successor.for_each_action(
                [&](ActionId a, const Cell& cell) { totals[index(a)] += static_cast<double>(cell.count()); });
        });
        counts.for_each_successor(s, [&](const auto& successor) {
            const StateId next = successor.state();
            successor.for_each_action([&](ActionId a, const Cell& cell) {
                const auto n = static_cast<double>(cell.count());
                const bool terminal = cell.terminal() || tried[index(next)] == 0;
                if (n > 0.0) builder.add(s, a, next, n / totals[index(a)], reward(s, a, next, cell), terminal);
            });
        });
    }
    return builder.build();
}

/// The same with the mean rewards that the cells keep; for integer counts, which keep none, it does not compile.
template <class Cell>
[[nodiscard]] TransitionTable table_of(const TransitionCounts<Cell>& counts) {
    static_assert(Cell::keeps_rewards,
                  "sspql: these counts keep no rewards; use TransitionCounts<FadingCell> or table_of(counts, reward)");
    return table_of(counts, [](StateId, ActionId, StateId, const Cell& cell) {
        if constexpr (Cell::keeps_rewards) {
            return cell.mean_reward();
        } else {
            return 0.0;  // refused above
        }
    });
}

}  // namespace sspql
