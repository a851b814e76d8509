// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/random.hpp>
#include <sspql/model/transition_table.hpp>
#include <sspql/model/transition_table_builder.hpp>

namespace sspql {

/// Settings of random_mdp.
struct RandomMdpParams {
    std::size_t states = 20;       ///< the goal included; at least 2
    std::size_t actions = 3;       ///< in every state but the goal
    std::size_t branching = 3;     ///< distinct successors of each (s,a), 1 to states
    double least_reward = 0.0;     ///< of a step that does not reach the goal: uniform in [least, greatest]
    double greatest_reward = 0.0;  ///< its upper end
    double goal_reward = 1.0;      ///< of the step that reaches the goal
};

/// A random table: each (s,a) has `branching` successors with random probabilities (none below 1/(20 branching)). The
/// last state is the goal, which ends the episode. It can be reached from everywhere; episodes start anywhere else. The
/// same settings and seed give the same table on every machine. O(states x actions x branching).
/// \throws std::invalid_argument for settings out of range.
[[nodiscard]] inline TransitionTable random_mdp(const RandomMdpParams& params, std::uint64_t seed) {
    if (params.states < 2) throw_invalid("number of states", "be at least 2", params.states);
    detail::require_id_count("number of actions", params.actions);
    if (params.branching == 0 || params.branching > params.states) {
        throw_invalid("branching", "lie between 1 and " + std::to_string(params.states), params.branching);
    }
    require_finite("least_reward", params.least_reward);
    require_finite("goal_reward", params.goal_reward);
    if (!(params.greatest_reward >= params.least_reward)) {
        throw_invalid("greatest_reward", "be at least the least reward", params.greatest_reward);
    }
    require_finite("greatest_reward", params.greatest_reward);

    Random random(seed, RandomStream::environment);
    const std::size_t goal = params.states - 1;
    // A random tree towards the goal: in this order, each state has one action that may lead to an earlier one.
    std::vector<std::size_t> order(params.states);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = goal; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    std::swap(order[0], order[goal]);

    TransitionTableBuilder builder(params.states, params.actions);
    std::vector<std::size_t> pool(params.states);
    std::iota(pool.begin(), pool.end(), std::size_t{0});
    std::vector<double> weights(params.branching);
    for (std::size_t i = 1; i < params.states; ++i) {
        const std::size_t s = order[i];
        const std::size_t parent = order[random.below(i)];
        const std::size_t way = random.below(params.actions);
        for (std::size_t a = 0; a < params.actions; ++a) {
            for (std::size_t k = 0; k < params.branching; ++k) {
                const std::size_t other = k + random.below(params.states - k);
                std::swap(pool[k], pool[other]);
                weights[k] = random.uniform(0.05, 1.0);
            }
            const auto end = pool.begin() + static_cast<std::ptrdiff_t>(params.branching);
            if (a == way && std::find(pool.begin(), end, parent) == end) {
                std::swap(pool[0], *std::find(end, pool.end(), parent));
            }
            const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
            for (std::size_t k = 0; k < params.branching; ++k) {
                const double reward = random.uniform(params.least_reward, params.greatest_reward);
                const bool is_goal = pool[k] == goal;
                builder.add(state_id(s), action_id(a), state_id(pool[k]), weights[k] / sum,
                            is_goal ? params.goal_reward : reward, is_goal);
            }
        }
    }
    return builder.build();
}

}  // namespace sspql
