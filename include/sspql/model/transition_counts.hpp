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
#include <sspql/core/serialization.hpp>
#include <sspql/model/adjacency.hpp>
#include <sspql/model/cells.hpp>
#include <sspql/model/prefetch.hpp>
#include <sspql/model/sparse_cells.hpp>

namespace sspql {

namespace detail {

template <class Cell>
struct CountsArchive;  // counts_archive.hpp

}  // namespace detail

/// The least weight of a transition (eq. 2); anything below is refused.
inline constexpr double min_weight = 1e-30;
/// The greatest weight of a transition (eq. 2); anything above is refused.
inline constexpr double max_weight = 1e30;

/// What was observed: N(s,a,s'), N(s,a) (eq. 4's counts), the mean weight of each (s,s') (eq. 2's weight(s,s')), and
/// what Cell adds. Knows nothing of costs, goals or probabilities; those are computed from it (model/probability.hpp,
/// paths/cost.hpp).
///
/// Ids: states 0 to states() - 1, actions 0 to actions() - 1; asserted, not checked (learners check). States can be
/// added with grow().
/// Memory: a state has room for N(s,a), four successors and four predecessors from the start, 96 + 20 |A| bytes with
/// CountCell (beyond 8 actions 144 + 4 |A|), which stay untouched address space until it is seen; what it has more goes
/// with what was seen.
/// Complexity: record O(1) amortised for up to 8 actions or few successors (see detail::Adjacency), successors and
/// predecessors at memory speed. Allocation: only when blocks grow past what reserve() promised.
/// Every record marks s dirty; whoever derives something per state refreshes dirty states only, then clears the list.
/// Each (s,s') carries one `label`, a number that counts never read: paths/ keeps edge costs there.
/// Threads: none inside; const members may run together.
template <class Cell = CountCell>
class TransitionCounts {
    static_assert(std::is_trivially_copyable_v<Cell>, "sspql: a Cell must be trivially copyable");
    static_assert(alignof(Cell) <= 8, "sspql: a Cell's alignment is 8 at most");

    using Pairs = detail::Adjacency<typename Cell::Number>;
    using Edge = typename Pairs::Edge;
    using Handle = typename detail::SparseCells<Cell>::Handle;

public:
    /// The type of N(s,a,s') and N(s,a): integers, or doubles that fade.
    using Number = typename Cell::Number;

    /// One (s,s') that was observed. A view: valid until the next record, erase or grow.
    class Successor {
    public:
        /// The next state, s'.
        [[nodiscard]] StateId state() const noexcept { return edge_.block.state(edge_.at); }

        /// N(s,a,s').
        [[nodiscard]] Number n(ActionId a) const noexcept {
            const Cell* cell = counts_->find_cell(edge_, a);
            return cell == nullptr ? Number{0} : cell->count();
        }

        /// Calls f(ActionId, const Cell&) for every action with N(s,a,s') > 0, in no particular order.
        template <class F>
        void for_each_action(F&& f) const {
            counts_->for_each_action(edge_, f);
        }

        /// The cell of (s,a,s'), or nullptr if never observed.
        [[nodiscard]] const Cell* cell(ActionId a) const noexcept { return observed(counts_->find_cell(edge_, a)); }

        /// Mean observed weight; 1 unless others were given.
        [[nodiscard]] double weight() const noexcept { return counts_->pairs_.weight(edge_); }

        /// The label of (s,s'), see set_label; NaN until somebody wrote one.
        [[nodiscard]] double label() const noexcept { return counts_->pairs_.label(edge_); }
        /// For somebody who soon reads or writes it: has it fetched into the cache.
        void prefetch_label() const noexcept { detail::prefetch(&counts_->pairs_.label(edge_)); }

    private:
        friend class TransitionCounts;
        Successor(const TransitionCounts* counts, const Edge& edge) noexcept : counts_(counts), edge_(edge) {}

        const TransitionCounts* counts_;
        Edge edge_;
    };

    /// Nothing counted yet.
    /// \throws std::invalid_argument for no actions or more than 2^32 - 2 states or actions. No states are fine.
    TransitionCounts(std::size_t states, std::size_t actions)
        : actions_(detail::require_id_count("number of actions", actions)),
          pairs_(actions, dense() ? actions : 1, dense() ? sizeof(Cell) : sizeof(Handle)) {
        if (states != 0) grow(states);
    }

    /// The number of states, seen or not.
    [[nodiscard]] std::size_t states() const noexcept { return pairs_.states(); }
    /// The number of actions.
    [[nodiscard]] std::size_t actions() const noexcept { return actions_; }

    /// Distinct (s,s') observed: the number of edges.
    [[nodiscard]] std::size_t pairs() const noexcept { return pairs_.pairs(); }

    /// Distinct (s,s') that fade() has removed so far: as long as this stays, edges were only added.
    [[nodiscard]] std::uint64_t erasures() const noexcept { return pairs_.erasures(); }

    /// More states, with ids up to `states` - 1. Fewer than now changes nothing.
    void grow(std::size_t states) {
        if (states <= pairs_.states()) return;
        detail::require_id_count("number of states", states);
        pairs_.grow(states);
    }

    /// Room for `states` states and `pairs` distinct (s,s'): then record does not allocate, unless a state has more
    /// than 32 successors or more than 8 actions are in use; the first weight other than 1 allocates its arrays.
    void reserve(std::size_t states, std::size_t pairs) {
        pairs_.reserve(states, pairs);
        if (!dense()) sparse_.reserve(pairs);
    }

    /// One observation: a in s led to `next`. `terminal` (did the episode end there) and `reward` go to the cell,
    /// `weight` into the mean weight of (s,next).
    /// \throws std::invalid_argument for a weight outside [1e-30, 1e30] or NaN; nothing has changed then.
    void record(StateId s, ActionId a, StateId next, bool terminal = false, double reward = 0.0, double weight = 1.0) {
        SSPQL_ASSERT(index(s) < states() && index(next) < states() && index(a) < actions_, "ids within range");
        if (weight == 1.0 && plain_) {
            const std::uint32_t place = pairs_.find_inner(s, next);
            if (place != Pairs::none) {
                Cell& cell = *dense_cell(pairs_.inner_successors(s), place, a);
                Number& total = pairs_.totals(s)[index(a)];
                if (!saturated(cell, total)) {
                    cell.add(reward, terminal);
                    total += Number{1};
                    pairs_.mark_dirty(s);
                    return;
                }
            }
        }
        record_any(s, a, next, terminal, reward, weight);
    }

    /// N(s,a). For a fading cell the sum of what is left.
    [[nodiscard]] Number n(StateId s, ActionId a) const noexcept { return pairs_.totals(s)[index(a)]; }

    /// N(s,a,s').
    [[nodiscard]] Number n(StateId s, ActionId a, StateId next) const noexcept {
        const Cell* found = cell(s, a, next);
        return found == nullptr ? Number{0} : found->count();
    }

    /// The cell of (s,a,s'), or nullptr if it was never observed. Valid until the next record, erase or grow.
    [[nodiscard]] const Cell* cell(StateId s, ActionId a, StateId next) const noexcept {
        const std::uint32_t place = pairs_.find(s, next);
        return place == Pairs::none ? nullptr : observed(find_cell(pairs_.edge(s, place), a));
    }

    /// Number of distinct successors of s over all actions.
    [[nodiscard]] std::size_t out_degree(StateId s) const noexcept { return pairs_.out_size(s); }
    /// Number of distinct predecessors of s over all actions.
    [[nodiscard]] std::size_t in_degree(StateId s) const noexcept { return pairs_.in_size(s); }

    /// Calls f(const Successor&) for every s' observed after s. O(out-degree).
    template <class F>
    void for_each_successor(StateId s, F&& f) const {
        pairs_.for_each_edge(s, [&](const Edge& edge) { f(Successor(this, edge)); });
    }

    /// The i-th of them, i < out_degree(s).
    [[nodiscard]] Successor successor(StateId s, std::size_t i) const noexcept {
        return Successor(this, pairs_.edge(s, static_cast<std::uint32_t>(i)));
    }

    /// Calls f(StateId next, const Cell&) for every s' observed after a in s, in the order of for_each_successor. Up to
    /// 8 actions the cells of an action lie together. O(out-degree).
    template <class F>
    void for_each_outcome(StateId s, ActionId a, F&& f) const {
        if (!dense()) return for_each_sparse_outcome(s, a, f);
        pairs_.for_each_block(s, [&](const detail::Successors& block, std::uint32_t size, std::uint32_t) {
            const Cell* cell = dense_cell(block, 0, a);
            for (std::uint32_t i = 0; i < size; ++i) {
                if (cell[i].count() > Number{0}) f(block.state(i), cell[i]);
            }
        });
    }

    /// Calls f(N(s,a,s')) for every s' observed after s, 0 for those that never followed a, in the order of
    /// for_each_successor. O(out-degree).
    template <class F>
    void for_each_n(StateId s, ActionId a, F&& f) const {
        if (!dense()) return for_each_successor(s, [&](const Successor& successor) { f(successor.n(a)); });
        pairs_.for_each_block(s, [&](const detail::Successors& block, std::uint32_t size, std::uint32_t) {
            const Cell* cell = dense_cell(block, 0, a);
            for (std::uint32_t i = 0; i < size; ++i) f(cell[i].count());
        });
    }

    /// For somebody who soon looks at (s,a) and its outcomes: has them fetched into the cache. No effect else.
    void prefetch(StateId s, ActionId a) const noexcept { pairs_.prefetch(s, dense() ? index(a) : 0); }

    /// Calls f(StateId predecessor, double label) for every state from which s was reached. O(in-degree).
    template <class F>
    void for_each_predecessor(StateId s, F&& f) const {
        pairs_.for_each_predecessor(s, f);
    }

    /// Calls f(StateId predecessor, const Successor& edge) for every state from which s was reached, with what is known
    /// of the edge into s. O(in-degree x out-degree of the predecessors), out-degrees counting up to 32.
    template <class F>
    void for_each_edge_into(StateId s, F&& f) const {
        pairs_.for_each_predecessor(
            s, [&](StateId u, double) { f(u, Successor(this, pairs_.edge(u, pairs_.find(u, s)))); });
    }

    /// Writes the label of (s,s'), which is read from s' (for_each_predecessor) and from s (Successor::label).
    void set_label(const Successor& successor, double value) noexcept { pairs_.label(successor.edge_) = value; }

    /// States recorded since clear_dirty(), each once, in the order of their first record.
    [[nodiscard]] const std::vector<StateId>& dirty() const noexcept { return pairs_.dirty(); }
    /// Nothing is dirty any more. O(dirty states).
    void clear_dirty() noexcept { pairs_.clear_dirty(); }

    /// Multiplies all counts of (s,a) by `factor`, then forgets those below `least`: fading (FadingCell only).
    /// Pairs (s,s') that no action is left for disappear, from both sides. O(out-degree). Marks s dirty.
    template <class C = Cell>
    void fade(StateId s, ActionId a, double factor, double least) {
        static_assert(!std::is_integral_v<typename C::Number>,
                      "sspql: integer counts cannot fade; use TransitionCounts<FadingCell>");
        SSPQL_ASSERT(factor >= 0.0 && factor <= 1.0 && least >= 0.0, "fading never adds");
        pairs_.mark_dirty(s);
        Number total{0};
        for (std::uint32_t i = 0; i < pairs_.out_size(s);) {
            const Edge edge = pairs_.edge(s, i);
            C* found = find_cell(edge, a);
            if (found != nullptr) {
                if constexpr (!std::is_integral_v<typename C::Number>) found->scale(factor);
                if (found->count() < least) *found = Cell{};
                total += found->count();
                if (vacant(edge)) {
                    if (!dense()) sparse_.release(handle(edge.block, edge.at));
                    pairs_.erase(s, i);  // the last one is at this place now
                    continue;
                }
            }
            ++i;
        }
        pairs_.totals(s)[index(a)] = total;
    }

    /// Calls f(StateId next, Cell&) for every outcome of (s,a): for changing what Cell adds to counting, such as a fast
    /// count. Changed counts must be followed by fade(), which sums them up. O(out-degree).
    template <class F>
    void for_each_cell(StateId s, ActionId a, F&& f) {
        for_each_outcome(s, a, [&](StateId next, const Cell& cell) { f(next, const_cast<Cell&>(cell)); });
    }

    /// The cell for changing what Cell adds to counting, such as a fast count; nullptr if never observed.
    [[nodiscard]] Cell* cell(StateId s, ActionId a, StateId next) noexcept {
        return const_cast<Cell*>(std::as_const(*this).cell(s, a, next));
    }

    /// Heap bytes held, capacity included.
    [[nodiscard]] std::size_t bytes() const noexcept { return pairs_.bytes() + (dense() ? 0 : sparse_.bytes()); }

private:
    friend SerializationAccess;
    friend detail::CountsArchive<Cell>;

    template <class Archive>
    void serialize(Archive& archive) {
        detail::CountsArchive<Cell>::serialize(*this, archive);
    }

    /// record() without a short cut.
    [[gnu::noinline]] void record_any(StateId s, ActionId a, StateId next, bool terminal, double reward,
                                      double weight) {
        if (weight != 1.0) {
            require_in("weight", weight, min_weight, max_weight);
            plain_ = false;
        }
        std::uint32_t place = pairs_.find(s, next);
        if (place == Pairs::none) place = pairs_.insert(s, next);
        const Edge edge = pairs_.edge(s, place);
        Number& total = pairs_.totals(s)[index(a)];
        Cell& cell = touch_cell(edge, a);
        if (saturated(cell, total)) halve(s, a);
        cell.add(reward, terminal);
        total += Number{1};
        if (weight != 1.0 || pairs_.has_weights()) update_weight(edge, weight);
        pairs_.mark_dirty(s);
    }

    static bool saturated(const Cell& cell, Number total) noexcept {
        if constexpr (std::is_integral_v<Number>) {
            return cell.full() || total >= Cell::limit;
        } else {
            static_cast<void>(total);
            return cell.full();
        }
    }

    [[nodiscard]] bool dense() const noexcept { return actions_ <= dense_actions; }

    static const Cell* observed(const Cell* cell) noexcept {
        return cell != nullptr && cell->count() > Number{0} ? cell : nullptr;
    }

    // Up to dense_actions a row of cells for each action, beyond one of handles.
    [[nodiscard]] static Cell* dense_cell(const detail::Successors& block, std::uint32_t at, ActionId a) noexcept {
        return reinterpret_cast<Cell*>(block.cell(index(a), at, sizeof(Cell)));
    }
    [[nodiscard]] static Handle& handle(const detail::Successors& block, std::uint32_t at) noexcept {
        return *reinterpret_cast<Handle*>(block.cell(0, at, sizeof(Handle)));
    }

    /// The cell, or nullptr where the action never occurred (dense: then it is all zero).
    [[nodiscard]] Cell* find_cell(const Edge& edge, ActionId a) const noexcept {
        return dense() ? dense_cell(edge.block, edge.at, a) : sparse_.find(handle(edge.block, edge.at), a);
    }

    [[nodiscard]] Cell& touch_cell(const Edge& edge, ActionId a) {
        return dense() ? *dense_cell(edge.block, edge.at, a) : sparse_.touch(handle(edge.block, edge.at), a);
    }

    template <class F>
    void for_each_action(const Edge& edge, F&& f) const {
        if (!dense()) return sparse_.for_each(handle(edge.block, edge.at), f);
        const Cell* cell = dense_cell(edge.block, edge.at, ActionId{0});
        for (std::size_t a = 0; a < actions_; ++a, cell += edge.block.capacity) {
            if (cell->count() > Number{0}) f(action_id(a), *cell);
        }
    }

    template <class F>
    void for_each_sparse_outcome(StateId s, ActionId a, F&& f) const {
        pairs_.for_each_edge(s, [&](const Edge& edge) {
            const Cell* cell = observed(sparse_.find(handle(edge.block, edge.at), a));
            if (cell != nullptr) f(edge.block.state(edge.at), *cell);
        });
    }

    [[nodiscard]] bool vacant(const Edge& edge) const {
        bool empty = true;
        for_each_action(edge, [&empty](ActionId, const Cell&) { empty = false; });
        return empty;
    }

    void halve(StateId s, ActionId a) noexcept {
        Number total{0};
        pairs_.for_each_edge(s, [&](const Edge& edge) {
            Cell* found = find_cell(edge, a);
            if (found == nullptr) return;
            found->halve();
            total += found->count();
        });
        pairs_.totals(s)[index(a)] = total;
    }

    void update_weight(const Edge& edge, double weight) {
        double n = 0.0;
        for_each_action(edge, [&n](ActionId, const Cell& cell) { n += static_cast<double>(cell.count()); });
        const double mean = pairs_.weight(edge);
        pairs_.set_weight(edge, n <= 1.0 ? weight : mean + (weight - mean) / n);
    }

    static constexpr std::size_t dense_actions = 8;

    std::size_t actions_;
    Pairs pairs_;
    detail::SparseCells<Cell> sparse_;  // of more actions
    bool plain_ = dense();              // and no weight but 1 so far
};

}  // namespace sspql
