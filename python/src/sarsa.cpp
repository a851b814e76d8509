// SPDX-License-Identifier: MIT
#include <sspql/learn/sarsa.hpp>

#include "learner_of.hpp"
#include "value_parameters.hpp"

namespace sspql::python {

Kind sarsa() {
    return kind_of<Sarsa<>>("Sarsa", [](Parameters& list, Sarsa<>::Params& params) {
        list_value_parameters(list, params);
        list.add("expected", params.expected, "expected Sarsa: the mean over the next actions, not the one chosen");
    });
}

}  // namespace sspql::python
