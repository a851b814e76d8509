// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <unordered_map>
#include <vector>

#include <sspql/core/assert.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/model/edge_weights.hpp>
#include <sspql/model/neighbours.hpp>
#include <sspql/model/prefetch.hpp>
#include <sspql/model/state_bodies.hpp>

namespace sspql::detail {

/// Which states follow which: the skeleton under TransitionCounts.
///
/// The slot of a successor is its place among the predecessors there, so that a cost can be written where searches read
/// it, without looking for it. Besides: one mean weight per (s, s'), and the list of dirty states, those whose
/// successors changed since somebody cleared them. Where it all lies: StateBodies.
///
/// find is O(out-degree) up to 32 successors and O(1) expected beyond (hash index for those states only), insert O(1)
/// amortised, erase O(out-degrees involved).
template <class Number>
class Adjacency {
public:
    static constexpr std::uint32_t none = 0xFFFFFFFFu;
    static constexpr std::uint32_t hub_degree = 32;

    /// (s, s'), valid until the next insert or erase.
    struct Edge {
        Successors block;
        std::uint32_t at = 0;     // in the block
        std::uint32_t place = 0;  // among all successors of s
        StateId from{};           // s
    };

    /// \param rows rows of cells in a block of successors; \param cell bytes of a cell.
    Adjacency(std::size_t actions, std::size_t rows, std::size_t cell) : bodies_(actions, rows, cell) {}

    [[nodiscard]] std::size_t states() const noexcept { return bodies_.states(); }

    void grow(std::size_t states) {
        bodies_.grow(states);
        if (has_weights()) weights_.fit(bodies_);
    }

    /// Room for `states` states and `pairs` distinct (s, s') without allocating.
    void reserve(std::size_t states, std::size_t pairs) {
        bodies_.reserve(states, pairs);
        dirty_.reserve(states);
        if (has_weights()) weights_.reserve(bodies_);
    }

    // --- states ---

    /// N(s,0), N(s,1), ...
    [[nodiscard]] Number* totals(StateId s) const noexcept { return bodies_.totals(s); }

    [[nodiscard]] std::uint32_t out_size(StateId s) const noexcept { return head(s)->out_size; }
    [[nodiscard]] std::uint32_t in_size(StateId s) const noexcept { return head(s)->in_size; }

    /// Has what is known of s and row number `row` of its first successors fetched.
    void prefetch(StateId s, std::size_t row) const noexcept {
        const Head* of_s = head(s);
        detail::prefetch(of_s);
        const std::byte* cells = bodies_.inner_out(of_s).row(row, cell());
        detail::prefetch(cells);
        detail::prefetch(cells + inner_size * cell() - 1);
    }

    // --- successors ---

    /// The place of next among the successors of s, or `none`.
    [[nodiscard]] std::uint32_t find(StateId s, StateId next) const noexcept {
        const std::uint32_t place = find_inner(s, next);
        return place != none || head(s)->out_size <= inner_size ? place : find_outer(s, next);
    }

    /// The same, in the body only.
    [[gnu::always_inline, nodiscard]] std::uint32_t find_inner(StateId s, StateId next) const noexcept {
        const std::uint32_t* target = bodies_.inner_out(head(s)).targets;
        const std::uint32_t wanted = Successors::target(next);
        // Four without a branch: which one it is nobody can predict. Unused places hold no state.
        const auto last = static_cast<std::uint32_t>(target[3] == wanted);
        const std::uint32_t place = (static_cast<std::uint32_t>(target[1] == wanted) | last) +
                                    2u * (static_cast<std::uint32_t>(target[2] == wanted) | last);
        return target[place] == wanted ? place : none;
    }

    /// The successors within the body.
    [[nodiscard]] Successors inner_successors(StateId s) const noexcept { return bodies_.inner_out(head(s)); }

    /// Adds (s, next), which must be absent, with cells of zeros, weight 1 and a label that no search may read yet.
    /// \returns its place.
    std::uint32_t insert(StateId s, StateId next) {
        Head* to = head(next);
        if (bodies_.in_full(to)) bodies_.enlarge_in(to);
        return append(s, next, to->in_size++);
    }

    /// Removes the successor of s at this place, and s from its predecessors. The last successor takes its place.
    void erase(StateId s, std::uint32_t place) {
        Head* of_s = head(s);
        const Edge gone = edge(s, place);
        const StateId next = gone.block.state(gone.at);
        erase_in(next, gone.block.slots()[gone.at]);
        const std::uint32_t last_place = of_s->out_size - 1;
        const Edge last = edge(s, last_place);
        const bool hub = of_s->out_size > hub_degree;
        if (hub) hubs_.erase(key(s, next));
        if (place != last_place) {
            gone.block.targets[gone.at] = last.block.targets[last.at];
            gone.block.slots()[gone.at] = last.block.slots()[last.at];
            for (std::size_t r = 0; r < bodies_.rows(); ++r) {
                std::memcpy(gone.block.cell(r, gone.at, cell()), last.block.cell(r, last.at, cell()), cell());
            }
            if (has_weights()) set_weight(gone, weight(last));
            if (hub) hubs_[key(s, gone.block.state(gone.at))] = place;
        }
        last.block.targets[last.at] = 0;
        of_s->out_size = last_place & 0x7FFFFFFFu;
        if (hub && last_place == hub_degree) {
            for_each_edge(s, [&](const Edge& edge) { hubs_.erase(key(s, edge.block.state(edge.at))); });
        }
        --pairs_;
        ++erasures_;
    }

    [[gnu::always_inline, nodiscard]] Edge edge(StateId s, std::uint32_t place) const noexcept {
        const Head* of_s = head(s);
        if (place < inner_size) return {bodies_.inner_out(of_s), place, place, s};
        return {bodies_.outer_out(of_s), place - inner_size, place, s};
    }

    /// Calls f(const Successors& block, size, place of the first) for the blocks of the successors of s.
    template <class F>
    [[gnu::always_inline]] void for_each_block(StateId s, F&& f) const {
        const Head* of_s = head(s);
        const std::uint32_t size = of_s->out_size;
        Successors block = bodies_.inner_out(of_s);
        for (std::uint32_t begin = 0, end = std::min(size, inner_size);;) {
            f(static_cast<const Successors&>(block), end - begin, begin);
            if (end == size) return;
            block = bodies_.outer_out(of_s);
            begin = end;
            end = size;
        }
    }

    /// Calls f(const Edge&) for every successor of s, by place.
    template <class F>
    void for_each_edge(StateId s, F&& f) const {
        for_each_block(s, [&](const Successors& block, std::uint32_t size, std::uint32_t first) {
            for (std::uint32_t i = 0; i < size; ++i) f(Edge{block, i, first + i, s});
        });
    }

    // --- predecessors ---

    /// Calls f(StateId predecessor, double label) for every predecessor of s.
    template <class F>
    void for_each_predecessor(StateId s, F&& f) const {
        const Head* of_s = head(s);
        std::uint32_t left = of_s->in_size;
        Predecessors block = bodies_.inner_in(of_s);
        for (std::uint32_t size = std::min(left, inner_size);; size = left) {
            const double* label = block.labels();
            for (std::uint32_t i = 0; i < size; ++i) f(StateId{block.from[i]}, label[i]);
            left -= size;
            if (left == 0) return;
            block = bodies_.outer_in(of_s);
        }
    }

    [[nodiscard]] double& label(const Edge& edge) const noexcept {
        const StateId next = edge.block.state(edge.at);
        const auto [block, at] = in_at(head(next), edge.block.slots()[edge.at]);
        return block.labels()[at];
    }

    // --- weights ---

    [[nodiscard]] double weight(const Edge& edge) const noexcept {
        return has_weights() ? weights_.at(bodies_, edge.from, edge.place) : 1.0;
    }

    void set_weight(const Edge& edge, double value) {
        if (!has_weights()) {
            weights_.reserve(bodies_);  // what was reserved holds for weights, too
            weights_.fit(bodies_);
        }
        weights_.at(bodies_, edge.from, edge.place) = value;
    }

    [[nodiscard]] bool has_weights() const noexcept { return !weights_.empty(); }

    // --- dirty states ---

    void mark_dirty(StateId s) {
        Head* of_s = head(s);
        if (of_s->dirty != 0) return;
        dirty_.push_back(s);
        of_s->dirty = 1;
    }

    [[nodiscard]] const std::vector<StateId>& dirty() const noexcept { return dirty_; }

    void clear_dirty() noexcept {
        for (const StateId s : dirty_) head(s)->dirty = 0;
        dirty_.clear();
    }

    [[nodiscard]] std::size_t pairs() const noexcept { return pairs_; }
    [[nodiscard]] std::uint64_t erasures() const noexcept { return erasures_; }

    [[nodiscard]] std::size_t bytes() const noexcept {
        return bodies_.bytes() + weights_.bytes() + dirty_.capacity() * sizeof(StateId) +
               hubs_.size() * 3 * sizeof(std::uint64_t) + hubs_.bucket_count() * sizeof(void*);
    }

private:
    template <class>
    friend struct CountsArchive;

    using Bodies = StateBodies<Number>;
    using Head = typename Bodies::Head;
    static constexpr std::uint32_t inner_size = Bodies::inner_size;

    static std::uint64_t key(StateId s, StateId next) noexcept {
        return (static_cast<std::uint64_t>(s) << 32) | static_cast<std::uint64_t>(next);
    }

    [[nodiscard]] Head* head(StateId s) const noexcept { return bodies_.head(s); }
    [[nodiscard]] std::size_t cell() const noexcept { return bodies_.cell(); }

    /// insert() where the predecessors of `next` have room at `slot`. \throws std::length_error with 2^30 successors.
    std::uint32_t append(StateId s, StateId next, std::uint32_t slot) {
        Head* from = head(s);
        const std::uint32_t place = from->out_size;
        if (bodies_.out_full(from)) enlarge_out(from);
        if (place >= hub_degree) index_hub(s, next);
        from->out_size = (place + 1) & 0x7FFFFFFFu;
        const Edge edge = this->edge(s, place);
        edge.block.set(edge.at, next);
        edge.block.slots()[edge.at] = slot;
        for (std::size_t r = 0; r < bodies_.rows(); ++r) std::memset(edge.block.cell(r, edge.at, cell()), 0, cell());
        if (has_weights()) set_weight(edge, 1.0);
        const auto [block, at] = in_at(head(next), slot);
        block.from[at] = static_cast<std::uint32_t>(s);
        block.labels()[at] = std::numeric_limits<double>::quiet_NaN();
        ++pairs_;
        return place;
    }

    struct InPlace {
        Predecessors block;
        std::uint32_t at;
    };
    [[nodiscard]] InPlace in_at(const Head* of_s, std::uint32_t slot) const noexcept {
        if (slot < inner_size) return {bodies_.inner_in(of_s), slot};
        return {bodies_.outer_in(of_s), slot - inner_size};
    }

    [[gnu::noinline, nodiscard]] std::uint32_t find_outer(StateId s, StateId next) const noexcept {
        const Head* of_s = head(s);
        if (of_s->out_size > hub_degree) {
            const auto found = hubs_.find(key(s, next));
            return found == hubs_.end() ? none : found->second;
        }
        const Successors block = bodies_.outer_out(of_s);
        for (std::uint32_t i = 0; i < of_s->out_size - inner_size; ++i) {
            if (block.targets[i] == Successors::target(next)) return inner_size + i;
        }
        return none;
    }

    void enlarge_out(Head* of_s) {
        const std::uint32_t size = of_s->out_size - inner_size;
        const std::uint32_t old = of_s->out_more;
        bodies_.enlarge_out(of_s);
        if (has_weights()) weights_.move(bodies_, old, of_s->out_more, size);
    }

    /// (s, next) is about to become the successor number out_size, at or past the degree from which a hash finds it.
    void index_hub(StateId s, StateId next) {
        const std::uint32_t size = out_size(s);
        if (size == hub_degree) {
            for_each_edge(s, [&](const Edge& edge) { hubs_[key(s, edge.block.state(edge.at))] = edge.place; });
        }
        hubs_[key(s, next)] = size;
    }

    void erase_in(StateId s, std::uint32_t slot) {
        Head* of_s = head(s);
        const std::uint32_t last_slot = of_s->in_size - 1;
        of_s->in_size = last_slot;
        if (slot == last_slot) return;
        const auto [to, at] = in_at(of_s, slot);
        const auto [from, last] = in_at(of_s, last_slot);
        to.from[at] = from.from[last];
        to.labels()[at] = from.labels()[last];
        const StateId other{to.from[at]};
        const Edge moved = edge(other, find(other, s));
        moved.block.slots()[moved.at] = slot;
    }

    Bodies bodies_;
    EdgeWeights<Number> weights_;
    std::vector<StateId> dirty_;
    std::unordered_map<std::uint64_t, std::uint32_t> hubs_;
    std::size_t pairs_ = 0;
    std::uint64_t erasures_ = 0;
};

}  // namespace sspql::detail
