// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <sspql/core/errors.hpp>
#include <sspql/core/step_budget.hpp>
#include <sspql/learn/change_detector.hpp>
#include <sspql/learn/greedy.hpp>
#include <sspql/learn/optimism_scale.hpp>
#include <sspql/learn/schedule.hpp>
#include <sspql/spaces/legal_actions.hpp>

namespace sspql {

/// The types an AdaptiveSspql is made of; derive and rename one to replace it.
struct AdaptivePolicies {
    using Selector = Greedy;
    using LegalActions = LegalActionTable;
};

template <class Policies>
class AdaptiveSspql;

/// Parameters of AdaptiveSspql, by name. The defaults are one set for all tasks; docs/adaptive.md says when to touch which.
template <class Policies = AdaptivePolicies>
struct AdaptiveParams {
    using Learner = AdaptiveSspql<Policies>;

    double gamma = 0.99;                 ///< discount, in (0, 1)
    StepBudget budget{60, 3000};         ///< edge touches for planning: earned per step, saved at most
    double threshold = 0.1;              ///< changes of value are passed on if larger than this part of a step's worth
    OptimismParams optimism{};           ///< about what was not tried
    bool bound_by_paths = true;          ///< ... but no more than the shortest known path lets hope for
    double path_budget = 5.0;            ///< edge touches a step for finding these paths
    ChangeParams change{};               ///< when outcomes count as changed
    double cap = 50.0;                   ///< at most so many observations of an (s,a) count; 0: all
    double kappa_noise = 0.4;            ///< optimistic pseudo-count of every (s,a), as a multiple of the noise seen
    double kappa_least = 0.01;           ///< ... and at least this
    double bonus = 0.1;                  ///< exploration bonus for what was seldom tried, as a part of what is left to pay
    double bonus_scale = 10.0;           ///< where episodes cost more steps than this the bonus shrinks in proportion
    double tau = 0.0;                    ///< > 0: what was not tried for tau times the number of (s,a) steps is in doubt again
    std::uint64_t slice = 20000;         ///< edge touches a call for work that came due all at once

    Schedule hint_fading = VisitDecay{};  ///< of a trainer's hints, by visits of (s,a) since the hint
    typename Policies::Selector selector{};
    typename Policies::LegalActions legal_actions{};

    /// \throws std::invalid_argument naming the first number out of range.
    void validate() const {
        require_in("gamma", gamma, 0.01, 0.999999);
        require_in("threshold", threshold, 1e-12, 1e6);
        require_not_negative("path_budget", path_budget);
        if (cap != 0.0) require_in("cap", cap, 1.0, 1e9);
        require_not_negative("kappa_noise", kappa_noise);
        require_not_negative("kappa_least", kappa_least);
        require_not_negative("bonus", bonus);
        require_positive("bonus_scale", bonus_scale);
        require_not_negative("tau", tau);
        if (slice == 0) throw_invalid("slice", "be at least 1", slice);
    }
};

}  // namespace sspql
