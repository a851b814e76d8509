// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>

#include <sspql/core/ids.hpp>
#include <sspql/model/transition_counts.hpp>

/// \file
/// The maximum-likelihood reading of the counts: eqs. 3, 4 and 6 of Kwon, Suh and Lee (2011).
///
/// ProbabilityPolicy (concept): `double operator()(const TransitionCounts&, StateId s, const Successor&) const`, the
/// P(s'|s) that enters the expected cost of an edge. 0 < P.

namespace sspql {

/// P(s'|s,a) = N(s,a,s') / N(s,a) (eq. 4), in [0, 1]; 0 for an action never tried in s.
///
/// Deviation: the print gives untried actions a small mu instead of 0, which would join every state with every other;
/// with observed edges only, the paths come out the same.
template <class Cell>
[[nodiscard]] double probability(const TransitionCounts<Cell>& counts, StateId s, ActionId a, StateId next) {
    const auto total = static_cast<double>(counts.n(s, a));
    return total > 0.0 ? static_cast<double>(counts.n(s, a, next)) / total : 0.0;
}

/// P(s'|s) = sum_a P(s'|s,a) (eq. 3), as printed: over all actions, so no probability; it lies in (0, |A|].
struct SumOverActions {
    static constexpr const char* type_name = "sum over actions";  ///< in checkpoints

    /// P(s'|s) of a successor of s. O(actions that led there).
    template <class Cell>
    [[nodiscard]] double operator()(const TransitionCounts<Cell>& counts, StateId s,
                                    const typename TransitionCounts<Cell>::Successor& successor) const {
        double sum = 0.0;
        successor.for_each_action([&](ActionId a, const Cell& cell) {
            sum += static_cast<double>(cell.count()) / static_cast<double>(counts.n(s, a));
        });
        return sum;
    }
};

/// P(s'|s) = max_a P(s'|s,a), in (0, 1]: the chance of getting there when trying to. Needed by ExpectedTries.
struct BestAction {
    static constexpr const char* type_name = "best action";  ///< in checkpoints

    /// P(s'|s) of a successor of s. O(actions that led there).
    template <class Cell>
    [[nodiscard]] double operator()(const TransitionCounts<Cell>& counts, StateId s,
                                    const typename TransitionCounts<Cell>::Successor& successor) const {
        double best = 0.0;
        successor.for_each_action([&](ActionId a, const Cell& cell) {
            const double p = static_cast<double>(cell.count()) / static_cast<double>(counts.n(s, a));
            if (p > best) best = p;
        });
        return best;
    }
};

/// H(s,a) = -sum_s' P(s'|s,a) ln P(s'|s,a) (eq. 6), in nats; 0 ln 0 = 0, and 0 for an action never tried.
/// O(out-degree of s).
template <class Cell>
[[nodiscard]] double entropy(const TransitionCounts<Cell>& counts, StateId s, ActionId a) {
    const auto total = static_cast<double>(counts.n(s, a));
    if (!(total > 0.0)) return 0.0;
    double sum = 0.0;
    counts.for_each_outcome(s, a, [&](StateId, const Cell& cell) {
        const double p = static_cast<double>(cell.count()) / total;
        if (p > 0.0) sum -= p * std::log(p);
    });
    return sum;
}

}  // namespace sspql
