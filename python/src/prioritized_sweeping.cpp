// SPDX-License-Identifier: MIT
#include <sspql/learn/prioritized_sweeping.hpp>

#include "learner_of.hpp"
#include "value_parameters.hpp"

namespace sspql::python {

Kind prioritized_sweeping() {
    using Params = PrioritizedSweeping<>::Params;
    return kind_of<PrioritizedSweeping<>>(
        "PrioritizedSweeping",
        [](Parameters& list, Params& params) {
            list_model_parameters(list, params);
            list.add("planning_steps", params.planning_steps, "backups after each real step, at most");
            list.add("threshold", params.threshold, "smaller changes are not passed on");
        },
        {{"optimistic", Params::optimistic}});
}

}  // namespace sspql::python
