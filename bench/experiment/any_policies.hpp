// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>
#include <variant>

#include <sspql/learn/action_selector.hpp>
#include <sspql/learn/q_learning.hpp>
#include <sspql/learn/reward_model.hpp>
#include <sspql/learn/sspql.hpp>
#include <sspql/paths/cost.hpp>

/// \file
/// Policies chosen when a program runs instead of when it is compiled: one template instance serves every `--set`.

namespace sspql::experiment {

/// A Selector that is one of the library's three.
class AnySelector {
public:
    AnySelector() : choice_(ActionSelector{}) {}
    template <class Selector>
    AnySelector(Selector selector) : choice_(std::move(selector)) {}  // NOLINT(google-explicit-constructor)

    template <class Allowed, class Score>
    [[nodiscard]] ActionId operator()(std::size_t actions, const Allowed& allowed, const Score& score,
                                      Random& random) const {
        return std::visit([&](const auto& selector) { return selector(actions, allowed, score, random); }, choice_);
    }

    template <class Allowed, class Score, class Value>
    [[nodiscard]] double expectation(std::size_t actions, const Allowed& allowed, const Score& score,
                                     const Value& value) const {
        return std::visit([&](const auto& selector) { return selector.expectation(actions, allowed, score, value); },
                          choice_);
    }

private:
    std::variant<ActionSelector, EpsilonGreedy, Boltzmann> choice_;
};

/// A CostPolicy that is one of the library's four.
class AnyCost {
public:
    AnyCost() : choice_(RiskWeighted{}) {}
    template <class Cost>
    AnyCost(Cost cost) : choice_(std::move(cost)) {}  // NOLINT(google-explicit-constructor)

    [[nodiscard]] double operator()(double weight, double probability) const {
        return std::visit([&](const auto& cost) { return cost(weight, probability); }, choice_);
    }

private:
    std::variant<RiskWeighted, ExpectedTries, LogRisk, HopCount> choice_;
};

/// A ProbabilityPolicy that is one of the library's two.
class AnyProbability {
public:
    AnyProbability() : choice_(SumOverActions{}) {}
    template <class Probability>
    AnyProbability(Probability probability) : choice_(probability) {}  // NOLINT(google-explicit-constructor)

    template <class Counts, class Successor>
    [[nodiscard]] double operator()(const Counts& counts, StateId s, const Successor& successor) const {
        return std::visit([&](const auto& probability) { return probability(counts, s, successor); }, choice_);
    }

private:
    std::variant<SumOverActions, BestAction> choice_;
};

struct AnyPolicies : ValuePolicies {
    using Selector = AnySelector;
};

struct AnyModelPolicies : ModelPolicies {
    using Selector = AnySelector;
};

struct AnySspqlPolicies : SspqlPolicies {
    using Selector = AnySelector;
    using Cost = AnyCost;
    using Probability = AnyProbability;
};

}  // namespace sspql::experiment
