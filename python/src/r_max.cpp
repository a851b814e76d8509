// SPDX-License-Identifier: MIT
#include <sspql/learn/r_max.hpp>

#include "learner_of.hpp"
#include "value_parameters.hpp"

namespace sspql::python {

Kind r_max() {
    return kind_of<RMax<>>("RMax", [](Parameters& list, RMax<>::Params& params) {
        list_model_parameters(list, params);
        list.add("known_after", params.known_after, "an (s,a) is unknown, and worth initial_q, until tried so often");
        list.add("threshold", params.threshold, "planning stops when no value is further off");
    });
}

}  // namespace sspql::python
