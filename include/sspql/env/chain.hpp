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
    std::size_t actions = 2;   ///< at least 1, all alike
    double probability = 0.3;  ///< of a step to the right, in (0, 1]
};

/// The chain of Fig. 3 of Kwon, Suh and Lee (2011): from state 0 to the goal, the last state, which ends the episode
/// with reward 1. Every action goes one state to the right with the given probability, else it stays: cycles that sampled
/// planning replays. The expected number of steps is (states - 1) / probability, whatever the agent does.
/// \throws std::invalid_argument for parameters out of range.
[[nodiscard]] inline TransitionTable chain_table(const ChainParams& params = {}) {
    if (params.states < 2) throw_invalid("number of states", "be at least 2", params.states);
    if (!(params.probability > 0.0 && params.probability <= 1.0)) {
        throw_invalid("probability", "lie in (0, 1]", params.probability);
    }
    TransitionTableBuilder builder(params.states, params.actions);
    for (std::size_t i = 0; i + 1 < params.states; ++i) {
        const bool last = i + 2 == params.states;
        for (std::size_t a = 0; a < params.actions; ++a) {
            builder.add(state_id(i), action_id(a), state_id(i + 1), params.probability, last ? 1.0 : 0.0, last);
            if (params.probability < 1.0) {
                builder.add(state_id(i), action_id(a), state_id(i), 1.0 - params.probability);
            }
        }
    }
    builder.start_in({state_id(0)});
    return builder.build();
}

}  // namespace sspql
