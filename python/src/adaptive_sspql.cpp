// SPDX-License-Identifier: MIT
#include <sspql/learn/adaptive_sspql.hpp>

#include "learner_of.hpp"

namespace sspql::python {

Kind adaptive_sspql() {
    using Params = AdaptiveSspql<>::Params;
    return kind_of<AdaptiveSspql<>>("AdaptiveSspql", [](Parameters& list, Params& params) {
        list.add("gamma", params.gamma, "discount, in (0, 1)");
        list.add("budget", params.budget, "edge touches for backups: (earned per step, saved at most)");
        list.add("threshold", params.threshold, "changes of value are passed on above this part of a step's worth");
        auto& optimism = params.optimism;
        list.add("optimism.fraction", optimism.fraction,
                 "an untried action is believed to lead to the goal in this part of what episodes cost,");
        list.add("optimism.least", optimism.least, "... but in no fewer steps than this");
        list.add("optimism.most", optimism.most, "... and no more");
        list.add("optimism.gap", optimism.gap, "seen from another state it is believed to be this much further");
        list.add("optimism.limit", optimism.limit, "the number of steps stays below limit / (1 - gamma)");
        list.add("optimism.saving", optimism.saving,
                 "a state is at most this much nearer to the goal than its shortest known path");
        list.add("bound_by_paths", params.bound_by_paths, "hope for no more than the shortest known path allows");
        list.add("path_budget", params.path_budget, "edge touches a step for finding these paths, on average");
        list.add("slice", params.slice, "edge touches a call, at most, for work that comes due all at once");
        auto& trust = params.trust;
        list.add("trust.cap", trust.cap,
                 "at most so many observations of an (s,a) count, older ones fade; 0: all count");
        list.add("trust.kappa_noise", trust.kappa_noise,
                 "the optimistic pseudo-count of every (s,a), as a multiple of the noise seen");
        list.add("trust.kappa_least", trust.kappa_least, "... and at least this");
        list.add("trust.kappa_few", trust.kappa_few, "... and, once a goal is known, times 1 + this / sqrt(N)");
        list.add("trust.tau", trust.tau, "> 0: an (s,a) not tried for a while is in doubt again");
        auto& change = params.change;
        list.add("change.drift", change.drift, "surprise that is forgiven each time");
        list.add("change.threshold", change.threshold, "the least score that raises an alarm");
        list.add("change.log_offset", change.log_offset, "with many (s,a) the threshold is ln(tried pairs) less this");
        list.add("change.fast", change.fast, "the fast counts, kept after an alarm, forget with this factor a try");
        list.add("change.kept", change.kept, "observations that are left after an alarm");
        list.add("change.least_count", change.least_count, "outcomes of which less is left are dropped");
        list.add("bonus", params.bonus, "exploration bonus for what was seldom tried, as a part of the way left");
        list.add("bonus_scale", params.bonus_scale, "where episodes cost more steps than this the bonus shrinks");
        list.add("retrace", params.retrace, "before a goal is known: how much less the way back attracts");
        list.add("hint_fading", params.hint_fading, "of a trainer's hints, by visits of (s,a) since the hint");
    });
}

}  // namespace sspql::python
