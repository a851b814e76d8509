// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <sspql/core/ids.hpp>
#include <sspql/core/random.hpp>
#include <sspql/learn/action_selector.hpp>

namespace sspql {

/// Selector: an allowed action of the largest score; equals, up to 1e-12 of it, are drawn from uniformly. O(|A|), one
/// draw for each equal beyond the first.
class Greedy {
public:
    static constexpr const char* type_name = "greedy";  ///< in checkpoints
    /// Scores that differ by no more than this share of the largest count as equal.
    static constexpr double tolerance = 1e-12;

    /// Chooses; no_action if nothing is allowed.
    template <class Allowed, class Score>
    [[nodiscard]] ActionId operator()(std::size_t actions, const Allowed& allowed, const Score& score,
                                      Random& random) const {
        return detail::random_argmax(actions, allowed, score, random, tolerance);
    }
};

}  // namespace sspql
