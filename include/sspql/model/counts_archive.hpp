// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/model/adjacency.hpp>
#include <sspql/model/sparse_cells.hpp>
#include <sspql/model/transition_counts.hpp>

namespace sspql::detail {

/// How TransitionCounts is written and read (core/serialization.hpp). What decides about its behaviour is kept: the order
/// of successors and of predecessors, labels, weights, the dirty list; where blocks lie in memory is not.
///
///     the cell's name; states, actions; distinct (s,s'); erasures; whether there are weights
///     in-degree of every state (4 bytes each)
///     for every state: out-degree; if > 0: N(s,a) for all a, then its edges: s', place among the predecessors of s',
///         label, weight (if there are weights), cells: one per action, or, beyond 8 actions, their number and
///         (action, cell) pairs
///     the dirty states
template <class Cell>
struct CountsArchive {
    using Counts = TransitionCounts<Cell>;
    using Number = typename Cell::Number;
    using Pairs = Adjacency<Number>;
    using Edge = typename Pairs::Edge;
    using Handle = typename SparseCells<Cell>::Handle;

    template <class Archive>
    static void serialize(Counts& counts, Archive& archive) {
        archive.tag("cell", Cell::type_name);
        Pairs& pairs = counts.pairs_;
        std::size_t states = counts.states();
        std::size_t actions = counts.actions();
        std::size_t edges = pairs.pairs_;
        bool weighted = pairs.has_weights();
        archive.size(states);
        archive.size(actions);
        archive.size(edges);
        archive(pairs.erasures_, weighted);
        archive.require(states == counts.states() && actions == counts.actions(), "counts have another size");
        if constexpr (Archive::loading) {
            archive.require(edges <= archive.left() / 20, "there are more edges than the file has room for");
            if (weighted) pairs.weights_.fit(pairs.bodies_);
            counts.plain_ = counts.dense() && !weighted;
        }
        predecessors(pairs, archive, edges);
        for (std::size_t s = 0; s < states; ++s) state(counts, archive, state_id(s), edges, weighted);
        archive.require(pairs.pairs_ == edges, "an edge is missing");
        dirty(pairs, archive);
    }

private:
    template <class Archive>
    static void predecessors(Pairs& pairs, Archive& archive, std::size_t edges) {
        std::uint64_t sum = 0;
        for (std::size_t s = 0; s < pairs.states(); ++s) {
            auto* head = pairs.head(state_id(s));
            std::uint32_t degree = head->in_size;
            archive(degree);
            if constexpr (!Archive::loading) continue;
            sum += degree;
            archive.require(sum <= edges, "there are more predecessors than edges");
            for (; head->in_size < degree; ++head->in_size) {
                if (pairs.bodies_.in_full(head)) pairs.bodies_.enlarge_in(head);
                const auto [block, at] = pairs.in_at(head, head->in_size);
                block.from[at] = static_cast<std::uint32_t>(no_state);  // until its edge comes
            }
        }
        if constexpr (Archive::loading) archive.require(sum == edges, "there are fewer predecessors than edges");
    }

    template <class Archive>
    static void state(Counts& counts, Archive& archive, StateId s, std::size_t edges, bool weighted) {
        Pairs& pairs = counts.pairs_;
        std::uint32_t degree = pairs.out_size(s);
        archive(degree);
        if (degree == 0) return;
        archive.require(degree <= counts.states(), "a state has too many successors");
        for (std::size_t a = 0; a < counts.actions(); ++a) archive(pairs.totals(s)[a]);
        for (std::uint32_t place = 0; place < degree; ++place) {
            StateId next{};
            std::uint32_t slot = 0;
            if constexpr (!Archive::loading) {
                const Edge edge = pairs.edge(s, place);
                next = edge.block.state(edge.at);
                slot = edge.block.slots()[edge.at];
            }
            archive(next, slot);
            if constexpr (Archive::loading) {
                archive.require(pairs.pairs_ < edges && index(next) < counts.states() && pairs.find(s, next) == Pairs::none,
                                "an edge is wrong");
                const auto* to = pairs.head(next);
                archive.require(slot < to->in_size, "an edge is not among the predecessors");
                const auto [block, at] = pairs.in_at(to, slot);
                archive.require(block.from[at] == static_cast<std::uint32_t>(no_state), "two edges have one place");
                pairs.append(s, next, slot);
            }
            const Edge edge = pairs.edge(s, place);
            archive(pairs.label(edge));
            if (weighted) weight(pairs, archive, edge);
            cells(counts, archive, edge);
        }
        for (std::size_t a = 0; Archive::loading && a < counts.actions(); ++a) {
            archive.require(adds_up(counts, s, action_id(a)), "a total is not the sum of its counts");
        }
    }

    template <class Archive>
    static void weight(Pairs& pairs, Archive& archive, const Edge& edge) {
        double weight = pairs.weight(edge);
        archive(weight);
        archive.require(weight >= min_weight && weight <= max_weight, "a weight is out of range");
        if constexpr (Archive::loading) pairs.set_weight(edge, weight);
    }

    template <class Archive>
    static void cells(Counts& counts, Archive& archive, const Edge& edge) {
        if (counts.dense()) {
            for (std::size_t a = 0; a < counts.actions(); ++a) archive(*Counts::dense_cell(edge.block, edge.at, action_id(a)));
            return;
        }
        Handle& handle = Counts::handle(edge.block, edge.at);
        std::uint32_t size = handle.size;
        archive(size);
        archive.require(size <= counts.actions(), "an edge has too many actions");
        for (std::uint32_t i = 0; i < size; ++i) {
            ActionId a{};
            if constexpr (!Archive::loading) a = counts.sparse_.action(handle, i);
            archive(a);
            archive.require(index(a) < counts.actions(), "there is no such action");
            if constexpr (Archive::loading) {
                archive.require(counts.sparse_.find(handle, a) == nullptr, "an action comes twice");
            }
            archive(counts.sparse_.touch(handle, a));
        }
    }

    /// Faded counts are summed up in another order than they were added.
    static bool adds_up(const Counts& counts, StateId s, ActionId a) {
        double sum = 0.0;
        counts.for_each_n(s, a, [&](Number n) { sum += static_cast<double>(n); });
        const auto told = static_cast<double>(counts.n(s, a));
        if constexpr (std::is_integral_v<Number>) return told == sum;
        return std::fabs(told - sum) <= 1e-6 * sum;
    }

    template <class Archive>
    static void dirty(Pairs& pairs, Archive& archive) {
        std::vector<StateId> states = pairs.dirty();
        archive(states);
        if constexpr (Archive::loading) {
            for (const StateId s : states) {
                archive.require(index(s) < pairs.states() && pairs.head(s)->dirty == 0, "the list of dirty states is wrong");
                pairs.mark_dirty(s);
            }
        }
    }
};

}  // namespace sspql::detail
