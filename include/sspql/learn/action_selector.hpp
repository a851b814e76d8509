// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <sspql/core/concepts.hpp>
#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/random.hpp>

/// \file
/// Selector (concept): chooses an action by its score. A learner hands it the weighted sum of eq. 8 without eps; the
/// selector adds the chance.
///
///     ActionId operator()(std::size_t actions, const Allowed& allowed, const Score& score, Random& random) const
///
/// `allowed.contains(a)` says whether a may be chosen (at least one may, asserted by the learner), `score(a)` is its
/// score. The same random state, scores and mask give the same action.

namespace sspql {

namespace detail {

struct AnyAllowed {
    [[nodiscard]] bool contains(ActionId) const { return true; }
};
struct AnyScore {
    [[nodiscard]] double operator()(ActionId) const { return 0.0; }
};

template <class S>
using SelectExpression = decltype(std::declval<const S&>()(std::size_t{}, std::declval<const AnyAllowed&>(),
                                                           std::declval<const AnyScore&>(), std::declval<Random&>()));

/// The allowed action of the largest score, the least id on ties; no_action if none is allowed.
template <class Allowed, class Score>
[[nodiscard]] ActionId argmax(std::size_t actions, const Allowed& allowed, const Score& score) {
    ActionId best = no_action;
    double best_score = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < actions; ++i) {
        const ActionId a = action_id(i);
        if (!allowed.contains(a)) continue;
        const double value = score(a);
        if (best == no_action || value > best_score) {
            best = a;
            best_score = value;
        }
    }
    return best;
}

}  // namespace detail

/// Whether S can be called as a Selector.
template <class S>
inline constexpr bool is_selector_v = detail::is_detected_convertible_v<ActionId, detail::SelectExpression, S>;

/// argmax_a [score(a) + eps_a] with eps_a uniform in [0, noise) (eq. 8 of Kwon, Suh and Lee 2011), one draw for each
/// allowed action in the order of ids. O(|A|).
/// \throws std::invalid_argument for a noise that is not > 0 and finite: without it a robot repeats a blocked action for
/// ever.
class ActionSelector {
public:
    explicit ActionSelector(double noise = 0.01) : noise_(require_positive("noise", noise)) {}

    template <class Allowed, class Score>
    [[nodiscard]] ActionId operator()(std::size_t actions, const Allowed& allowed, const Score& score,
                                      Random& random) const {
        return detail::argmax(actions, allowed, [&](ActionId a) {
            const double value = score(a);
            return value + noise_ * random.uniform();
        });
    }

    [[nodiscard]] double noise() const noexcept { return noise_; }

private:
    double noise_;
};

/// With probability epsilon a uniformly random allowed action, else one of the largest score; ties are broken uniformly.
/// O(|A|).
/// \throws std::invalid_argument for an epsilon outside [0, 1].
class EpsilonGreedy {
public:
    explicit EpsilonGreedy(double epsilon = 0.1) : epsilon_(require_in("epsilon", epsilon, 0.0, 1.0)) {}

    template <class Allowed, class Score>
    [[nodiscard]] ActionId operator()(std::size_t actions, const Allowed& allowed, const Score& score,
                                      Random& random) const {
        const bool explore = random.chance(epsilon_);
        ActionId best = no_action;
        double best_score = 0.0;
        std::size_t equals = 0;  // reservoir of one: the k-th equal replaces the choice with probability 1/k
        for (std::size_t i = 0; i < actions; ++i) {
            const ActionId a = action_id(i);
            if (!allowed.contains(a)) continue;
            const double value = explore ? 0.0 : score(a);
            if (equals == 0 || value > best_score) {
                best = a;
                best_score = value;
                equals = 1;
            } else if (value == best_score && random.below(++equals) == 0) {
                best = a;
            }
        }
        return best;
    }

    [[nodiscard]] double epsilon() const noexcept { return epsilon_; }

private:
    double epsilon_;
};

/// An allowed action with probability proportional to e^{score / temperature}. Scores are taken relative to the largest,
/// so that none overflows. O(|A|).
/// \throws std::invalid_argument for a temperature that is not > 0 and finite.
class Boltzmann {
public:
    explicit Boltzmann(double temperature = 0.1) : temperature_(require_positive("temperature", temperature)) {}

    template <class Allowed, class Score>
    [[nodiscard]] ActionId operator()(std::size_t actions, const Allowed& allowed, const Score& score,
                                      Random& random) const {
        const ActionId top = detail::argmax(actions, allowed, score);
        if (top == no_action) return top;
        const double top_score = score(top);
        double sum = 0.0;
        const auto weight = [&](ActionId a) { return std::exp((score(a) - top_score) / temperature_); };
        for (std::size_t i = 0; i < actions; ++i) {
            if (allowed.contains(action_id(i))) sum += weight(action_id(i));
        }
        double left = random.uniform() * sum;
        ActionId chosen = top;
        for (std::size_t i = 0; i < actions; ++i) {
            if (!allowed.contains(action_id(i))) continue;
            chosen = action_id(i);
            left -= weight(chosen);
            if (left < 0.0) break;
        }
        return chosen;
    }

    [[nodiscard]] double temperature() const noexcept { return temperature_; }

private:
    double temperature_;
};

}  // namespace sspql
