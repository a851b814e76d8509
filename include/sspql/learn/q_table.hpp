// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

#include <Eigen/Core>

#include <sspql/core/assert.hpp>
#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/model/prefetch.hpp>
#include <sspql/spaces/legal_actions.hpp>

namespace sspql {

/// Q(s,a): |S| x |A| values in one growing vector, row = state. `matrix()` shows it as an Eigen row-major map without
/// copying; the map is valid until grow(). Capacity doubles, reserve() is honoured. Ids are asserted, not checked.
/// \throws std::invalid_argument for no actions, or an initial value that is not finite.
class QTable {
public:
    /// |S| x |A|, row = state.
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    /// `states` x `actions` values, all `initial`.
    QTable(std::size_t states, std::size_t actions, double initial = 0.0)
        : actions_(detail::require_id_count("number of actions", actions)),
          initial_(require_finite("initial Q", initial)),
          values_(states * actions, initial) {}

    /// The number of states.
    [[nodiscard]] std::size_t states() const noexcept { return values_.size() / actions_; }
    /// The number of actions.
    [[nodiscard]] std::size_t actions() const noexcept { return actions_; }
    /// What values start at.
    [[nodiscard]] double initial() const noexcept { return initial_; }

    /// Q(s,a), to be changed.
    [[nodiscard]] double& operator()(StateId s, ActionId a) noexcept {
        SSPQL_ASSERT(index(s) < states() && index(a) < actions_, "ids within range");
        return values_[index(s) * actions_ + index(a)];
    }
    /// Q(s,a).
    [[nodiscard]] double operator()(StateId s, ActionId a) const noexcept {
        SSPQL_ASSERT(index(s) < states() && index(a) < actions_, "ids within range");
        return values_[index(s) * actions_ + index(a)];
    }

    /// max_a Q(s,a).
    [[gnu::always_inline, nodiscard]] double max(StateId s) const noexcept {
        const double* row = values_.data() + index(s) * actions_;
        // Grids have four; without a loop that takes half the time. The first of equals wins here as there.
        if (actions_ == 4) return std::max(std::max(row[0], row[1]), std::max(row[2], row[3]));
        double best = row[0];
        for (std::size_t a = 1; a < actions_; ++a) best = std::max(best, row[a]);
        return best;
    }

    /// max_a Q(s,a) over the actions that `allowed.contains(a)`; -infinity if it contains none.
    template <class Allowed>
    [[nodiscard]] double max(StateId s, const Allowed& allowed) const noexcept {
        const double* row = values_.data() + index(s) * actions_;
        double best = -std::numeric_limits<double>::infinity();
        for (std::size_t a = 0; a < actions_; ++a) {
            if (allowed.contains(action_id(a))) best = std::max(best, row[a]);
        }
        return best;
    }

    /// max_a Q(s,a) over the legal actions of s; without masks in the table there is nothing to look up.
    template <class LegalActions>
    [[gnu::always_inline, nodiscard]] double legal_max(StateId s, const LegalActions& legal) const noexcept {
        if constexpr (std::is_same_v<LegalActions, LegalActionTable>) {
            if (legal.actions() == 0) return max(s);
        }
        if constexpr (std::is_same_v<LegalActions, AllActions>) return max(s);
        return max(s, legal.allowed(s));
    }

    /// For somebody who soon reads the row of s: has it fetched into the cache.
    void prefetch(StateId s) const noexcept { detail::prefetch(values_.data() + index(s) * actions_); }

    /// More states; new ones start at the initial value.
    void grow(std::size_t states) {
        if (states * actions_ > values_.size()) values_.resize(states * actions_, initial_);
    }

    /// Room for that many states.
    void reserve(std::size_t states) { values_.reserve(states * actions_); }

    /// Every value back to the initial one.
    void reset() { std::fill(values_.begin(), values_.end(), initial_); }

    /// The values as a matrix, |S| x |A|, valid until grow().
    [[nodiscard]] Eigen::Map<const Matrix> matrix() const {
        return {values_.data(), static_cast<Eigen::Index>(states()), static_cast<Eigen::Index>(actions_)};
    }
    /// The same, to be changed.
    [[nodiscard]] Eigen::Map<Matrix> matrix() {
        return {values_.data(), static_cast<Eigen::Index>(states()), static_cast<Eigen::Index>(actions_)};
    }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive) {
        archive.fixed(values_);
    }

    std::size_t actions_;
    double initial_;
    std::vector<double> values_;
};

}  // namespace sspql
