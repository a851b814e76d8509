// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include <sspql/core/assert.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/model/probability.hpp>
#include <sspql/model/transition_counts.hpp>
#include <sspql/paths/shortest_paths.hpp>

namespace sspql {

/// Q_SSP (eq. 5 of Kwon, Suh and Lee 2011): e^{-H(s,a)} for the action a that most likely takes s to the next state of
/// its shortest path, a = argmax_a P(next(s)|s,a), the least a on ties; 0 for every other action, and in states
/// without a path. H is the entropy of eq. 6, so the value lies in (0, 1]: the surer the outcome, the larger.
///
/// One action a state is kept (12 bytes), not a table. Values stand as of the last assign.
class SspValues {
public:
    /// Recomputes all values from counts and tree, choosing among the actions that `legal.allowed(s)` contains; where
    /// none of those was seen to lead to next(s), the state has no value. O(n + sum of out-degrees).
    template <class Cell, class LegalActions>
    void assign(const TransitionCounts<Cell>& counts, const ShortestPathTree& tree, const LegalActions& legal) {
        resize(tree.size());
        for (std::size_t s = 0; s < tree.size(); ++s) update(counts, tree, state_id(s), legal);
    }

    /// Recomputes the values of one state, whose counts, next state or legal actions changed. O(out-degree).
    template <class Cell, class LegalActions>
    void update(const TransitionCounts<Cell>& counts, const ShortestPathTree& tree, StateId s,
                const LegalActions& legal) {
        SSPQL_ASSERT(tree.size() <= counts.states(), "the tree is one of these counts");
        action_[index(s)] = no_action;
        value_[index(s)] = 0.0;
        if (tree.next[index(s)] != no_state) compute(counts, s, tree.next[index(s)], legal);
    }

    /// As many states as the tree has; new ones have no value.
    void resize(std::size_t states) {
        action_.resize(states, no_action);
        value_.resize(states, 0.0);
    }

    /// The number of states that have a place, with a value or without.
    [[nodiscard]] std::size_t size() const noexcept { return action_.size(); }

    /// Exchanges all values. O(1).
    void swap(SspValues& other) noexcept {
        action_.swap(other.action_);
        value_.swap(other.value_);
    }

    /// Q_SSP(s,a). States added since the last assign have 0.
    [[nodiscard]] double operator()(StateId s, ActionId a) const noexcept {
        return index(s) < action_.size() && action_[index(s)] == a ? value_[index(s)] : 0.0;
    }

    /// The action on the shortest path; no_action where there is none.
    [[nodiscard]] ActionId action(StateId s) const noexcept {
        return index(s) < action_.size() ? action_[index(s)] : no_action;
    }

    /// No states.
    void clear() noexcept {
        action_.clear();
        value_.clear();
    }

    /// Room for that many states.
    void reserve(std::size_t states) {
        action_.reserve(states);
        value_.reserve(states);
    }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive, std::size_t states, std::size_t actions) {
        archive(action_, value_);
        archive.require(action_.size() == value_.size() && size() <= states, "path values are of other states");
        for (const ActionId a : action_) archive.require(a == no_action || index(a) < actions, "a path's action is none");
    }

    template <class Cell, class LegalActions>
    void compute(const TransitionCounts<Cell>& counts, StateId s, StateId next, const LegalActions& legal) {
        const auto allowed = legal.allowed(s);
        const std::size_t degree = counts.out_degree(s);
        std::size_t i = 0;
        while (i < degree && counts.successor(s, i).state() != next) ++i;
        if (i == degree) return;
        ActionId best = no_action;
        double best_probability = 0.0;
        counts.successor(s, i).for_each_action([&](ActionId a, const Cell& cell) {
            if (!allowed.contains(a)) return;
            const double p = static_cast<double>(cell.count()) / static_cast<double>(counts.n(s, a));
            if (p > best_probability || (p == best_probability && a < best)) {
                best = a;
                best_probability = p;
            }
        });
        if (best == no_action) return;
        action_[index(s)] = best;
        // Of a sure outcome H is 0.
        value_[index(s)] = best_probability == 1.0 ? 1.0 : std::exp(-entropy(counts, s, best));
    }

    std::vector<ActionId> action_;
    std::vector<double> value_;
};

}  // namespace sspql
