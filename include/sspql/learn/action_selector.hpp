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
#include <sspql/core/serialization.hpp>

/// \file
/// Selector (concept): chooses an action by its score. A learner hands it the weighted sum of eq. 8 without eps; the
/// selector adds the chance.
///
///     ActionId operator()(std::size_t actions, const Allowed& allowed, const Score& score, Random& random) const
///
/// `allowed.contains(a)` says whether a may be chosen (at least one may, asserted by the learner), `score(a)` is its
/// score. The same random state, scores and mask give the same action. Optional, for expected Sarsa:
///
///     double expectation(std::size_t actions, const Allowed& allowed, const Score& score, const Value& value) const
///
/// is the mean of value(a) over the actions it would choose.

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

template <class S>
using ExpectationExpression =
    decltype(std::declval<const S&>().expectation(std::size_t{}, std::declval<const AnyAllowed&>(),
                                                  std::declval<const AnyScore&>(), std::declval<const AnyScore&>()));

/// The allowed action of the largest score, the least id on ties; no_action if none is allowed.
template <class Allowed, class Score>
[[nodiscard]] ActionId argmax(std::size_t actions, const Allowed& allowed, const Score& score) {
    std::size_t i = 0;
    while (i < actions && !allowed.contains(action_id(i))) ++i;
    if (i == actions) return no_action;
    ActionId best = action_id(i);
    double best_score = score(best);
    for (++i; i < actions; ++i) {
        const ActionId a = action_id(i);
        if (!allowed.contains(a)) continue;
        const double value = score(a);
        // Selections, not jumps: with noise in the scores nobody can predict which is the best.
        const bool better = value > best_score;
        best = better ? a : best;
        best_score = better ? value : best_score;
    }
    return best;
}

/// One of the allowed actions of the largest score, up to `tolerance` of it, each with the same probability: one draw for
/// each equal beyond the first. no_action if none is allowed.
template <class Allowed, class Score>
[[nodiscard]] ActionId random_argmax(std::size_t actions, const Allowed& allowed, const Score& score, Random& random,
                                     double tolerance) {
    ActionId best = no_action;
    double best_score = 0.0;
    std::size_t equals = 0;  // reservoir of one: the k-th equal replaces the choice with probability 1/k
    for (std::size_t i = 0; i < actions; ++i) {
        const ActionId a = action_id(i);
        if (!allowed.contains(a)) continue;
        const double value = score(a);
        const double margin = tolerance > 0.0 ? tolerance * std::fabs(best_score) : 0.0;  // infinite scores are equal too
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

}  // namespace detail

/// Whether S can be called as a Selector.
template <class S>
inline constexpr bool is_selector_v = detail::is_detected_convertible_v<ActionId, detail::SelectExpression, S>;

/// Whether S knows the mean value of the actions it would choose.
template <class S>
inline constexpr bool has_expectation_v = detail::is_detected_convertible_v<double, detail::ExpectationExpression, S>;

/// argmax_a [score(a) + eps_a] with eps_a uniform in [0, noise) (eq. 8 of Kwon, Suh and Lee 2011), one draw for each
/// allowed action in the order of ids. O(|A|).
/// \throws std::invalid_argument for a noise that is not > 0 and finite: without it a robot repeats a blocked action for
/// ever.
class ActionSelector {
public:
    static constexpr const char* type_name = "uniform noise";  ///< in checkpoints

    /// Noise in [0, noise), in the unit of the scores.
    explicit ActionSelector(double noise = 0.01) : noise_(require_positive("noise", noise)) {}

    /// Chooses by eq. 8; no_action if nothing is allowed. Precondition: scores are finite.
    template <class Allowed, class Score>
    [[nodiscard]] ActionId operator()(std::size_t actions, const Allowed& allowed, const Score& score,
                                      Random& random) const {
        Random draws = random;  // a copy can stay in registers
        const ActionId chosen = detail::argmax(actions, allowed, [&](ActionId a) {
            const double value = score(a);
            return value + noise_ * draws.uniform();
        });
        random = draws;
        return chosen;
    }

    /// The mean of value(a) over the actions that it would choose.
    /// The chance that a wins is the integral over its own noise of the product, over the others, of the chance that
    /// theirs stays below: a polynomial between the places where one of them sets in or ends. Exact for up to 10 actions
    /// within `noise` of the best, very close beyond. O(|A|^3) at worst, O(|A|) where one action is clearly best.
    template <class Allowed, class Score, class Value>
    [[nodiscard]] double expectation(std::size_t actions, const Allowed& allowed, const Score& score,
                                     const Value& value) const {
        const ActionId top = detail::argmax(actions, allowed, score);
        const double top_score = score(top);
        const auto contends = [&](ActionId a) { return allowed.contains(a) && top_score - score(a) < noise_; };
        double sum = 0.0;
        double total = 0.0;
        for (std::size_t i = 0; i < actions; ++i) {
            const ActionId a = action_id(i);
            if (!contends(a)) continue;
            const double p = chance_to_win(a, actions, contends, score, (top_score - score(a)) / noise_);
            sum += p * value(a);
            total += p;
        }
        return sum / total;
    }

    /// The upper end of the noise, > 0.
    [[nodiscard]] double noise() const noexcept { return noise_; }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive) {
        archive(noise_);
        require_positive("noise", noise_);
    }

    template <class Contends, class Score>
    [[nodiscard]] double chance_to_win(ActionId a, std::size_t actions, const Contends& contends, const Score& score,
                                       double from) const {
        // Gauss and Legendre's five points on [-1, 1].
        constexpr double points[5] = {-0.906179845938664, -0.538469310105683, 0.0, 0.538469310105683, 0.906179845938664};
        constexpr double weights[5] = {0.236926885056189, 0.478628670499366, 0.568888888888889, 0.478628670499366,
                                       0.236926885056189};
        double integral = 0.0;
        for (double begin = from; begin < 1.0;) {
            double end = 1.0;  // the next place where another's chance to stay below becomes certain
            for (std::size_t i = 0; i < actions; ++i) {
                if (action_id(i) == a || !contends(action_id(i))) continue;
                const double sure = 1.0 + (score(action_id(i)) - score(a)) / noise_;
                if (sure > begin && sure < end) end = sure;
            }
            for (int k = 0; k < 5; ++k) {
                const double u = 0.5 * (begin + end) + 0.5 * (end - begin) * points[k];
                double product = 1.0;
                for (std::size_t i = 0; i < actions; ++i) {
                    if (action_id(i) == a || !contends(action_id(i))) continue;
                    const double below = u + (score(a) - score(action_id(i))) / noise_;
                    product *= below < 0.0 ? 0.0 : (below > 1.0 ? 1.0 : below);
                }
                integral += 0.5 * (end - begin) * weights[k] * product;
            }
            begin = end;
        }
        return integral;
    }

    double noise_;
};

/// With probability epsilon a uniformly random allowed action, else one of the largest score; ties are broken uniformly.
/// O(|A|).
/// \throws std::invalid_argument for an epsilon outside [0, 1].
class EpsilonGreedy {
public:
    static constexpr const char* type_name = "epsilon greedy";  ///< in checkpoints

    /// `epsilon`: how often the choice is random, in [0, 1].
    explicit EpsilonGreedy(double epsilon = 0.1) : epsilon_(require_in("epsilon", epsilon, 0.0, 1.0)) {}

    /// Chooses; no_action if nothing is allowed. One draw for chance, one for each tie.
    template <class Allowed, class Score>
    [[nodiscard]] ActionId operator()(std::size_t actions, const Allowed& allowed, const Score& score,
                                      Random& random) const {
        const bool explore = random.chance(epsilon_);
        return detail::random_argmax(
            actions, allowed, [&](ActionId a) { return explore ? 0.0 : score(a); }, random, 0.0);
    }

    /// The mean of value(a) over the actions that it would choose. O(|A|).
    template <class Allowed, class Score, class Value>
    [[nodiscard]] double expectation(std::size_t actions, const Allowed& allowed, const Score& score,
                                     const Value& value) const {
        const double top = score(detail::argmax(actions, allowed, score));
        double all = 0.0;
        double best = 0.0;
        std::size_t choices = 0;
        std::size_t equals = 0;
        for (std::size_t i = 0; i < actions; ++i) {
            const ActionId a = action_id(i);
            if (!allowed.contains(a)) continue;
            all += value(a);
            ++choices;
            if (score(a) != top) continue;
            best += value(a);
            ++equals;
        }
        return epsilon_ * all / static_cast<double>(choices) + (1.0 - epsilon_) * best / static_cast<double>(equals);
    }

    /// How often the choice is random, in [0, 1].
    [[nodiscard]] double epsilon() const noexcept { return epsilon_; }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive) {
        archive(epsilon_);
        require_in("epsilon", epsilon_, 0.0, 1.0);
    }

    double epsilon_;
};

/// An allowed action with probability proportional to e^{score / temperature}. Scores are taken relative to the largest,
/// so that none overflows. O(|A|).
/// \throws std::invalid_argument for a temperature that is not > 0 and finite.
class Boltzmann {
public:
    static constexpr const char* type_name = "boltzmann";  ///< in checkpoints

    /// `temperature`: differences of score much smaller than it do not matter, much larger ones decide.
    explicit Boltzmann(double temperature = 0.1) : temperature_(require_positive("temperature", temperature)) {}

    /// Chooses; no_action if nothing is allowed. One draw.
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

    /// The mean of value(a) over the actions that it would choose. O(|A|).
    template <class Allowed, class Score, class Value>
    [[nodiscard]] double expectation(std::size_t actions, const Allowed& allowed, const Score& score,
                                     const Value& value) const {
        const double top = score(detail::argmax(actions, allowed, score));
        double sum = 0.0;
        double total = 0.0;
        for (std::size_t i = 0; i < actions; ++i) {
            const ActionId a = action_id(i);
            if (!allowed.contains(a)) continue;
            const double weight = std::exp((score(a) - top) / temperature_);
            sum += weight * value(a);
            total += weight;
        }
        return sum / total;
    }

    /// The temperature, > 0, in the unit of the scores.
    [[nodiscard]] double temperature() const noexcept { return temperature_; }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive) {
        archive(temperature_);
        require_positive("temperature", temperature_);
    }

    double temperature_;
};

}  // namespace sspql
