// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <sspql/core/errors.hpp>
#include <sspql/core/serialization.hpp>

/// \file
/// Cost policies: the expected cost EC(s,s') of an edge, from its mean observed weight and P(s'|s).
///
/// CostPolicy (concept): `double operator()(double weight, double probability) const`; weight lies in [1e-30, 1e30],
/// probability in (0, |A|] (eq. 3 sums over actions). The answer must be finite and >= 0; searches raise costs below
/// 1e-30 of the largest to that, so that no cycle is free.

namespace sspql {

/// EC = weight e^{-lambda P} (eq. 2 of Kwon, Suh and Lee 2011): sure edges are cheap, by at most e^{-lambda |A|}. The
/// default, lambda = 2.
///
/// Deviation: Algorithm 1 line 7 prints H(s,s') (s,s'); read literally a certain edge would cost nothing. Eq. 2 holds.
/// Known limit: the cost is bounded by the weight, so an edge that became impassable is never dropped from the paths.
/// \throws std::invalid_argument for a lambda that is negative or not finite.
class RiskWeighted {
public:
    static constexpr const char* type_name = "risk weighted";  ///< in checkpoints

    /// `lambda`: how much sureness is worth; 0 leaves the weight.
    explicit RiskWeighted(double lambda = 2.0) : lambda_(require_not_negative("lambda", lambda)) {}

    /// weight e^(-lambda P), in (0, weight].
    [[nodiscard]] double operator()(double weight, double probability) const noexcept {
        return weight * std::exp(-lambda_ * probability);
    }

    /// lambda, >= 0.
    [[nodiscard]] double lambda() const noexcept { return lambda_; }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive) {
        archive(lambda_);
        require_not_negative("lambda", lambda_);
    }

    double lambda_;
};

/// EC = weight / P: the expected weight of trying until it works. P counts up to 1; use it with BestAction.
struct ExpectedTries {
    static constexpr const char* type_name = "expected tries";  ///< in checkpoints

    /// weight / min(P, 1), at least the weight.
    [[nodiscard]] double operator()(double weight, double probability) const noexcept {
        return weight / std::min(probability, 1.0);
    }
};

/// EC = weight - lambda ln P, P counting up to 1: with a small weight the likeliest path is the shortest.
/// \throws std::invalid_argument for a lambda that is negative or not finite.
class LogRisk {
public:
    static constexpr const char* type_name = "log risk";  ///< in checkpoints

    /// `lambda`: what a factor e of the probability costs.
    explicit LogRisk(double lambda = 1.0) : lambda_(require_not_negative("lambda", lambda)) {}

    /// weight - lambda ln min(P, 1), at least the weight.
    [[nodiscard]] double operator()(double weight, double probability) const noexcept {
        return weight - lambda_ * std::log(std::min(probability, 1.0));
    }

    /// lambda, >= 0.
    [[nodiscard]] double lambda() const noexcept { return lambda_; }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive) {
        archive(lambda_);
        require_not_negative("lambda", lambda_);
    }

    double lambda_;
};

/// EC = 1: the fewest transitions, likely or not.
struct HopCount {
    static constexpr const char* type_name = "hop count";  ///< in checkpoints

    /// EC = 1, whatever the edge.
    [[nodiscard]] double operator()(double /*weight*/, double /*probability*/) const noexcept { return 1.0; }
};

}  // namespace sspql
