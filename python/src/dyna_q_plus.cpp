// SPDX-License-Identifier: MIT
#include <sspql/learn/dyna_q_plus.hpp>

#include "learner_of.hpp"
#include "value_parameters.hpp"

namespace sspql::python {

Kind dyna_q_plus() {
    return kind_of<DynaQPlus<>>("DynaQPlus", [](Parameters& list, DynaQPlus<>::Params& params) {
        list_value_parameters(list, params);
        list.add("planning_steps", params.planning_steps, "planning steps after each real one");
        list.add("time_bonus", params.time_bonus,
                 "reward for what was not tried for long: this times sqrt(steps since)");
    });
}

}  // namespace sspql::python
