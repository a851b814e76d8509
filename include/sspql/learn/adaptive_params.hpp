// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <sspql/core/errors.hpp>
#include <sspql/core/step_budget.hpp>
#include <sspql/learn/adaptive/change_detector.hpp>
#include <sspql/learn/adaptive/forgetting_model.hpp>
#include <sspql/learn/adaptive/optimism_scale.hpp>
#include <sspql/learn/greedy.hpp>
#include <sspql/learn/schedule.hpp>
#include <sspql/spaces/legal_actions.hpp>

namespace sspql {

/// The types an AdaptiveSspql is made of; derive and rename one to replace it.
struct AdaptivePolicies {
    using Selector = Greedy;                ///< of the actions' values and bonuses: no noise, ties by chance
    using LegalActions = LegalActionTable;  ///< which actions a state has
};

template <class Policies>
class AdaptiveSspql;

/// Parameters of AdaptiveSspql, by name. The defaults are one set for all tasks; docs/adaptive.md says when to touch which.
template <class Policies = AdaptivePolicies>
struct AdaptiveParams {
    /// The learner these are for, which Agent deduces.
    using Learner = AdaptiveSspql<Policies>;

    double gamma = 0.99;             ///< discount, in (0, 1)
    StepBudget budget{40, 3000};     ///< edge touches for backups: earned per step, saved at most
    double threshold = 0.1;          ///< changes of value are passed on if larger than this part of a step's worth
    OptimismParams optimism{};       ///< about what was not tried
    bool bound_by_paths = true;      ///< ... but no more than the shortest known path lets hope for
    double path_budget = 5.0;        ///< edge touches a step for finding these paths, on average
    std::uint64_t slice = 20000;     ///< edge touches a call, at most, for work that comes due all at once
    TrustParams trust{};             ///< in what was counted
    ChangeParams change{};           ///< when an action's outcomes count as changed
    double bonus = 0.1;              ///< exploration bonus for what was seldom tried, as a part of the way that is left
    double bonus_scale = 10.0;       ///< where episodes cost more steps than this the bonus shrinks in proportion
    double retrace = 0.1;            ///< before a goal is known: how much less the way back attracts than the unknown

    Schedule hint_fading = VisitDecay{};  ///< of a trainer's hints, by visits of (s,a) since the hint
    /// How actions are chosen by their scores.
    typename Policies::Selector selector{};
    /// Which actions a state has.
    typename Policies::LegalActions legal_actions{};

    template <class Archive>
    void serialize(Archive& archive) {
        archive(gamma, budget, threshold, optimism, bound_by_paths, path_budget, slice, trust, change, bonus, bonus_scale,
                retrace, hint_fading);
        archive.policy("selector", selector);
        archive.policy("legal actions", legal_actions);
    }

    /// Checks every number. \throws std::invalid_argument naming the first number out of range.
    void validate() const {
        require_in("gamma", gamma, 0.01, 0.999999);
        require_in("threshold", threshold, 1e-12, 1e6);
        require_not_negative("path_budget", path_budget);
        require_not_negative("bonus", bonus);
        require_positive("bonus_scale", bonus_scale);
        require_in("retrace", retrace, 0.0, 1.0);
        if (slice == 0 || slice > StepBudget::most) throw_invalid("slice", "lie between 1 and 10^15", slice);
    }
};

}  // namespace sspql
