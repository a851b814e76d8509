// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/learn/adaptive/optimism_scale.hpp>
#include <sspql/paths/shortest_paths.hpp>

namespace sspql {

/// Goals that were told (Learner::set_goals) instead of discovered, and what reaching each is worth on the scale of
/// values: a goal's offset is the way that is still left there, in steps. Look-ups O(1); memory 8 bytes a state up to the
/// largest goal's id.
class ToldGoals {
public:
    /// Whether no goals were told.
    [[nodiscard]] bool empty() const noexcept { return goals_.empty(); }
    /// The goals, as told.
    [[nodiscard]] const std::vector<Goal>& goals() const noexcept { return goals_; }

    /// These hold from now on, worth what the scale says; none is fine. O(goals).
    void set(const std::vector<Goal>& goals, const OptimismScale& scale) {
        goals_ = goals;
        worth_.clear();
        for (const Goal& goal : goals_) {
            if (index(goal.state) >= worth_.size()) worth_.resize(index(goal.state) + 1, none);
        }
        renew(scale);
    }

    /// Worths anew: the scale has changed. O(goals).
    void renew(const OptimismScale& scale) {
        for (const Goal& goal : goals_) worth_[index(goal.state)] = none;
        for (const Goal& goal : goals_) {
            double& worth = worth_[index(goal.state)];
            const double here = scale.at_cost(goal.offset);
            if (!(worth >= here)) worth = here;  // told twice: the better one
        }
    }

    /// Whether s is one of them.
    [[nodiscard]] bool contains(StateId s) const noexcept {
        return index(s) < worth_.size() && worth_[index(s)] == worth_[index(s)];
    }

    /// What reaching s is worth; s is one of them.
    [[nodiscard]] double worth(StateId s) const noexcept { return worth_[index(s)]; }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive, std::size_t states) {
        archive(goals_, worth_);
        if constexpr (Archive::loading) {
            detail::require_goals(goals_, states);
            for (const Goal& goal : goals_) archive.require(contains(goal.state), "a goal has no worth");
        }
    }

    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    std::vector<Goal> goals_;
    std::vector<double> worth_;  // by state; NaN: no goal
};

}  // namespace sspql
