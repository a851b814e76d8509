// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include <sspql/core/errors.hpp>
#include <sspql/core/serialization.hpp>

namespace sspql {

/// A purse of work, counted in edges touched: a robot's control loop cannot wait for a search over a million states, so
/// planning earns `per_step` touches with every step, saves up to `bank` of them, and stops when they are spent. What one
/// call does is then bounded by the bank plus one indivisible piece of work (a state's edges, for most planners).
///
/// The balance may become negative by that one piece; it is paid back from what is earned later.
class StepBudget {
public:
    /// The most edges that can be earned or saved.
    static constexpr std::uint64_t most = 1'000'000'000'000'000;

    /// Nothing to spend yet. \throws std::invalid_argument if per_step is 0 or the bank is smaller than it.
    StepBudget(std::uint64_t per_step, std::uint64_t bank) : per_step_(per_step), bank_(bank) {
        if (per_step == 0 || per_step > most) throw_invalid("budget per step", "lie between 1 and 10^15", per_step);
        if (bank < per_step || bank > most) {
            throw_invalid("bank of a budget", "lie between the budget per step and 10^15", bank);
        }
    }

    /// One that never runs out.
    [[nodiscard]] static StepBudget unlimited() {
        StepBudget budget(most, most);
        budget.balance_ = std::numeric_limits<std::int64_t>::max() / 2;
        return budget;
    }

    /// A step was made.
    void earn() noexcept {
        balance_ = std::min(balance_ + static_cast<std::int64_t>(per_step_), std::max(balance_, limit()));
    }

    /// `edges` more than a step earns, past the bank if need be.
    void grant(std::uint64_t edges) noexcept {
        balance_ += static_cast<std::int64_t>(std::min<std::uint64_t>(edges, most));
    }

    /// This many edges were touched.
    void spend(std::uint64_t edges) noexcept { balance_ -= static_cast<std::int64_t>(edges); }

    /// Whether nothing is left.
    [[nodiscard]] bool exhausted() const noexcept { return balance_ <= 0; }
    /// Edges left; below 0 where the last piece of work went past the end.
    [[nodiscard]] std::int64_t balance() const noexcept { return balance_; }
    /// Edges that a step earns.
    [[nodiscard]] std::uint64_t per_step() const noexcept { return per_step_; }
    /// Edges that can be saved up.
    [[nodiscard]] std::uint64_t bank() const noexcept { return bank_; }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive) {
        archive(per_step_, bank_, balance_);
        const bool sound = per_step_ != 0 && per_step_ <= bank_ && bank_ <= most &&
                           balance_ <= std::numeric_limits<std::int64_t>::max() / 2 &&
                           balance_ >= std::numeric_limits<std::int64_t>::min() / 2;
        archive.require(sound, "a budget of planning is out of range");
    }

    [[nodiscard]] std::int64_t limit() const noexcept { return static_cast<std::int64_t>(bank_); }

    std::uint64_t per_step_;
    std::uint64_t bank_;
    std::int64_t balance_ = 0;
};

}  // namespace sspql
