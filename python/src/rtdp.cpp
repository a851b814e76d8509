// SPDX-License-Identifier: MIT
#include <sspql/learn/rtdp.hpp>

#include "learner_of.hpp"
#include "value_parameters.hpp"

namespace sspql::python {

Kind rtdp() {
    return kind_of<Rtdp<>>("Rtdp",
                           [](Parameters& list, Rtdp<>::Params& params) { list_model_parameters(list, params); });
}

}  // namespace sspql::python
