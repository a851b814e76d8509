// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <sspql/core/concepts.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/model/probability.hpp>
#include <sspql/model/transition_counts.hpp>
#include <sspql/paths/shortest_paths.hpp>

namespace sspql {

namespace detail {

/// Learnt counts as a PredecessorGraph whose edges cost weight / P, the expected weight of getting from s to s' by the
/// best action. Reads no labels, so that it disturbs no planner.
template <class Cell>
class ExpectedTriesGraph {
public:
    explicit ExpectedTriesGraph(const TransitionCounts<Cell>& counts) : counts_(&counts) {
        for (std::size_t s = 0; s < size(); ++s) {
            counts.for_each_successor(state_id(s), [&](const auto& successor) {
                const double cost = cost_of(state_id(s), successor);
                least_ = std::min(least_, cost);
                greatest_ = std::max(greatest_, cost);
            });
        }
        if (greatest_ == 0.0) least_ = greatest_ = 1.0;  // no edges
    }

    [[nodiscard]] std::size_t size() const noexcept { return counts_->states(); }
    [[nodiscard]] double least_cost() const noexcept { return least_; }
    [[nodiscard]] double greatest_cost() const noexcept { return greatest_; }

    template <class F>
    void for_each_predecessor(StateId v, F&& f) const {
        counts_->for_each_edge_into(v, [&](StateId u, const auto& successor) { f(u, cost_of(u, successor)); });
    }

private:
    template <class Successor>
    [[nodiscard]] double cost_of(StateId s, const Successor& successor) const {
        return successor.weight() / BestAction{}(*counts_, s, successor);
    }

    const TransitionCounts<Cell>* counts_;
    double least_ = std::numeric_limits<double>::infinity();
    double greatest_ = 0.0;
};

template <class Learner>
using TreeExpression = decltype(std::declval<const Learner&>().tree().next);

template <class Learner>
using GoalsExpression = decltype(std::declval<const Learner&>().goals());

template <class Learner>
using CountsExpression = decltype(std::declval<const Learner&>().counts());

}  // namespace detail

/// The shortest paths to these goals that the counts know of, by expected weight: the sum of weight / P along the path,
/// P the best action's. For looking at what a learner knows that keeps no tree of its own. O(m n_out + n log n) for m
/// distinct (s,s'), n states and out-degrees up to n_out.
/// \throws std::invalid_argument for a goal outside or an offset that is not finite and >= 0.
template <class Cell>
[[nodiscard]] ShortestPathTree learnt_paths(const TransitionCounts<Cell>& counts, const std::vector<Goal>& goals) {
    return shortest_paths_to(detail::ExpectedTriesGraph<Cell>(counts), goals);
}

/// The goals that counts with rewards tell of, by the rule of GoalBook: a state where an episode terminated with a mean
/// reward > 0, and, where steps that do not terminate bring rewards other than 0 (they have costs), every state where
/// one terminated. Ascending. O(m |A|).
template <class Cell>
[[nodiscard]] std::vector<Goal> learnt_goals(const TransitionCounts<Cell>& counts) {
    static_assert(Cell::keeps_rewards, "sspql: learnt_goals needs a Cell that keeps rewards (FadingCell)");
    enum : unsigned char { plain, terminal, rewarding };
    std::vector<unsigned char> kind(counts.states(), plain);
    bool costs_seen = false;
    for (std::size_t s = 0; s < counts.states(); ++s) {
        counts.for_each_successor(state_id(s), [&](const auto& successor) {
            unsigned char& known = kind[index(successor.state())];
            successor.for_each_action([&](ActionId, const Cell& cell) {
                const double reward = cell.mean_reward();
                if (!cell.terminal()) {
                    costs_seen = costs_seen || reward < 0.0 || reward > 0.0;
                } else {
                    known = std::max<unsigned char>(known, reward > 0.0 ? rewarding : terminal);
                }
            });
        });
    }
    std::vector<Goal> goals;
    for (std::size_t s = 0; s < kind.size(); ++s) {
        if (kind[s] == rewarding || (kind[s] == terminal && costs_seen)) goals.push_back({state_id(s), 0.0});
    }
    return goals;
}

/// The shortest paths a learner that keeps counts knows of: its own tree where it has one (Sspql; costs of eq. 2), else
/// those by expected weight to its goals() or, without such a member, to the learnt_goals.
template <class Learner>
[[nodiscard]] auto learnt_paths(const Learner& learner) -> decltype(learner.counts(), ShortestPathTree()) {
    if constexpr (detail::is_detected_v<detail::TreeExpression, Learner>) {
        return learner.tree();
    } else if constexpr (detail::is_detected_v<detail::GoalsExpression, Learner>) {
        return learnt_paths(learner.counts(), learner.goals());
    } else {
        return learnt_paths(learner.counts(), learnt_goals(learner.counts()));
    }
}

}  // namespace sspql
