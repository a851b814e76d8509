// SPDX-License-Identifier: MIT
#include <sspql/learn/dyna_q.hpp>

#include "learner_of.hpp"
#include "value_parameters.hpp"

namespace sspql::python {

Kind dyna_q() {
    return kind_of<DynaQ<>>("DynaQ", [](Parameters& list, DynaQ<>::Params& params) {
        list_model_parameters(list, params);
        list.add("planning_steps", params.planning_steps, "planning steps after each real one");
        list.add("replay", params.replay, {"from_counts", "last_outcome"}, "what a planning step replays");
    });
}

}  // namespace sspql::python
