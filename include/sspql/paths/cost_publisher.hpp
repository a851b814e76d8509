// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>

#include <sspql/core/assert.hpp>
#include <sspql/core/concepts.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/model/probability.hpp>
#include <sspql/model/transition_counts.hpp>
#include <sspql/paths/cost.hpp>

namespace sspql {

namespace detail {

template <class Cost>
using CostExpression = decltype(std::declval<const Cost&>()(double{}, double{}));

template <class Probability>
using ProbabilityExpression = decltype(std::declval<const Probability&>()(
    std::declval<const TransitionCounts<CountCell>&>(), StateId{},
    std::declval<const TransitionCounts<CountCell>::Successor&>()));

}  // namespace detail

/// The only writer of edge labels: brings the expected costs in the counts up to date, dirty states only, and clears
/// their dirty bits. EC(s,s') depends on the counts of s alone, so nothing else can have changed.
template <class Cost = RiskWeighted, class Probability = SumOverActions>
class CostPublisher {
    static_assert(detail::is_detected_convertible_v<double, detail::CostExpression, Cost>,
                  "sspql: this CostPolicy lacks `double operator()(double weight, double probability) const`");
    static_assert(detail::is_detected_convertible_v<double, detail::ProbabilityExpression, Probability>,
                  "sspql: this ProbabilityPolicy lacks `double operator()(const TransitionCounts&, StateId, const "
                  "Successor&) const`");

public:
    explicit CostPublisher(Cost cost = Cost{}, Probability probability = Probability{})
        : cost_(std::move(cost)), probability_(std::move(probability)) {}

    /// Refreshes the out-edges of the dirty states. O(sum of their out-degrees x |A|), no allocation.
    /// \returns the number of edges refreshed.
    template <class Cell>
    std::size_t publish(TransitionCounts<Cell>& counts) const {
        std::size_t edges = 0;
        for (const StateId s : counts.dirty()) {
            counts.for_each_successor(s, [&](const auto& successor) {
                const double cost = cost_(successor.weight(), probability_(counts, s, successor));
                SSPQL_ASSERT(cost >= 0.0 && cost <= 1e300, "a CostPolicy's costs are finite and >= 0");
                counts.set_label(successor, cost);
                ++edges;
            });
        }
        counts.clear_dirty();
        return edges;
    }

    [[nodiscard]] const Cost& cost() const noexcept { return cost_; }

private:
    Cost cost_;
    Probability probability_;
};

}  // namespace sspql
