// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <sspql/core/assert.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>

namespace sspql {

/// How often each action was taken in each state: 32-bit counts that stop at their largest value. What schedules and the
/// exploration bonus of a learner without a model read. Ids are asserted, not checked.
class VisitCounts {
public:
    /// All counts 0.
    VisitCounts(std::size_t states, std::size_t actions) : actions_(actions), visits_(states * actions, 0) {}

    /// How often a was taken in s; the largest value means so often or more.
    [[nodiscard]] std::uint32_t operator()(StateId s, ActionId a) const noexcept { return visits_[at(s, a)]; }

    /// Once more.
    void add(StateId s, ActionId a) noexcept {
        std::uint32_t& n = visits_[at(s, a)];
        if (n != std::numeric_limits<std::uint32_t>::max()) ++n;
    }

    /// More states, never visited.
    void grow(std::size_t states) {
        if (states * actions_ > visits_.size()) visits_.resize(states * actions_, 0);
    }
    /// Room for that many states.
    void reserve(std::size_t states) { visits_.reserve(states * actions_); }
    /// All counts are 0 again.
    void reset() { std::fill(visits_.begin(), visits_.end(), 0); }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive) {
        archive.fixed(visits_);
    }

    [[nodiscard]] std::size_t at(StateId s, ActionId a) const noexcept {
        SSPQL_ASSERT(index(s) * actions_ + index(a) < visits_.size() && index(a) < actions_, "ids within range");
        return index(s) * actions_ + index(a);
    }

    std::size_t actions_;
    std::vector<std::uint32_t> visits_;
};

}  // namespace sspql
