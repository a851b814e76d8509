// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/model/transition_table.hpp>
#include <sspql/model/transition_table_builder.hpp>

namespace sspql {

/// Settings of the chain. The defaults are those of Fig. 3.
struct ChainParams {
    std::size_t states = 10;   ///< at least 2
    double probability = 0.3;  ///< of an action's success, in (0, 1]
};

/// The chain of Fig. 3 of Kwon, Suh and Lee (2011): from state 0 to the goal, the last state, which ends the episode
/// with reward 1. Action 0 goes one state to the right, action 1 one to the left (from state 0: nowhere); each succeeds
/// with the given probability, else nothing moves: cycles that slow learners down which back up sampled outcomes. At
/// best (states - 1) / probability steps are expected.
/// \throws std::invalid_argument for parameters out of range.
[[nodiscard]] inline TransitionTable chain_table(const ChainParams& params = {}) {
    if (params.states < 2) throw_invalid("number of states", "be at least 2", params.states);
    if (!(params.probability > 0.0 && params.probability <= 1.0)) {
        throw_invalid("probability", "lie in (0, 1]", params.probability);
    }
    const double p = params.probability;
    TransitionTableBuilder builder(params.states, 2);
    for (std::size_t i = 0; i + 1 < params.states; ++i) {
        const StateId s = state_id(i);
        const bool last = i + 2 == params.states;
        builder.add(s, action_id(0), state_id(i + 1), p, last ? 1.0 : 0.0, last);
        if (p < 1.0) builder.add(s, action_id(0), s, 1.0 - p);
        if (i == 0 || p < 1.0) builder.add(s, action_id(1), s, i == 0 ? 1.0 : 1.0 - p);
        if (i > 0) builder.add(s, action_id(1), state_id(i - 1), p);
    }
    builder.start_in({state_id(0)});
    return builder.build();
}

}  // namespace sspql
