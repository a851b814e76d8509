// SPDX-License-Identifier: MIT
#include <sspql/learn/sspql.hpp>

#include "learner_of.hpp"
#include "value_parameters.hpp"

namespace sspql::python {

Kind sspql_of_the_paper() {
    using Params = Sspql<>::Params;
    return kind_of<Sspql<>>(
        "Sspql",
        [](Parameters& list, Params& params) {
            list_value_parameters(list, params);
            list.add("w_q", params.w_q, "weight of Q");
            list.add("w_ssp", params.w_ssp, "weight of Q_SSP, times ssp_decay; 0 switches the planner off");
            list.add("ssp_decay", params.ssp_decay, "eq. 9, by visits of (s,a) since the goals were set");
            list.add("lambda_", params.cost, "lambda of an edge's cost, weight e^(-lambda P)");
            list.add("path_tolerance", params.path_tolerance, "costs off by no more than this share stay");
            list.add("path_budget", params.path_budget,
                     "edges touched per step for the paths; 0: all at the episode's end");
        },
        {{"with_bonus", Params::with_bonus},
         {"without_bonus", Params::without_bonus},
         {"ssp_only", Params::ssp_only},
         {"q_only", Params::q_only},
         {"constant_weight", Params::constant_weight}});
}

}  // namespace sspql::python
