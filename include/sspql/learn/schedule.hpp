// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <variant>

#include <sspql/core/errors.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/learn/tabulated.hpp>

namespace sspql {

/// Always the same value, in [0, inf).
struct Constant {
    double value = 1.0;  ///< the factor
};

/// min(1, N^-p), and 1 for N <= 1: the paper's [N(s,a)]^-t (eq. 9) with t a fixed exponent p >= 0.
///
/// Deviation: the print calls t time. Read like that the term dies at the second visit; the constant reading (p = 0)
/// keeps repeating an action that stopped working for ever.
struct VisitDecay {
    double p = 2.0;  ///< the exponent; 0 is constant
};

/// floor + (start - floor) e^{-rate N}, with start >= floor >= 0 and rate >= 0.
struct ExponentialDecay {
    double start = 1.0;  ///< before the first visit
    double rate = 0.01;  ///< a visit
    double floor = 0.0;  ///< what is approached
};

/// A factor that depends on how often (s,a) was visited: a learning rate, or w_SSP of eq. 9. Any of the three rules
/// above converts to it, and so does a number (Constant). Tabulated for the first 1024 counts. O(1), no allocation after
/// construction.
///
/// \throws std::invalid_argument for parameters outside the rule's range.
class Schedule {
public:
    /// One of the three rules.
    using Rule = std::variant<Constant, VisitDecay, ExponentialDecay>;

    /// A number is a Constant.
    Schedule(double constant) : Schedule(Rule(Constant{constant})) {}  // NOLINT(google-explicit-constructor)
    /// The same factor always.
    Schedule(Constant rule) : Schedule(Rule(rule)) {}                  // NOLINT(google-explicit-constructor)
    /// A power of the visits.
    Schedule(VisitDecay rule) : Schedule(Rule(rule)) {}                // NOLINT(google-explicit-constructor)
    /// An exponential of the visits.
    Schedule(ExponentialDecay rule) : Schedule(Rule(rule)) {}          // NOLINT(google-explicit-constructor)

    /// Whichever rule it is.
    explicit Schedule(const Rule& rule)
        : rule_(checked(rule)), table_([this](std::uint64_t n) { return compute(n); }) {}

    /// The factor after n visits.
    [[nodiscard]] double operator()(std::uint64_t n) const noexcept {
        return detail::Tabulated::covers(n) ? table_[n] : compute(n);
    }

    /// The rule it was made from.
    [[nodiscard]] const Rule& rule() const noexcept { return rule_; }

    /// Whether the factor is the same after any number of visits.
    [[nodiscard]] bool constant() const noexcept { return std::holds_alternative<Constant>(rule_); }

    /// The largest value, that of no visits: no rule grows.
    [[nodiscard]] double greatest() const noexcept { return table_[0]; }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive) {
        auto kind = static_cast<std::uint8_t>(rule_.index());
        archive(kind);
        archive.require(kind < std::variant_size_v<Rule>, "there is no such schedule");
        if constexpr (Archive::loading) {
            rule_ = kind == 0 ? Rule(Constant{}) : kind == 1 ? Rule(VisitDecay{}) : Rule(ExponentialDecay{});
        }
        if (auto* constant = std::get_if<Constant>(&rule_)) archive(constant->value);
        if (auto* decay = std::get_if<VisitDecay>(&rule_)) archive(decay->p);
        if (auto* decay = std::get_if<ExponentialDecay>(&rule_)) archive(decay->start, decay->rate, decay->floor);
        if constexpr (Archive::loading) *this = Schedule(rule_);
    }

    static const Rule& checked(const Rule& rule) {
        std::visit([](const auto& r) { check(r); }, rule);
        return rule;
    }
    static void check(const Constant& rule) { require_not_negative("constant of a schedule", rule.value); }
    static void check(const VisitDecay& rule) { require_not_negative("exponent p of a visit decay", rule.p); }
    static void check(const ExponentialDecay& rule) {
        require_not_negative("floor of an exponential decay", rule.floor);
        require_not_negative("rate of an exponential decay", rule.rate);
        if (!(std::isfinite(rule.start) && rule.start >= rule.floor)) {
            throw_invalid("start of an exponential decay", "be finite and not below its floor", rule.start);
        }
    }

    [[nodiscard]] double compute(std::uint64_t n) const noexcept {
        const auto visits = static_cast<double>(n);
        if (const auto* decay = std::get_if<VisitDecay>(&rule_)) return n <= 1 ? 1.0 : std::pow(visits, -decay->p);
        if (const auto* decay = std::get_if<ExponentialDecay>(&rule_)) {
            return decay->floor + (decay->start - decay->floor) * std::exp(-decay->rate * visits);
        }
        return std::get_if<Constant>(&rule_)->value;
    }

    Rule rule_;
    detail::Tabulated table_;
};

}  // namespace sspql
