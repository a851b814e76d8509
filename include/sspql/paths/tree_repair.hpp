// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include <sspql/core/assert.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/model/transition_counts.hpp>
#include <sspql/paths/published_changes.hpp>
#include <sspql/paths/queue.hpp>
#include <sspql/paths/shortest_paths.hpp>

namespace sspql {

/// Brings a tree of shortest paths up to date after some costs changed, touching only the states whose path changes
/// (after Ramalingam and Reps 1996, in two phases):
///
/// 1. Mark. The states below a tree edge that worsened or is gone lose their paths; nobody else's can become longer.
/// 2. Solve. Marked states start from their unmarked successors, improved edges from their origin, and one Dijkstra
///    search over those settles whoever is marked or gets nearer.
///
/// The result is the one tree that shortest_paths_to finds, bit for bit: distances are the same minima of the same
/// sums, next(s) the least state among the best, a goal's own offset first. This needs costs that no distance absorbs
/// (d + c > d); where one does, repair gives up. It also gives up when more than `most` states are marked: a search
/// from scratch costs less per state.
///
/// Labels are read in place, so nothing is proportional to the size of the graph. O(m' + n' log n') with n' states
/// marked or improved and m' edges at them. No allocation but for the growth of buffers kept.
class TreeRepair {
public:
    /// \param changes what was published since `tree` was right, complete, with no cost below the floor of
    /// ReverseGraph.
    /// \param lost states whose edge to next(s) was erased since.
    /// \param goals those of `tree`, whose size is the number of states.
    /// \param least_cost a lower bound on the labels, for the queue. \param greatest_cost an upper one.
    /// \returns false if it gave up; `tree` is undefined then.
    template <class Cell, class Queue>
    bool repair(const TransitionCounts<Cell>& counts, const PublishedChanges& changes, const std::vector<StateId>& lost,
                const std::vector<Goal>& goals, double least_cost, double greatest_cost, std::size_t most, Queue& queue,
                ShortestPathTree& tree) {
        SSPQL_ASSERT(changes.complete() && tree.size() == counts.states(), "repair knows all that changed");
        work_ = SearchWork{};
        begin(tree.size());
        if (!mark(counts, changes, lost, most, tree)) return false;
        queue.prepare(tree.size(), least_cost, greatest_cost);
        return detail::with_chosen(queue, [&](auto& chosen) {
            Search<std::decay_t<decltype(chosen)>> search{chosen, tree.distance.data(), tree.next.data(), flag_.data(),
                                                          states_};
            seed_marked(counts, goals, search);
            for (const CostChange& change : changes.edges()) {
                if (is_marked(change.from) || is_marked(change.to)) continue;
                search.relax(change.from, change.to, tree.distance[index(change.to)], change.new_cost);
            }
            settle_all(counts, search);
            return !search.absorbed;
        });
    }

    /// After a successful repair: every state whose distance or next state may have changed, once each.
    [[nodiscard]] const std::vector<StateId>& states() const noexcept { return states_; }

    /// What the last repair did, marking included, successful or not.
    [[nodiscard]] const SearchWork& work() const noexcept { return work_; }

    /// No state changed.
    void clear() noexcept {
        for (const StateId s : states_) flag_[index(s)] = 0;
        states_.clear();
    }

    /// Room for that many states.
    void reserve(std::size_t states) {
        flag_.reserve(states);
        states_.reserve(states);
    }

private:
    static constexpr std::uint8_t seen = 1;    // listed in states_
    static constexpr std::uint8_t marked = 2;  // lost its path
    static constexpr std::uint8_t queued = 4;  // queued in this repair, now or before

    void begin(std::size_t n) {
        clear();
        if (flag_.size() < n) flag_.resize(n, 0);
    }

    [[nodiscard]] bool is_marked(StateId s) const noexcept { return (flag_[index(s)] & marked) != 0; }

    void mark(StateId s) {
        if (is_marked(s)) return;
        flag_[index(s)] = seen | marked;
        states_.push_back(s);
    }

    /// Phase 1. states_ holds the marked states: first those whose own edge is worse, then, level by level, those
    /// below.
    template <class Cell>
    bool mark(const TransitionCounts<Cell>& counts, const PublishedChanges& changes, const std::vector<StateId>& lost,
              std::size_t most, const ShortestPathTree& tree) {
        for (const StateId s : lost) mark(s);
        for (const CostChange& change : changes.edges()) {
            const std::size_t s = index(change.from);
            const double through = tree.distance[index(change.to)] + change.new_cost;
            if (tree.next[s] == change.to && through > tree.distance[s]) mark(change.from);
        }
        const StateId* const next = tree.next.data();
        const std::uint8_t* const flag = flag_.data();
        std::size_t edges = 0;
        for (std::size_t i = 0; i < states_.size() && states_.size() <= most; ++i) {
            const StateId v = states_[i];
            counts.for_each_predecessor(v, [&](StateId u, double) {
                ++edges;
                if (next[index(u)] == v && flag[index(u)] == 0) mark(u);
            });
        }
        work_.edges += edges;
        return states_.size() <= most;
    }

    /// The tree under repair and the queue. Plain pointers: a write to a flag might be one to a vector's members, for
    /// all that a compiler knows.
    template <class Queue>
    struct Search {
        Queue& queue;
        double* distance;
        StateId* next;
        std::uint8_t* flag;
        std::vector<StateId>& states;
        bool absorbed = false;

        void relax(StateId u, StateId v, double here, double cost) {
            const double through = here + cost;
            const double before = distance[index(u)];
            if (through < before) {
                absorbed = absorbed || through == here;
                improve(u, through, v);
            } else if (through == before && here < before && next[index(u)] != no_state && v < next[index(u)]) {
                next[index(u)] = v;
                list(seen, u);
            }
        }

        void improve(StateId u, double to, StateId v) {
            distance[index(u)] = to;
            next[index(u)] = v;
            if ((flag[index(u)] & queued) != 0) {
                queue.decrease(static_cast<std::uint32_t>(u), to);
            } else {
                list(seen | queued, u);
                queue.push(static_cast<std::uint32_t>(u), to);
            }
        }

        void list(int flags, StateId u) {
            if (flag[index(u)] == 0) states.push_back(u);
            flag[index(u)] = static_cast<std::uint8_t>(flag[index(u)] | flags);
        }
    };

    /// The marked states, which are all that is listed so far, lose their paths and get the best one that leads over an
    /// unmarked successor, if there is one.
    template <class Cell, class AnySearch>
    void seed_marked(const TransitionCounts<Cell>& counts, const std::vector<Goal>& goals, AnySearch& search) {
        const std::size_t count = states_.size();
        if (count == 0) return;
        for (const StateId s : states_) {
            search.distance[index(s)] = std::numeric_limits<double>::infinity();
            search.next[index(s)] = no_state;
        }
        for (const Goal& goal : goals) {
            if (is_marked(goal.state) && goal.offset < search.distance[index(goal.state)]) {
                search.improve(goal.state, goal.offset, no_state);
            }
        }
        std::size_t edges = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const StateId s = states_[i];
            counts.for_each_successor(s, [&](const auto& successor) {
                ++edges;
                const StateId v = successor.state();
                if ((search.flag[index(v)] & marked) != 0) return;
                search.relax(s, v, search.distance[index(v)], successor.label());
            });
        }
        work_.edges += edges;
    }

    /// Phase 2.
    template <class Cell, class AnySearch>
    void settle_all(const TransitionCounts<Cell>& counts, AnySearch& search) {
        std::size_t edges = 0;
        while (!search.queue.empty() && !search.absorbed) {
            const StateId v{search.queue.pop()};
            const double here = search.distance[index(v)];
            ++work_.states;
            counts.for_each_predecessor(v, [&](StateId u, double cost) {
                ++edges;
                search.relax(u, v, here, cost);
            });
        }
        work_.edges += edges;
    }

    std::vector<std::uint8_t> flag_;
    std::vector<StateId> states_;
    SearchWork work_;
};

}  // namespace sspql
