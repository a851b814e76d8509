// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

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

}  // namespace detail

/// The shortest paths to these goals that the counts know of, by expected weight: the sum of weight / P along the path,
/// P the best action's. For looking at what a learner knows that keeps no tree of its own. O(m n_out + n log n) for m
/// distinct (s,s'), n states and out-degrees up to n_out.
/// \throws std::invalid_argument for a goal outside or an offset that is not finite and >= 0.
template <class Cell>
[[nodiscard]] ShortestPathTree learnt_paths(const TransitionCounts<Cell>& counts, const std::vector<Goal>& goals) {
    return shortest_paths_to(detail::ExpectedTriesGraph<Cell>(counts), goals);
}

}  // namespace sspql
