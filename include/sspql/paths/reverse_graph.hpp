// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <sspql/core/assert.hpp>
#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/model/prefetch.hpp>
#include <sspql/model/transition_counts.hpp>

/// \file
/// PredecessorGraph (concept), what searches towards a goal read:
///
///     std::size_t size() const                          number of states
///     void for_each_predecessor(StateId v, f) const     f(StateId u, double cost) for every edge u -> v
///     double least_cost() const, greatest_cost() const  bounds over all edges (0 and 0 without edges)

namespace sspql {

/// One edge of a graph of expected costs.
struct CostEdge {
    StateId from{};     ///< the edge leads from here
    StateId to{};       ///< to here
    double cost = 0.0;  ///< expected cost, finite and >= 0
};

/// A snapshot of the learnt graph with its edges reversed, in compressed rows: {offset, predecessor, cost}, row = the
/// state an edge leads to. A PredecessorGraph; with <sspql/paths/boost_graph.hpp> also a Boost.Graph graph (of the
/// reversed edges). Buffers are kept across assign(), so that renewing it allocates only when it grew.
///
/// Costs below 1e-30 of the largest are raised to that: a cost of zero would make cycles free.
/// Memory: 12 bytes an edge, 4 a state. Threads: const members may run together.
class ReverseGraph {
public:
    /// Costs below this times the largest are raised to it.
    static constexpr double least_ratio = 1e-30;

    /// No states.
    ReverseGraph() : offset_(1, 0) {}

    /// Takes over the labels of the counts, which must be published (no dirty states). O(n + m), about a tenth of a
    /// search.
    template <class Cell>
    void assign(const TransitionCounts<Cell>& counts) {
        SSPQL_ASSERT(counts.dirty().empty(), "publish costs before a snapshot");
        const std::size_t n = counts.states();
        offset_.resize(n + 1);
        predecessor_.resize(counts.pairs());
        cost_.resize(counts.pairs());
        std::uint32_t edge = 0;
        for (std::size_t v = 0; v < n; ++v) {
            offset_[v] = edge;
            counts.for_each_predecessor(state_id(v), [&](StateId u, double cost) {
                predecessor_[edge] = u;
                cost_[edge] = cost;
                ++edge;
            });
        }
        offset_[n] = edge;
        bound_costs();
    }

    /// A graph of `states` states from a list of edges; parallel edges and self-loops may occur.
    /// \throws std::invalid_argument for a state outside or a cost that is NaN, infinite or negative.
    [[nodiscard]] static ReverseGraph from_edges(std::size_t states, const std::vector<CostEdge>& edges) {
        if (states >= max_ids) throw_invalid("number of states", "stay below 4294967295", states);
        if (edges.size() >= max_ids) throw_invalid("number of edges", "stay below 4294967295", edges.size());
        ReverseGraph graph;
        graph.offset_.assign(states + 1, 0);
        for (const CostEdge& edge : edges) {
            if (index(edge.from) >= states || index(edge.to) >= states) {
                throw_invalid("states of an edge", "be below " + std::to_string(states),
                              std::max(index(edge.from), index(edge.to)));
            }
            require_not_negative("cost of an edge", edge.cost);
            ++graph.offset_[index(edge.to) + 1];
        }
        for (std::size_t v = 0; v < states; ++v) graph.offset_[v + 1] += graph.offset_[v];
        graph.predecessor_.resize(edges.size());
        graph.cost_.resize(edges.size());
        std::vector<std::uint32_t> place(graph.offset_.begin(), graph.offset_.end() - 1);
        for (const CostEdge& edge : edges) {
            const std::uint32_t at = place[index(edge.to)]++;
            graph.predecessor_[at] = edge.from;
            graph.cost_[at] = edge.cost;
        }
        graph.bound_costs();
        return graph;
    }

    /// The number of states, n.
    [[nodiscard]] std::size_t size() const noexcept { return offset_.size() - 1; }
    /// The number of edges, m.
    [[nodiscard]] std::size_t edges() const noexcept { return predecessor_.size(); }

    /// Calls f(StateId u, double cost) for every edge u -> v. O(in-degree).
    template <class F>
    void for_each_predecessor(StateId v, F&& f) const {
        // Local pointers: what f writes might be these members, for all that a compiler knows.
        const StateId* const predecessor = predecessor_.data();
        const double* const cost = cost_.data();
        const std::uint32_t end = offset_[index(v) + 1];
        for (std::uint32_t i = offset_[index(v)]; i < end; ++i) f(predecessor[i], cost[i]);
    }

    /// Asks for the memory that says where the edges into v begin: soon to be read.
    void prefetch_offset(StateId v) const noexcept { detail::prefetch(&offset_[index(v)]); }
    /// Asks for the edges into v, once what prefetch_offset asked for is there.
    void prefetch_edges(StateId v) const noexcept {
        detail::prefetch(predecessor_.data() + offset_[index(v)]);
        detail::prefetch(cost_.data() + offset_[index(v)]);
    }

    /// The least cost of all edges; 0 without edges.
    [[nodiscard]] double least_cost() const noexcept { return least_; }
    /// The greatest cost of all edges; 0 without edges.
    [[nodiscard]] double greatest_cost() const noexcept { return greatest_; }

    /// The edges into v are those numbered begin(v) to end(v) - 1, end(v) - begin(v) of them.
    [[nodiscard]] std::uint32_t begin(StateId v) const noexcept { return offset_[index(v)]; }
    /// Past the last edge into v.
    [[nodiscard]] std::uint32_t end(StateId v) const noexcept { return offset_[index(v) + 1]; }
    /// The state that an edge leads from.
    [[nodiscard]] StateId predecessor(std::uint32_t edge) const noexcept { return predecessor_[edge]; }
    /// The expected cost of an edge.
    [[nodiscard]] double cost(std::uint32_t edge) const noexcept { return cost_[edge]; }

private:
    void bound_costs() noexcept {
        least_ = 0.0;
        greatest_ = 0.0;
        if (cost_.empty()) return;
        const auto [low, high] = std::minmax_element(cost_.begin(), cost_.end());
        least_ = *low;
        greatest_ = *high;
        const double floor = std::max(greatest_ * least_ratio, std::numeric_limits<double>::min());
        if (least_ >= floor) return;
        for (double& cost : cost_) cost = std::max(cost, floor);
        least_ = floor;
        greatest_ = std::max(greatest_, floor);
    }

    std::vector<std::uint32_t> offset_;
    std::vector<StateId> predecessor_;
    std::vector<double> cost_;
    double least_ = 0.0;
    double greatest_ = 0.0;
};

}  // namespace sspql
