// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <sspql/core/assert.hpp>
#include <sspql/core/concepts.hpp>
#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/model/probability.hpp>
#include <sspql/model/transition_counts.hpp>
#include <sspql/paths/cost.hpp>
#include <sspql/paths/published_changes.hpp>

namespace sspql {

namespace detail {

template <class Cost>
using CostExpression = decltype(std::declval<const Cost&>()(double{}, double{}));

template <class Probability>
using ProbabilityExpression = decltype(std::declval<const Probability&>()(
    std::declval<const TransitionCounts<CountCell>&>(), StateId{},
    std::declval<const TransitionCounts<CountCell>::Successor&>()));

/// policy(counts, s, successor).
template <class Probability, class Cell>
double edge_probability(const Probability& policy, const TransitionCounts<Cell>& counts, StateId s,
                        const typename TransitionCounts<Cell>::Successor& successor) {
    return policy(counts, s, successor);
}

/// The same sum to the bit, 0 for each action that did not lead there: with few actions, the divisions cost less than
/// guessing which to skip.
template <class Cell>
double edge_probability(const SumOverActions& policy, const TransitionCounts<Cell>& counts, StateId s,
                        const typename TransitionCounts<Cell>::Successor& successor) {
    if (counts.actions() > 8) return policy(counts, s, successor);
    double sum = 0.0;
    for (std::size_t a = 0; a < counts.actions(); ++a) {
        const auto total = static_cast<double>(counts.n(s, action_id(a)));
        sum += static_cast<double>(successor.n(action_id(a))) / (total > 0.0 ? total : 1.0);
    }
    return sum;
}

/// f(s) for every dirty state. In a large graph the labels it will compare lie outside the caches, and are asked for
/// ahead.
template <class Cell, class F>
void for_each_dirty(const TransitionCounts<Cell>& counts, const F& f) {
    constexpr std::size_t ahead = 8;
    const std::vector<StateId>& dirty = counts.dirty();
    const bool large = counts.states() >= 30000;
    for (std::size_t i = 0; i < dirty.size(); ++i) {
        if (large && i + ahead < dirty.size()) {
            counts.for_each_successor(dirty[i + ahead], [](const auto& successor) { successor.prefetch_label(); });
        }
        f(dirty[i]);
    }
}

}  // namespace detail

/// The only writer of edge labels: brings the expected costs in the counts up to date, dirty states only, and clears
/// their dirty bits. EC(s,s') depends on the counts of s alone, so nothing else can have changed.
///
/// With a `tolerance` eps > 0 a label is rewritten only when it is off by more than eps of the new cost, so that small
/// drifts of well-known probabilities set nothing in motion; an edge without a label always gets one. All labels then
/// lie within a factor 1 -+ eps of the true costs, and a shortest path by the labels costs at most (1 + eps) / (1 -
/// eps) times the optimum under the true costs (of those at or above the floor of ReverseGraph). 0: any change counts.
/// Threads: const members may run together on different counts.
template <class Cost = RiskWeighted, class Probability = SumOverActions>
class CostPublisher {
    static_assert(detail::is_detected_convertible_v<double, detail::CostExpression, Cost>,
                  "sspql: this CostPolicy lacks `double operator()(double weight, double probability) const`");
    static_assert(detail::is_detected_convertible_v<double, detail::ProbabilityExpression, Probability>,
                  "sspql: this ProbabilityPolicy lacks `double operator()(const TransitionCounts&, StateId, const "
                  "Successor&) const`");

public:
    /// The largest tolerance.
    static constexpr double most_tolerance = 0.5;

    /// Labels are those of these two policies. \throws std::invalid_argument for a tolerance outside [0, 0.5].
    explicit CostPublisher(Cost cost = Cost{}, Probability probability = Probability{}, double tolerance = 0.0)
        : cost_(std::move(cost)),
          probability_(std::move(probability)),
          tolerance_(require_in("tolerance of edge costs", tolerance, 0.0, most_tolerance)) {}

    /// Refreshes the out-edges of the dirty states. O(sum of their out-degrees x |A|), no allocation.
    /// \returns the number of edges refreshed.
    template <class Cell>
    std::size_t publish(TransitionCounts<Cell>& counts) const {
        std::size_t edges = 0;
        detail::for_each_dirty(counts, [&](StateId s) { edges += refresh(counts, s, [](StateId, double, double) {}); });
        counts.clear_dirty();
        return edges;
    }

    /// The same, adding to a report what was refreshed and what changed; allocates where the report grows.
    template <class Cell>
    std::size_t publish(TransitionCounts<Cell>& counts, PublishedChanges& changes) const {
        std::size_t edges = 0;
        detail::for_each_dirty(counts, [&](StateId s) { edges += publish_state(counts, s, changes); });
        counts.clear_dirty();
        return edges;
    }

    /// The same for one state, whose dirty bit stays as it is: for callers that keep a list of dirty states themselves.
    template <class Cell>
    std::size_t publish_state(TransitionCounts<Cell>& counts, StateId s, PublishedChanges& changes) const {
        changes.add_state(s);
        const std::size_t edges = refresh(counts, s, [&](StateId next, double old_cost, double new_cost) {
            changes.add_edge(s, next, old_cost, new_cost);
        });
        changes.add_touched(edges);
        return edges;
    }

    /// The policy of costs.
    [[nodiscard]] const Cost& cost() const noexcept { return cost_; }
    /// As given, in [0, 0.5].
    [[nodiscard]] double tolerance() const noexcept { return tolerance_; }

private:
    template <class Cell, class Changed>
    std::size_t refresh(TransitionCounts<Cell>& counts, StateId s, const Changed& changed) const {
        std::size_t edges = 0;
        counts.for_each_successor(s, [&](const auto& successor) {
            const double cost = cost_(successor.weight(), detail::edge_probability(probability_, counts, s, successor));
            SSPQL_ASSERT(cost >= 0.0 && cost <= 1e300, "a CostPolicy's costs are finite and >= 0");
            ++edges;
            const double label = successor.label();
            const bool kept = std::fabs(cost - label) <= tolerance_ * cost;  // not for NaN: no label yet
            counts.set_label(successor, kept ? label : cost);  // either way: nobody can predict which will change
            if (!kept) changed(successor.state(), label, cost);
        });
        return edges;
    }

    Cost cost_;
    Probability probability_;
    double tolerance_;
};

}  // namespace sspql
