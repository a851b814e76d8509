// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/model/transition_counts.hpp>

#include "any_learner.hpp"

namespace sspql::python {

/// The rows save_npy writes (io/npy.hpp), in memory. O(rows).
template <class Cell>
[[nodiscard]] CountColumns columns_of(const TransitionCounts<Cell>& counts) {
    CountColumns columns;
    columns.whole = std::is_integral_v<typename Cell::Number>;
    columns.rewards = Cell::keeps_rewards;
    std::vector<std::pair<std::pair<Number, Number>, std::pair<const Cell*, double>>>
        rows;  // (a, next), (cell, weight)
    for (std::size_t s = 0; s < counts.states(); ++s) {
        rows.clear();
        counts.for_each_successor(state_id(s), [&](const auto& successor) {
            successor.for_each_action([&](ActionId a, const Cell& cell) {
                rows.push_back({{static_cast<Number>(index(a)), static_cast<Number>(index(successor.state()))},
                                {&cell, successor.weight()}});
            });
        });
        std::sort(rows.begin(), rows.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
        for (const auto& [ids, entry] : rows) {
            columns.s.push_back(static_cast<Number>(s));
            columns.a.push_back(ids.first);
            columns.next.push_back(ids.second);
            columns.n.push_back(static_cast<double>(entry.first->count()));
            columns.weight.push_back(entry.second);
            columns.terminal.push_back(entry.first->terminal() ? std::uint8_t{1} : std::uint8_t{0});
            if constexpr (Cell::keeps_rewards) columns.reward_sum.push_back(entry.first->reward_sum);
        }
    }
    return columns;
}

}  // namespace sspql::python
