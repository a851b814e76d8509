// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <sspql/core/assert.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/core/step_budget.hpp>
#include <sspql/model/transition_counts.hpp>
#include <sspql/paths/queue.hpp>
#include <sspql/paths/reverse_graph.hpp>
#include <sspql/paths/shortest_paths.hpp>

namespace sspql {

/// shortest_paths_to in instalments, for callers that must answer in time: each call of advance() spends what is in a
/// StepBudget and at most one state's edges more, first on a snapshot of the labels, then on the search over it.
/// Records may be made between calls; edges that have no label yet do not exist for the snapshot. The labels must not
/// be rewritten before the snapshot is taken.
///
/// The tree is that of shortest_paths_to over the same labels, bit for bit, wherever that does not depend on the queue.
/// A touch is an edge copied or looked at; each state costs one more per pass. What the queue does for a state is not
/// counted, and neither is growing memory: reserve() what will be needed. No recursion.
/// Memory: 12 bytes an edge, 16 and the queue's a state.
template <class Queue>
class ResumableSearch {
    static_assert(detail::QueueRequirements<Queue>::met);

public:
    /// Begins a search over the states there are now, dropping an unfinished one. O(number of goals).
    /// \throws std::invalid_argument for a goal outside or an offset that is not finite and >= 0; an unfinished search
    /// goes on then.
    template <class Cell>
    void start(const TransitionCounts<Cell>& counts, const std::vector<Goal>& goals) {
        detail::require_goals(goals, counts.states());
        goals_ = goals;
        states_ = counts.states();
        offset_.clear();
        predecessor_.clear();
        cost_.clear();
        tree_.distance.clear();
        tree_.next.clear();
        make_room(states_, counts.pairs());
        offset_.push_back(0);
        least_ = std::numeric_limits<double>::infinity();
        greatest_ = 0.0;
        work_ = SearchWork{};
        phase_ = Phase::snapshot;
    }

    /// Whether a search is under way: started, and neither complete nor stopped.
    [[nodiscard]] bool running() const noexcept { return phase_ != Phase::idle; }

    /// Goes on until the budget is spent. \returns true when the tree is complete, from then on until the next start().
    template <class Cell>
    bool advance(const TransitionCounts<Cell>& counts, StepBudget& budget) {
        if (phase_ == Phase::snapshot) take_snapshot(counts, budget);
        if (phase_ == Phase::search) search(budget);
        return phase_ == Phase::idle;
    }

    /// Drops a search under way.
    void stop() noexcept { phase_ = Phase::idle; }

    /// The tree, once complete; to be swapped with the one in use.
    [[nodiscard]] ShortestPathTree& tree() noexcept { return tree_; }
    /// The same for reading.
    [[nodiscard]] const ShortestPathTree& tree() const noexcept { return tree_; }

    /// Of the last search: states settled, edges copied and looked at.
    [[nodiscard]] const SearchWork& work() const noexcept { return work_; }

    /// Room for a search over that many without allocating.
    void reserve(std::size_t states, std::size_t edges) {
        make_room(states, edges);
        queue_.prepare(states, 0.0, 0.0);
    }

private:
    friend SerializationAccess;

    enum class Phase : std::uint8_t { idle, snapshot, search };

    /// A finished tree is written whole, a search under way as its snapshot and the number of states settled: reading
    /// makes the same search again up to there.
    template <class Archive, class Cell>
    void serialize(Archive& archive, const TransitionCounts<Cell>& counts) {
        archive(phase_);
        archive.require(phase_ <= Phase::search, "there is no such phase of a search");
        if (phase_ == Phase::idle) return SerializationAccess::serialize(tree_, archive, counts.states());
        std::size_t seen = tree_.size();
        archive(goals_, offset_, predecessor_, cost_);
        archive.size(states_);
        archive.size(seen);
        archive.size(work_.states);
        if constexpr (Archive::loading) resume(archive, counts.states(), seen);
    }

    template <class Archive>
    void resume(Archive& archive, std::size_t states, std::size_t seen) {
        detail::require_goals(goals_, states_);
        archive.require(states_ <= states && seen <= states_ && offset_.size() == seen + 1 && offset_[0] == 0 &&
                            offset_.back() == cost_.size() && predecessor_.size() == cost_.size() &&
                            std::is_sorted(offset_.begin(), offset_.end()) && (phase_ == Phase::snapshot || seen == states_),
                        "a snapshot is incomplete");
        least_ = std::numeric_limits<double>::infinity();
        greatest_ = 0.0;
        for (std::size_t i = 0; i < cost_.size(); ++i) {
            archive.require(index(predecessor_[i]) < states_ && cost_[i] >= 0.0 && cost_[i] <= 1e300, "an edge is wrong");
            least_ = std::min(least_, cost_[i]);
            greatest_ = std::max(greatest_, cost_[i]);
        }
        make_room(states_, cost_.size());
        tree_.distance.assign(seen, std::numeric_limits<double>::infinity());
        tree_.next.assign(seen, no_state);
        work_.edges = cost_.size();
        if (phase_ == Phase::snapshot) return;
        const std::size_t settled = work_.states;
        work_.states = 0;
        begin_search();
        while (work_.states < settled) {
            archive.require(!queue_.empty(), "a search went further than it could");
            settle_one();
        }
    }

    void make_room(std::size_t states, std::size_t edges) {
        offset_.reserve(states + 1);
        predecessor_.reserve(edges);
        cost_.reserve(edges);
        tree_.distance.reserve(states);
        tree_.next.reserve(states);
    }

    template <class Cell>
    void take_snapshot(const TransitionCounts<Cell>& counts, StepBudget& budget) {
        for (; tree_.distance.size() < states_; budget.spend(1)) {
            if (budget.exhausted()) return;
            const std::size_t before = cost_.size();
            const StateId v = state_id(tree_.distance.size());
            counts.for_each_predecessor(v, [&](StateId u, double cost) {
                if (cost != cost) return;
                predecessor_.push_back(u);
                cost_.push_back(cost);
                least_ = std::min(least_, cost);
                greatest_ = std::max(greatest_, cost);
            });
            offset_.push_back(static_cast<std::uint32_t>(cost_.size()));
            tree_.distance.push_back(std::numeric_limits<double>::infinity());
            tree_.next.push_back(no_state);
            work_.edges += cost_.size() - before;
            budget.spend(counts.in_degree(v));
        }
        begin_search();
    }

    void begin_search() {
        floor_ = std::max(greatest_ * ReverseGraph::least_ratio, std::numeric_limits<double>::min());
        queue_.prepare(states_, std::max(least_, floor_), std::max(greatest_, floor_));
        for (const Goal& goal : goals_) {
            if (goal.offset < tree_.distance[index(goal.state)]) improve(goal.state, goal.offset, no_state);
        }
        phase_ = Phase::search;
    }

    void search(StepBudget& budget) {
        while (!queue_.empty()) {
            if (budget.exhausted()) return;
            budget.spend(settle_one() + 1);
        }
        phase_ = Phase::idle;
    }

    /// \returns the edges looked at.
    std::uint32_t settle_one() {
        const StateId v{queue_.pop()};
        const double here = tree_.distance[index(v)];
        const std::uint32_t begin = offset_[index(v)];
        const std::uint32_t end = offset_[index(v) + 1];
        for (std::uint32_t i = begin; i < end; ++i) relax(predecessor_[i], v, here, std::max(cost_[i], floor_));
        ++work_.states;
        work_.edges += end - begin;
        return end - begin;
    }

    void relax(StateId u, StateId v, double here, double cost) {
        const double through = here + cost;
        const double distance = tree_.distance[index(u)];
        if (through < distance) {
            improve(u, through, v);
        } else if (through == distance && here < distance) {
            StateId& next = tree_.next[index(u)];
            if (next != no_state && v < next) next = v;
        }
    }

    void improve(StateId u, double distance, StateId next) {
        double& best = tree_.distance[index(u)];
        const bool known = best < std::numeric_limits<double>::infinity();
        best = distance;
        tree_.next[index(u)] = next;
        if (known) {
            queue_.decrease(static_cast<std::uint32_t>(u), distance);
        } else {
            queue_.push(static_cast<std::uint32_t>(u), distance);
        }
    }

    std::vector<std::uint32_t> offset_;
    std::vector<StateId> predecessor_;
    std::vector<double> cost_;
    std::vector<Goal> goals_;
    ShortestPathTree tree_;
    Queue queue_;
    SearchWork work_;
    std::size_t states_ = 0;
    double least_ = 0.0;
    double greatest_ = 0.0;
    double floor_ = 0.0;
    Phase phase_ = Phase::idle;
};

}  // namespace sspql
