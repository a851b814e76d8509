// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>

#include <sspql/core/ids.hpp>
#include <sspql/core/random.hpp>

namespace sspql {

/// Selector: an allowed action of the largest score; equals, up to 1e-12 of it, are drawn from uniformly. O(|A|), one
/// draw for each equal beyond the first.
class Greedy {
public:
    static constexpr const char* type_name = "greedy";
    static constexpr double tolerance = 1e-12;

    template <class Allowed, class Score>
    [[nodiscard]] ActionId operator()(std::size_t actions, const Allowed& allowed, const Score& score,
                                      Random& random) const {
        ActionId best = no_action;
        double best_score = 0.0;
        std::size_t equals = 0;  // reservoir of one: the k-th equal replaces the choice with probability 1/k
        for (std::size_t i = 0; i < actions; ++i) {
            const ActionId a = action_id(i);
            if (!allowed.contains(a)) continue;
            const double value = score(a);
            const double margin = tolerance * std::fabs(best_score);
            if (equals == 0 || value > best_score + margin) {
                best = a;
                best_score = value;
                equals = 1;
            } else if (value >= best_score - margin && random.below(++equals) == 0) {
                best = a;
            }
        }
        return best;
    }
};

}  // namespace sspql
