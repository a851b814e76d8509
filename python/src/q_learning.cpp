// SPDX-License-Identifier: MIT
#include <sspql/learn/q_learning.hpp>

#include "learner_of.hpp"
#include "value_parameters.hpp"

namespace sspql::python {

Kind q_learning() {
    return kind_of<QLearning<>>(
        "QLearning", [](Parameters& list, QLearning<>::Params& params) { list_value_parameters(list, params); });
}

}  // namespace sspql::python
