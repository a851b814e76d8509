// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/core/random.hpp>
#include <sspql/model/transition_counts.hpp>
#include <sspql/paths/auto_queue.hpp>
#include <sspql/paths/cost_publisher.hpp>
#include <sspql/paths/reverse_graph.hpp>
#include <sspql/paths/shortest_paths.hpp>
#include <sspql/paths/ssp_values.hpp>
#include <sspql/spaces/legal_actions.hpp>

#include "duels/task.hpp"
#include "floors/clock.hpp"
#include "floors/grid_task.hpp"
#include "floors/slippery_grid.hpp"

/// \file
/// A learnt grid, and all that is derived from it after an episode in which everything changed.

namespace sspql::duels {

/// Counts of ten tries of every (s,a).
template <class Cell = CountCell>
TransitionCounts<Cell> learnt(const floors::SlipperyGrid& grid) {
    TransitionCounts<Cell> counts(grid.states(), floors::actions);
    grid.explore(tries, seed, [&](const floors::Step& t) {
        counts.record(StateId{t.state}, ActionId{t.action}, StateId{t.next}, t.terminated, t.reward);
    });
    return counts;
}

/// Every state changes: another try of one action, which does not slip.
template <class Cell>
void change_everything(const floors::SlipperyGrid& grid, TransitionCounts<Cell>& counts, Random& random) {
    for (std::uint32_t s = 0; s + 1 < grid.states(); ++s) {
        const auto action = static_cast<std::uint32_t>(random.below(4));
        counts.record(StateId{s}, ActionId{action}, StateId{grid.moved(s, action)});
    }
}

/// Refresh of the dirty states' costs, snapshot, search, Q_SSP.
class WholeSolve {
public:
    static constexpr std::array<const char*, 4> names{"refresh", "snapshot", "search", "Q_SSP"};

    explicit WholeSolve(const floors::SlipperyGrid& grid) : goals_{{state_id(grid.states() - 1), 0.0}} {}

    /// \returns the CPU seconds of each part.
    template <class Cell>
    std::array<double, 4> run(TransitionCounts<Cell>& counts) {
        return {floors::timed([&] { publisher_.publish(counts); }), floors::timed([&] { graph_.assign(counts); }),
                floors::timed([&] { shortest_paths_to(graph_, goals_, queue_, tree_); }),
                floors::timed([&] { values_.assign(counts, tree_, LegalActionTable{}); })};
    }

    [[nodiscard]] std::size_t edges() const { return graph_.edges(); }
    [[nodiscard]] const ShortestPathTree& tree() const { return tree_; }
    [[nodiscard]] const SspValues& values() const { return values_; }

private:
    std::vector<Goal> goals_;
    CostPublisher<> publisher_;
    ReverseGraph graph_;
    AutoQueue<> queue_;
    ShortestPathTree tree_;
    SspValues values_;
};

}  // namespace sspql::duels
