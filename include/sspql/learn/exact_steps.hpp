// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/learn/exact_values.hpp>
#include <sspql/learn/table_reachability.hpp>
#include <sspql/model/transition_table.hpp>

/// \file
/// How long episodes of a TransitionTable last, exactly, and how often they succeed.

namespace sspql {

/// The expected number of steps until the episode ends under a policy (one action per state), from each state: infinite
/// where it may go on for ever, 0 for states without actions. One sparse linear system.
/// \throws std::invalid_argument for a policy that does not give each state one of its actions.
[[nodiscard]] inline std::vector<double> expected_steps(const TransitionTable& table,
                                                        const std::vector<ActionId>& policy) {
    detail::require_policy(table, policy);
    const std::vector<char> ends = detail::ending_states(table, policy);
    std::vector<double> steps = detail::solve_policy(table, policy, 1.0, ends, [](StateId, ActionId) { return 1.0; });
    for (std::size_t s = 0; s < steps.size(); ++s) {
        if (ends[s] == 0 && table.has_actions(state_id(s))) steps[s] = std::numeric_limits<double>::infinity();
    }
    return steps;
}

/// J*(s): the least expected number of steps until the episode ends with success (TransitionTable::is_success), over
/// all ways of acting that succeed with probability 1; infinite where none does, 0 for states without actions. So
/// hazards are no short cuts: where one cannot be ruled out, as with slips beside it, steps and success cannot both be
/// had, and there is no optimum of this kind. Value iteration with cost 1 a step from 0; `tolerance` is estimated, as
/// that of optimal_values for gamma = 1.
/// \throws std::runtime_error if `max_sweeps` do not do.
[[nodiscard]] inline std::vector<double> least_expected_steps(const TransitionTable& table, double tolerance = 1e-10,
                                                              std::size_t max_sweeps = 100000) {
    require_positive("tolerance", tolerance);
    const detail::SurePairs sure = detail::sure_pairs(
        table, [](StateId, ActionId) { return true; },
        [&](const Outcome& outcome) { return table.is_success(outcome.reward); });
    std::vector<double> steps(table.states(), 0.0);
    for (std::size_t s = 0; s < table.states(); ++s) {
        if (sure.state[s] == 0 && table.has_actions(state_id(s))) steps[s] = std::numeric_limits<double>::infinity();
    }
    // Steps of (s,a), those spent staying in s solved for; infinite if it only stays.
    const auto steps_of = [&](std::size_t s, std::size_t a) {
        double sum = 1.0;
        double leave = 0.0;
        for (const Outcome& outcome : table.outcomes(state_id(s), action_id(a))) {
            if (!outcome.terminal && index(outcome.next) == s) continue;
            leave += outcome.probability;
            if (!outcome.terminal) sum += outcome.probability * steps[index(outcome.next)];
        }
        return leave > 0.0 ? sum / leave : std::numeric_limits<double>::infinity();
    };
    detail::SweepMonitor monitor(1.0, tolerance);
    for (std::size_t sweep = 0; sweep < max_sweeps; ++sweep) {
        double change = 0.0;
        double greatest = 0.0;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const std::size_t s = sweep % 2 == 0 ? i : steps.size() - 1 - i;
            if (sure.state[s] == 0) continue;
            double best = std::numeric_limits<double>::infinity();
            for (std::size_t a = 0; a < table.actions(); ++a) {
                if (sure.pair[s * table.actions() + a] != 0) best = std::min(best, steps_of(s, a));
            }
            change = std::max(change, std::fabs(best - steps[s]));
            greatest = std::max(greatest, best);
            steps[s] = best;
        }
        if (monitor.is_done(change, greatest)) return steps;
    }
    throw std::runtime_error("the least expected steps did not settle in " + std::to_string(max_sweeps) + " sweeps");
}

/// J*: least_expected_steps, averaged over the table's start states; none where success is not certain from one of them
/// or value iteration does not find it.
[[nodiscard]] inline std::optional<double> optimal_steps(const TransitionTable& table) {
    try {
        const double steps = mean_over_starts(table, least_expected_steps(table));
        return std::isfinite(steps) ? std::optional<double>(steps) : std::nullopt;
    } catch (const std::runtime_error&) {
        return std::nullopt;
    }
}

/// The probability that an episode under a policy ends with success (TransitionTable::is_success) within `horizon`
/// steps, over the table's starts. O(horizon x outcomes).
/// \throws std::invalid_argument for a policy that does not give each state one of its actions.
[[nodiscard]] inline double success_probability(const TransitionTable& table, const std::vector<ActionId>& policy,
                                                std::size_t horizon) {
    detail::require_policy(table, policy);
    std::vector<double> now(table.states(), 0.0);
    for (const StateId s : table.starts()) now[index(s)] = 1.0 / static_cast<double>(table.starts().size());
    double success = 0.0;
    for (std::size_t step = 0; step < horizon; ++step) {
        std::vector<double> then(table.states(), 0.0);
        for (std::size_t s = 0; s < table.states(); ++s) {
            if (!(now[s] > 0.0)) continue;
            for (const Outcome& outcome : table.outcomes(state_id(s), policy[s])) {
                const double p = now[s] * outcome.probability;
                if (!outcome.terminal) {
                    then[index(outcome.next)] += p;
                } else if (table.is_success(outcome.reward)) {
                    success += p;
                }
            }
        }
        now.swap(then);
    }
    return success;
}

}  // namespace sspql
