// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/learn/table_reachability.hpp>
#include <sspql/model/transition_table.hpp>

/// \file
/// Exact values of a TransitionTable: what a learner could reach at best. Values are one number per state, 0 for states
/// without actions. A policy here is one action per state, `no_action` for states without actions.

namespace sspql {

/// sum over the outcomes of p (reward + gamma V(next)), V = 0 after a terminal outcome. `values`: one per state.
template <class Values>
[[nodiscard]] double action_value(const TransitionTable& table, const Values& values, double gamma, StateId s,
                                  ActionId a) {
    double sum = 0.0;
    for (const Outcome& outcome : table.outcomes(s, a)) {
        const double future = outcome.terminal ? 0.0 : gamma * values[index(outcome.next)];
        sum += outcome.probability * (outcome.reward + future);
    }
    return sum;
}

/// The mean of one number per state over the table's start states.
template <class Values>
[[nodiscard]] double mean_over_starts(const TransitionTable& table, const Values& values) {
    double sum = 0.0;
    for (const StateId s : table.starts()) sum += values[index(s)];
    return sum / static_cast<double>(table.starts().size());
}

namespace detail {

/// Decides when value iteration may stop, from the greatest change of each sweep. gamma < 1: when the contraction
/// bounds the error, gamma / (1 - gamma) change <= tolerance. gamma = 1, where nothing contracts a priori: the same
/// with the greatest ratio of the last changes in place of gamma, an estimate. Either: when changes drown in rounding.
class SweepMonitor {
public:
    SweepMonitor(double gamma, double tolerance) : gamma_(gamma), tolerance_(tolerance) {}

    /// `greatest`: the greatest value there is, without sign.
    [[nodiscard]] bool is_done(double change, double greatest) {
        ratios_[sweeps_++ % ratios_.size()] = previous_ > 0.0 ? change / previous_ : 1.0;
        previous_ = change;
        if (change <= 4.0 * std::numeric_limits<double>::epsilon() * greatest) return true;
        double rate = gamma_;
        if (gamma_ >= 1.0) {
            if (sweeps_ < ratios_.size()) return false;
            rate = *std::max_element(ratios_.begin(), ratios_.end());
        }
        return rate < 1.0 && change * rate <= tolerance_ * (1.0 - rate);
    }

private:
    double gamma_;
    double tolerance_;
    double previous_ = 0.0;
    std::size_t sweeps_ = 0;
    std::array<double, 8> ratios_{};
};

/// action_value with V(s) itself solved for where the action may stay in s (and may also leave): cycles of one state,
/// such as walls and slips, then cost no sweeps.
inline double solved_action_value(const TransitionTable& table, const std::vector<double>& values, double gamma,
                                  StateId s, ActionId a) {
    double sum = 0.0;
    double stay = 0.0;
    double leave = 0.0;
    for (const Outcome& outcome : table.outcomes(s, a)) {
        sum += outcome.probability * outcome.reward;
        if (!outcome.terminal && outcome.next == s) {
            stay += outcome.probability;
        } else {
            leave += outcome.probability;
            if (!outcome.terminal) sum += outcome.probability * gamma * values[index(outcome.next)];
        }
    }
    const double rest = leave + (1.0 - gamma) * stay;
    return rest > 0.0 ? sum / rest : sum + values[index(s)];
}

/// Gauss-Seidel value iteration from V = 0 over the states with `uses_state[s]`, every second sweep backwards.
inline std::vector<double> value_iteration(const TransitionTable& table, const std::vector<char>& uses_state,
                                           double gamma, double tolerance, std::size_t max_sweeps) {
    std::vector<double> values(table.states(), 0.0);
    SweepMonitor monitor(gamma, tolerance);
    for (std::size_t sweep = 0; sweep < max_sweeps; ++sweep) {
        double change = 0.0;
        double greatest = 0.0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::size_t s = sweep % 2 == 0 ? i : values.size() - 1 - i;
            if (uses_state[s] == 0) continue;
            double best = -std::numeric_limits<double>::infinity();
            for (std::size_t a = 0; a < table.actions(); ++a) {
                if (!table.allowed(state_id(s)).contains(action_id(a))) continue;
                best = std::max(best, solved_action_value(table, values, gamma, state_id(s), action_id(a)));
            }
            if (!table.has_actions(state_id(s))) continue;
            change = std::max(change, std::fabs(best - values[s]));
            greatest = std::max(greatest, std::fabs(best));
            values[s] = best;
        }
        if (monitor.is_done(change, greatest)) return values;
    }
    throw std::runtime_error("value iteration did not settle in " + std::to_string(max_sweeps) + " sweeps, gamma " +
                             to_text(gamma));
}

/// Throws std::invalid_argument unless `policy` gives each state one of its actions.
inline void require_policy(const TransitionTable& table, const std::vector<ActionId>& policy) {
    if (policy.size() != table.states()) {
        throw_invalid("size of the policy", "be the number of states " + std::to_string(table.states()), policy.size());
    }
    for (std::size_t s = 0; s < policy.size(); ++s) {
        if (!table.has_actions(state_id(s)) || table.allowed(state_id(s)).contains(policy[s])) continue;
        throw_invalid("policy", "give state " + std::to_string(s) + " one of its actions", index(policy[s]));
    }
}

/// The states from which this policy ends the episode with probability 1.
inline std::vector<char> ending_states(const TransitionTable& table, const std::vector<ActionId>& policy) {
    return sure_pairs(
               table, [&](StateId s, ActionId a) { return policy[index(s)] == a; }, [](const Outcome&) { return true; })
        .state;
}

/// Solves x(s) = gain(s) + gamma sum p x(next) under the policy, for the states with `solve[s]`; 0 elsewhere.
template <class Gain>
std::vector<double> solve_policy(const TransitionTable& table, const std::vector<ActionId>& policy, double gamma,
                                 const std::vector<char>& solve, const Gain& gain) {
    const auto n = static_cast<Eigen::Index>(table.states());
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
    for (std::size_t s = 0; s < table.states(); ++s) {
        const auto row = static_cast<int>(s);
        entries.emplace_back(row, row, 1.0);
        if (solve[s] == 0) continue;
        right[row] = gain(state_id(s), policy[s]);
        for (const Outcome& outcome : table.outcomes(state_id(s), policy[s])) {
            if (outcome.terminal) continue;
            entries.emplace_back(row, static_cast<int>(index(outcome.next)), -gamma * outcome.probability);
        }
    }
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseLU<Eigen::SparseMatrix<double>> solver;
    solver.compute(matrix);
    if (solver.info() != Eigen::Success) throw std::runtime_error("the policy's equations could not be solved");
    const Eigen::VectorXd x = solver.solve(right);
    return {x.data(), x.data() + x.size()};
}

}  // namespace detail

/// V*(s) = max_a sum p (reward + gamma V*(s')), by Gauss-Seidel value iteration from 0. gamma in [0, 1].
///
/// gamma < 1: every value is within `tolerance` of V* (up to rounding), by the contraction bound. gamma = 1: for tables
/// whose optimum is finite, as where every episode ends or going on for ever costs; the tolerance is then estimated
/// from the speed of convergence. O(outcomes) per sweep.
/// \throws std::invalid_argument for gamma or tolerance (> 0) out of range; std::runtime_error if `max_sweeps` do not
/// do, as where the values grow without bound.
[[nodiscard]] inline std::vector<double> optimal_values(const TransitionTable& table, double gamma,
                                                        double tolerance = 1e-10, std::size_t max_sweeps = 100000) {
    require_in("gamma", gamma, 0.0, 1.0);
    require_positive("tolerance", tolerance);
    return detail::value_iteration(table, std::vector<char>(table.states(), 1), gamma, tolerance, max_sweeps);
}

/// The action of the greatest action_value in each state, the least id on ties. With gamma = 1 the best values may be
/// shared by an action that never gets anywhere: use gamma < 1 for a policy to act on.
/// \throws std::invalid_argument for a number of values other than the states'.
[[nodiscard]] inline std::vector<ActionId> greedy_policy(const TransitionTable& table,
                                                         const std::vector<double>& values, double gamma) {
    if (values.size() != table.states()) {
        throw_invalid("number of values", "be the number of states " + std::to_string(table.states()), values.size());
    }
    std::vector<ActionId> policy(table.states(), no_action);
    for (std::size_t s = 0; s < table.states(); ++s) {
        double best = 0.0;
        for (std::size_t a = 0; a < table.actions(); ++a) {
            if (!table.allowed(state_id(s)).contains(action_id(a))) continue;
            const double value = action_value(table, values, gamma, state_id(s), action_id(a));
            if (policy[s] != no_action && !(value > best)) continue;
            best = value;
            policy[s] = action_id(a);
        }
    }
    return policy;
}

/// V of a policy: the sparse linear system V = r + gamma P V, solved by LU. gamma in [0, 1].
/// \throws std::invalid_argument for gamma out of range, or a policy that does not give each state one of its actions;
/// std::runtime_error for gamma = 1 and a policy that, from some state, may go on for ever.
[[nodiscard]] inline std::vector<double> policy_values(const TransitionTable& table,
                                                       const std::vector<ActionId>& policy, double gamma) {
    require_in("gamma", gamma, 0.0, 1.0);
    detail::require_policy(table, policy);
    std::vector<char> solve(table.states(), 1);
    if (gamma >= 1.0) solve = detail::ending_states(table, policy);
    for (std::size_t s = 0; s < table.states(); ++s) {
        if (solve[s] != 0 || !table.has_actions(state_id(s))) continue;
        throw std::runtime_error("with gamma 1 the policy has no value in state " + std::to_string(s) +
                                 ": it may go on for ever");
    }
    for (std::size_t s = 0; s < table.states(); ++s) solve[s] = table.has_actions(state_id(s)) ? 1 : 0;
    const std::vector<double> zero(table.states(), 0.0);
    return detail::solve_policy(table, policy, gamma, solve,
                                [&](StateId s, ActionId a) { return action_value(table, zero, 0.0, s, a); });
}

/// The greatest expected undiscounted return of an episode, over the table's starts: V* for gamma = 1, of the states
/// that episodes can visit. None where value iteration finds no finite one, or where an episode can get into states
/// that have rewards but no end. Rewards of 0 for ever are a return of 0.
[[nodiscard]] inline std::optional<double> optimal_return(const TransitionTable& table) {
    const std::vector<char> reachable = detail::reachable_states(table);
    const std::vector<char> can_end = detail::states_that_can_end(table);
    for (std::size_t s = 0; s < table.states(); ++s) {
        if (reachable[s] == 0 || can_end[s] != 0) continue;
        for (std::size_t a = 0; a < table.actions(); ++a) {
            for (const Outcome& outcome : table.outcomes(state_id(s), action_id(a))) {
                if (outcome.reward < 0.0 || outcome.reward > 0.0) return std::nullopt;
            }
        }
    }
    try {
        return mean_over_starts(table, detail::value_iteration(table, reachable, 1.0, 1e-10, 100000));
    } catch (const std::runtime_error&) {
        return std::nullopt;
    }
}

}  // namespace sspql
