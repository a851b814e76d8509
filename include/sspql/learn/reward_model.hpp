// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <sspql/core/assert.hpp>
#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/random.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/learn/q_table.hpp>
#include <sspql/learn/transition.hpp>
#include <sspql/learn/value_learner.hpp>
#include <sspql/model/transition_counts.hpp>

namespace sspql {

/// The types a model-based learner is made of; derive and rename one to replace it. Cell must keep rewards.
struct ModelPolicies : ValuePolicies {
    using Cell = FadingCell;  ///< what is kept of an (s,a,s')
};

/// Parameters of a model-based learner: those of a Q table, and how far the model trusts the past.
template <class Policies>
struct ModelParams : ValueParams<Policies> {
    /// At most this many observations count for one (s,a); older ones fade, so that a changed world is noticed. 0: all
    /// count for ever.
    double cap = 0.0;
    double least_count = 0.02;  ///< an outcome whose faded count falls below is forgotten
    /// An optimistic pseudo-count: every (s,a) counts as if it had led this often to `unknown_value`.
    double kappa = 0.0;
    double unknown_value = 1.0;  ///< of an optimistic outcome

    template <class Archive>
    void serialize(Archive& archive) {
        ValueParams<Policies>::serialize(archive);
        archive(cap, least_count, kappa, unknown_value);
    }

    /// Checks every number of the model. \throws std::invalid_argument naming the first number out of range.
    void validate() const {
        if (cap != 0.0) require_in("cap", cap, 1.0, 1e9);
        require_in("least_count", least_count, 0.0, 0.5);
        require_not_negative("kappa", kappa);
        require_finite("unknown_value", unknown_value);
    }
};

/// What model-based learners ask of what they have seen: expected values (full backups) and sampled outcomes, with
/// forgetting. Counts every edge it touches.
template <class Cell>
class RewardModel {
    static_assert(Cell::keeps_rewards, "sspql: a model-based learner needs a Cell that keeps rewards (FadingCell)");

public:
    /// The counts.
    using Counts = TransitionCounts<Cell>;

    /// An outcome: its cell (valid until the next observation) and the state it led to.
    struct Drawn {
        const Cell* cell = nullptr;  ///< what is known of the outcome
        StateId next = no_state;     ///< where it led
    };

    /// Nothing observed.
    RewardModel(std::size_t states, std::size_t actions) : counts_(states, actions) {}

    /// More states, never seen.
    void grow(std::size_t states) { counts_.grow(states); }
    /// Room for that many states and distinct (s,s').
    void reserve(std::size_t states, std::size_t pairs) { counts_.reserve(states, pairs); }

    /// What was observed.
    [[nodiscard]] const Counts& counts() const noexcept { return counts_; }

    /// Records the step; where that would make more than `cap` observations of (s,a), its past fades first, so that the
    /// new one counts 1 in `cap`. O(1) amortised, O(out-degree) at the cap.
    template <class Params>
    void observe(const Transition& t, const Params& params) {
        ++operations_;
        const double n = counts_.n(t.state, t.action);
        if (params.cap > 0.0 && n + 1.0 > params.cap) {
            counts_.fade(t.state, t.action, (params.cap - 1.0) / n, params.least_count);
        }
        counts_.record(t.state, t.action, t.next, t.terminated, t.reward, t.weight);
        counts_.clear_dirty();
    }

    /// As if (s,a) had never been tried. O(out-degree).
    void forget(StateId s, ActionId a) {
        counts_.fade(s, a, 0.0, 1.0);
        counts_.clear_dirty();
    }

    /// The expected value of (s,a), tried at least once: the mean over its outcomes of r + gamma max_a' Q(s',a'), and the
    /// optimistic pseudo-count. O(out-degree x |A|).
    template <class Params, class LegalActions>
    [[nodiscard]] double backup(StateId s, ActionId a, const QTable& q, const Params& params,
                                const LegalActions& legal) {
        double sum = params.kappa * params.unknown_value;
        counts_.for_each_outcome(s, a, [&](StateId next, const Cell& cell) {
            ++operations_;
            sum += cell.reward_sum;
            if (!cell.terminal()) sum += cell.count() * params.gamma * q.legal_max(next, legal);
        });
        return sum / (counts_.n(s, a) + params.kappa);
    }

    /// One outcome of (s,a), tried at least once, with the probability the counts give it; its reward is the mean one.
    /// `u` is the draw, uniform in [0, 1). O(out-degree).
    [[gnu::always_inline, nodiscard]] Drawn draw(StateId s, ActionId a, double u) {
        // No early exit: where the draw falls, nobody can predict; that costs more than the few records behind it.
        double left = u * counts_.n(s, a);
        std::size_t place = 0;
        counts_.for_each_n(s, a, [&](double n) {
            left -= n;
            place += static_cast<std::size_t>(left >= 0.0);
        });
        Drawn drawn;
        if (place < counts_.out_degree(s)) {
            const auto successor = counts_.successor(s, place);
            drawn = {successor.cell(a), successor.state()};
        } else {  // rounding left something over: the last one
            counts_.for_each_successor(s, [&](const auto& successor) {
                if (const Cell* cell = successor.cell(a)) drawn = {cell, successor.state()};
            });
        }
        SSPQL_ASSERT(drawn.cell != nullptr, "only what was tried can be drawn from");
        ++operations_;
        return drawn;
    }

    /// The same as a step.
    [[nodiscard]] Transition sample(StateId s, ActionId a, Random& random) {
        const Drawn drawn = draw(s, a, random.uniform());
        return {s, a, drawn.cell->reward_sum / drawn.cell->count(), drawn.next, drawn.cell->terminal(), 1.0};
    }

    /// Edges and records touched so far.
    [[nodiscard]] std::uint64_t operations() const noexcept { return operations_; }
    /// Somebody else touched an edge or a record.
    void count_operation() noexcept { ++operations_; }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive) {
        archive(counts_, operations_);
    }

    Counts counts_;
    std::uint64_t operations_ = 0;
};

}  // namespace sspql
