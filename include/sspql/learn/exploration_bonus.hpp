// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#include <sspql/core/errors.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/learn/tabulated.hpp>

namespace sspql {

/// Q_EXP(s,a) = 1 / (N(s,a) + 1)^eta (eq. 7 of Kwon, Suh and Lee 2011): 1 for an action never tried, falling towards 0.
/// Tabulated for the first 1024 counts. O(1), no allocation after construction.
/// \throws std::invalid_argument for an eta that is negative or not finite.
class ExplorationBonus {
public:
    /// `eta`: how fast the bonus falls, >= 0.
    ExplorationBonus(double eta = 1.5)  // NOLINT(google-explicit-constructor): a bonus is its exponent
        : eta_(require_not_negative("eta", eta)), table_([this](std::uint64_t n) { return compute(n); }) {}

    /// The bonus after n visits, in (0, 1].
    [[nodiscard]] double operator()(std::uint64_t n) const noexcept {
        return detail::Tabulated::covers(n) ? table_[n] : compute(n);
    }

    /// The exponent, >= 0.
    [[nodiscard]] double eta() const noexcept { return eta_; }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive) {
        archive(eta_);
        if constexpr (Archive::loading) *this = ExplorationBonus(eta_);
    }

    [[nodiscard]] double compute(std::uint64_t n) const noexcept {
        return n == 0 ? 1.0 : std::pow(static_cast<double>(n) + 1.0, -eta_);
    }

    double eta_;
    detail::Tabulated table_;
};

}  // namespace sspql
