// SPDX-License-Identifier: MIT
#include "model.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/io/learnt_paths.hpp>
#include <sspql/model/transition_counts.hpp>

namespace sspql::python {

namespace {

template <class Cell>
CountColumns columns_of(const TransitionCounts<Cell>& counts) {
    CountColumns columns;
    columns.whole = std::is_integral_v<typename Cell::Number>;
    columns.rewards = Cell::keeps_rewards;
    struct Row {
        ActionId a;
        StateId next;
        const Cell* cell;
        double weight;
    };
    std::vector<Row> rows;
    for (std::size_t s = 0; s < counts.states(); ++s) {
        rows.clear();
        counts.for_each_successor(state_id(s), [&](const auto& successor) {
            successor.for_each_action([&](ActionId a, const Cell& cell) {
                rows.push_back({a, successor.state(), &cell, successor.weight()});
            });
        });
        std::sort(rows.begin(), rows.end(),
                  [](const Row& x, const Row& y) { return std::make_pair(x.a, x.next) < std::make_pair(y.a, y.next); });
        for (const Row& row : rows) {
            columns.s.push_back(static_cast<Number>(s));
            columns.a.push_back(static_cast<Number>(index(row.a)));
            columns.next.push_back(static_cast<Number>(index(row.next)));
            columns.n.push_back(static_cast<double>(row.cell->count()));
            columns.weight.push_back(row.weight);
            columns.terminal.push_back(row.cell->terminal() ? std::uint8_t{1} : std::uint8_t{0});
            if constexpr (Cell::keeps_rewards) columns.reward_sum.push_back(row.cell->reward_sum);
        }
    }
    return columns;
}

/// f of the counts.
template <class F>
auto with_counts(const AnyLearner& learner, const F& f) {
    const CountsPointer counts = learner.counts();
    if (const auto* whole = std::get_if<const TransitionCounts<CountCell>*>(&counts)) return f(**whole);
    if (const auto* fading = std::get_if<const TransitionCounts<FadingCell>*>(&counts)) return f(**fading);
    throw std::logic_error("this learner keeps no counts");
}

}  // namespace

CountColumns count_columns(const AnyLearner& learner) {
    return with_counts(learner, [](const auto& counts) { return columns_of(counts); });
}

std::vector<Goal> goals_of(const AnyLearner& learner) {
    if (auto own = learner.goals()) return std::move(*own);
    const CountsPointer counts = learner.counts();
    if (const auto* fading = std::get_if<const TransitionCounts<FadingCell>*>(&counts)) return learnt_goals(**fading);
    throw std::logic_error("this learner keeps no counts");
}

ShortestPathTree paths_of(const AnyLearner& learner) {
    if (const ShortestPathTree* own = learner.tree()) return *own;
    return with_counts(learner, [&](const auto& counts) { return learnt_paths(counts, goals_of(learner)); });
}

Explanation explanation_of(const AnyLearner& learner, Number s, const ExplainOptions& options) {
    if (const ShortestPathTree* own = learner.tree()) return learner.explain(s, *own, options);
    const bool keeps_counts = !std::holds_alternative<std::monostate>(learner.counts());
    return learner.explain(s, keeps_counts ? paths_of(learner) : ShortestPathTree{}, options);
}

}  // namespace sspql::python
