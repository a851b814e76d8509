// SPDX-License-Identifier: MIT
#pragma once

#include "parameters.hpp"

namespace sspql::python {

/// The members of ValueParams.
template <class Params>
void list_value_parameters(Parameters& list, Params& params) {
    list.add("gamma", params.gamma, "discount, in [0, 1]");
    list.add("alpha", params.alpha, "learning rate by visits of (s,a), in [0, 1]");
    list.add("initial_q", params.initial_q, "Q of what was never tried; 1 is optimistic where the goal pays 1");
    list.add("w_exp", params.w_exp, "weight of the exploration bonus");
    list.add("bonus", params.bonus, "eta of the exploration bonus 1 / (N + 1)^eta");
    list.add("hint_fading", params.hint_fading, "of a trainer's hints, by visits of (s,a) since the hint");
    list.add("noise", params.selector, "uniform noise below this is added when an action is chosen");
}

/// Those of ModelParams.
template <class Params>
void list_model_parameters(Parameters& list, Params& params) {
    list_value_parameters(list, params);
    list.add("cap", params.cap, "at most so many observations of an (s,a) count, older ones fade; 0: all count");
    list.add("least_count", params.least_count, "an outcome whose faded count falls below is forgotten");
    list.add("kappa", params.kappa, "how often every (s,a) counts as having led to unknown_value");
    list.add("unknown_value", params.unknown_value, "see kappa");
}

}  // namespace sspql::python
