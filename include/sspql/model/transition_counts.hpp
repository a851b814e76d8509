// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include <sspql/core/assert.hpp>
#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/model/action_cells.hpp>
#include <sspql/model/adjacency.hpp>
#include <sspql/model/cells.hpp>

namespace sspql {

/// The least and greatest weight of a transition (eq. 2); anything else is refused.
inline constexpr double min_weight = 1e-30;
inline constexpr double max_weight = 1e30;

/// What was observed: N(s,a,s'), N(s,a) (eq. 4's counts), the mean weight of each (s,s') (eq. 2's weight(s,s')), and
/// what Cell adds. Sparse: memory goes with what was seen, |S| x |A| only for N(s,a). Knows nothing of costs, goals or
/// probabilities; those are computed from it (model/probability.hpp, paths/cost.hpp).
///
/// Ids: states 0 to states() - 1, actions 0 to actions() - 1; asserted, not checked (learners check). States can be
/// added with grow().
/// Complexity: record O(1) amortised for up to 8 actions or few successors (see detail::Adjacency), successors and
/// predecessors at memory speed. Allocation: only when blocks grow past what reserve() promised.
/// Every record marks s dirty; whoever derives something per state refreshes dirty states only, then clears the list.
/// Each (s,s') carries one `label`, a number that counts never read: paths/ keeps edge costs there.
/// Threads: none inside; const members may run together.
template <class Cell = CountCell>
class TransitionCounts {
    static_assert(std::is_trivially_copyable_v<Cell>, "sspql: a Cell must be trivially copyable");

public:
    using Number = typename Cell::Number;

    /// One (s,s') that was observed. A view: valid until the next record, erase or grow.
    class Successor {
    public:
        [[nodiscard]] StateId state() const noexcept { return detail::Adjacency::target(bytes_); }

        /// N(s,a,s').
        [[nodiscard]] Number n(ActionId a) const noexcept {
            const Cell* cell = counts_->cells_.find(payload(), a);
            return cell == nullptr ? Number{0} : cell->count();
        }

        /// Calls f(ActionId, const Cell&) for every action with N(s,a,s') > 0, in no particular order.
        template <class F>
        void for_each_action(F&& f) const {
            counts_->cells_.for_each(payload(), f);
        }

        /// The cell of (s,a,s'), or nullptr if never observed.
        [[nodiscard]] const Cell* cell(ActionId a) const noexcept {
            const Cell* found = counts_->cells_.find(payload(), a);
            return found != nullptr && found->count() > Number{0} ? found : nullptr;
        }

        /// Mean observed weight; 1 unless others were given.
        [[nodiscard]] double weight() const noexcept { return counts_->pairs_.weight(record_); }

        [[nodiscard]] double label() const noexcept { return counts_->pairs_.label(record_); }

    private:
        friend class TransitionCounts;
        Successor(const TransitionCounts* counts, std::uint32_t record, const std::byte* bytes) noexcept
            : counts_(counts), bytes_(bytes), record_(record) {}
        [[nodiscard]] const std::byte* payload() const noexcept { return detail::Adjacency::payload(bytes_); }

        const TransitionCounts* counts_;
        const std::byte* bytes_;  // of the record
        std::uint32_t record_;
    };

    /// \throws std::invalid_argument for no actions or more than 2^32 - 2 states or actions. No states are fine.
    TransitionCounts(std::size_t states, std::size_t actions)
        : cells_(detail::require_id_count("number of actions", actions)),
          pairs_(cells_.payload_bytes(), cells_.payload_alignment()),
          actions_(actions) {
        if (states != 0) grow(states);
    }

    [[nodiscard]] std::size_t states() const noexcept { return pairs_.states(); }
    [[nodiscard]] std::size_t actions() const noexcept { return actions_; }

    /// Distinct (s,s') observed: the number of edges.
    [[nodiscard]] std::size_t pairs() const noexcept { return pairs_.pairs(); }

    /// More states, with ids up to `states` - 1. Fewer than now changes nothing.
    void grow(std::size_t states) {
        if (states <= pairs_.states()) return;
        detail::require_id_count("number of states", states);
        totals_.resize(states * actions_, Number{0});
        pairs_.grow(states);
    }

    /// Room for `states` states and `pairs` distinct (s,s'): then record does not allocate, unless a state has more
    /// than 32 successors or more than 8 actions are in use; the first weight other than 1 allocates once.
    void reserve(std::size_t states, std::size_t pairs) {
        totals_.reserve(states * actions_);
        pairs_.reserve(states, pairs);
        cells_.reserve(pairs);
    }

    /// One observation: a in s led to `next`. `terminal` (did the episode end there) and `reward` go to the cell,
    /// `weight` into the mean weight of (s,next).
    /// \throws std::invalid_argument for a weight outside [1e-30, 1e30] or NaN; nothing has changed then.
    void record(StateId s, ActionId a, StateId next, bool terminal = false, double reward = 0.0, double weight = 1.0) {
        SSPQL_ASSERT(index(s) < states() && index(next) < states() && index(a) < actions_, "ids within range");
        if (weight != 1.0) require_in("weight", weight, min_weight, max_weight);
        std::uint32_t at = pairs_.find(s, next);
        if (at == detail::Adjacency::none) at = pairs_.insert(s, next);
        Number& total = totals_[index(s) * actions_ + index(a)];
        Cell& cell = cells_.touch(pairs_.payload(at), a);
        if (saturated(cell, total)) halve(s, a);
        cell.add(reward, terminal);
        total += Number{1};
        if (weight != 1.0 || pairs_.has_weights()) update_weight(at, weight);
        pairs_.mark_dirty(s);
    }

    /// N(s,a). For a fading cell the sum of what is left.
    [[nodiscard]] Number n(StateId s, ActionId a) const noexcept { return totals_[index(s) * actions_ + index(a)]; }

    /// N(s,a,s').
    [[nodiscard]] Number n(StateId s, ActionId a, StateId next) const noexcept {
        const Cell* found = cell(s, a, next);
        return found == nullptr ? Number{0} : found->count();
    }

    /// The cell of (s,a,s'), or nullptr if it was never observed. Valid until the next record, erase or grow.
    [[nodiscard]] const Cell* cell(StateId s, ActionId a, StateId next) const noexcept {
        const std::uint32_t at = pairs_.find(s, next);
        if (at == detail::Adjacency::none) return nullptr;
        const Cell* found = cells_.find(pairs_.payload(at), a);
        return found != nullptr && found->count() > Number{0} ? found : nullptr;
    }

    /// Number of distinct successors of s over all actions.
    [[nodiscard]] std::size_t out_degree(StateId s) const noexcept { return pairs_.out_size(s); }
    [[nodiscard]] std::size_t in_degree(StateId s) const noexcept { return pairs_.in_size(s); }

    /// Calls f(const Successor&) for every s' observed after s. O(out-degree).
    template <class F>
    void for_each_successor(StateId s, F&& f) const {
        const std::uint32_t begin = pairs_.out_begin(s);
        const std::uint32_t end = begin + pairs_.out_size(s);
        const std::size_t stride = pairs_.stride();
        const std::byte* bytes = pairs_.record(begin);
        for (std::uint32_t i = begin; i < end; ++i, bytes += stride) f(Successor(this, i, bytes));
    }

    /// The i-th of them, i < out_degree(s).
    [[nodiscard]] Successor successor(StateId s, std::size_t i) const noexcept {
        const std::uint32_t at = pairs_.out_begin(s) + static_cast<std::uint32_t>(i);
        return Successor(this, at, pairs_.record(at));
    }

    /// For somebody who soon looks at (s,a) and its successors: has them fetched into the cache. No effect else.
    void prefetch(StateId s, ActionId a) const noexcept {
        pairs_.prefetch(s);
        detail::prefetch(&totals_[index(s) * actions_ + index(a)]);
    }

    /// Calls f(StateId predecessor, double label) for every state from which s was reached. O(in-degree).
    template <class F>
    void for_each_predecessor(StateId s, F&& f) const {
        pairs_.for_each_predecessor(s, f);
    }

    /// Calls f(StateId predecessor, const Successor& edge) for every state from which s was reached, with what is known
    /// of the edge into s. O(in-degree x out-degree of the predecessors), out-degrees counting up to 32.
    template <class F>
    void for_each_edge_into(StateId s, F&& f) const {
        pairs_.for_each_predecessor(s, [&](StateId u, double) {
            const std::uint32_t at = pairs_.find(u, s);
            f(u, Successor(this, at, pairs_.record(at)));
        });
    }

    /// Writes the label of (s,s'), which is read from s' (for_each_predecessor) and from s (Successor::label).
    void set_label(const Successor& successor, double value) noexcept { pairs_.set_label(successor.record_, value); }

    /// States recorded since clear_dirty(), each once, in the order of their first record.
    [[nodiscard]] const std::vector<StateId>& dirty() const noexcept { return pairs_.dirty(); }
    void clear_dirty() noexcept { pairs_.clear_dirty(); }

    /// Multiplies all counts of (s,a) by `factor`, then forgets those below `least`: fading (FadingCell only).
    /// Pairs (s,s') that no action is left for disappear, from both sides. O(out-degree). Marks s dirty.
    template <class C = Cell>
    void fade(StateId s, ActionId a, double factor, double least) {
        static_assert(!std::is_integral_v<typename C::Number>,
                      "sspql: integer counts cannot fade; use TransitionCounts<FadingCell>");
        SSPQL_ASSERT(factor >= 0.0 && factor <= 1.0 && least >= 0.0, "fading never adds");
        Number total{0};
        for (std::uint32_t i = 0; i < pairs_.out_size(s);) {
            const std::uint32_t at = pairs_.out_begin(s) + i;
            C* found = cells_.find(pairs_.payload(at), a);
            if (found != nullptr) {
                if constexpr (!std::is_integral_v<typename C::Number>) found->scale(factor);
                if (found->count() < least) *found = Cell{};
                total += found->count();
                if (cells_.vacant(pairs_.payload(at))) {
                    cells_.release(pairs_.payload(at));
                    pairs_.erase(s, at);  // the last one is at this place now
                    continue;
                }
            }
            ++i;
        }
        totals_[index(s) * actions_ + index(a)] = total;
        pairs_.mark_dirty(s);
    }

    /// Calls f(StateId next, Cell&) for every outcome of (s,a): for changing what Cell adds to counting, such as a fast
    /// count. Changed counts must be followed by fade(), which sums them up. O(out-degree).
    template <class F>
    void for_each_cell(StateId s, ActionId a, F&& f) {
        const std::uint32_t begin = pairs_.out_begin(s);
        const std::uint32_t end = begin + pairs_.out_size(s);
        for (std::uint32_t i = begin; i < end; ++i) {
            Cell* found = cells_.find(pairs_.payload(i), a);
            if (found != nullptr && found->count() > Number{0}) f(pairs_.target(i), *found);
        }
    }

    /// The cell for changing what Cell adds to counting, such as a fast count; nullptr if never observed.
    [[nodiscard]] Cell* cell(StateId s, ActionId a, StateId next) noexcept {
        return const_cast<Cell*>(std::as_const(*this).cell(s, a, next));
    }

    /// Heap bytes held, capacity included.
    [[nodiscard]] std::size_t bytes() const noexcept {
        return pairs_.bytes() + cells_.bytes() + totals_.capacity() * sizeof(Number);
    }

private:
    static bool saturated(const Cell& cell, Number total) noexcept {
        if constexpr (std::is_integral_v<Number>) {
            return cell.full() || total >= Cell::limit;
        } else {
            static_cast<void>(total);
            return cell.full();
        }
    }

    void halve(StateId s, ActionId a) noexcept {
        Number total{0};
        const std::uint32_t begin = pairs_.out_begin(s);
        const std::uint32_t end = begin + pairs_.out_size(s);
        for (std::uint32_t i = begin; i < end; ++i) {
            Cell* found = cells_.find(pairs_.payload(i), a);
            if (found == nullptr) continue;
            found->halve();
            total += found->count();
        }
        totals_[index(s) * actions_ + index(a)] = total;
    }

    void update_weight(std::uint32_t at, double weight) {
        double n = 0.0;
        cells_.for_each(pairs_.payload(at), [&n](ActionId, const Cell& cell) { n += static_cast<double>(cell.count()); });
        const double mean = pairs_.weight(at);
        pairs_.set_weight(at, n <= 1.0 ? weight : mean + (weight - mean) / n);
    }

    detail::ActionCells<Cell> cells_;
    detail::Adjacency pairs_;
    std::vector<Number> totals_;
    std::size_t actions_;
};

}  // namespace sspql
