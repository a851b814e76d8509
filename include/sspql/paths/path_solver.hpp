// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/model/transition_counts.hpp>
#include <sspql/paths/cost_publisher.hpp>
#include <sspql/paths/published_changes.hpp>
#include <sspql/paths/reverse_graph.hpp>
#include <sspql/paths/shortest_paths.hpp>
#include <sspql/paths/tree_repair.hpp>

namespace sspql {

namespace detail {

inline bool same_goals(const std::vector<Goal>& left, const std::vector<Goal>& right) noexcept {
    return std::equal(left.begin(), left.end(), right.begin(), right.end(),
                      [](const Goal& a, const Goal& b) { return a.state == b.state && a.offset == b.offset; });
}

/// Whether the edge from s to its next state is gone. O(out-degree).
template <class Cell>
bool lost_next(const TransitionCounts<Cell>& counts, const ShortestPathTree& tree, StateId s) {
    const StateId next = tree.next[index(s)];
    bool found = next == no_state;
    counts.for_each_successor(s, [&](const auto& successor) { found = found || successor.state() == next; });
    return !found;
}

}  // namespace detail

/// How a PathSolver solved.
enum class Solved {
    unchanged,  ///< the tree was right, new states without a path included
    repaired,   ///< some states have another distance or next state
    searched,   ///< from scratch
};

/// Keeps a tree of shortest paths over learnt counts, doing as little as possible each time: nothing where no label
/// changed, a repair (TreeRepair) where few states are affected, a search over a fresh snapshot (ReverseGraph) else.
/// Whichever it is, the tree is the same, bit for bit.
///
/// A search from scratch is made the first time, for other goals, after forget(), where costs lie below the floor of
/// ReverseGraph or distances absorb costs, and as soon as more than three quarters of the states that had a path are
/// seen to lose it, which marking them finds out at a fraction of the price.
///
/// One solver serves one TransitionCounts, whose labels and dirty list are its own from the first solve on. Erased
/// pairs (fading) are noticed: every pair either had a label after the last solve or gets its first one now, so a
/// smaller number of pairs than that means that some are gone, and only from states that are dirty. Memory: 12 bytes an
/// edge, 21 and the queue's a state; kept, so that a solve allocates only where something grew.
template <class Cost, class Probability, class Queue>
class PathSolver {
    static_assert(detail::QueueRequirements<Queue>::met);

public:
    /// See CostPublisher for the three. \throws std::invalid_argument for a tolerance outside [0, 0.5].
    explicit PathSolver(Cost cost = Cost{}, Probability probability = Probability{}, double tolerance = 0.0)
        : publisher_(std::move(cost), std::move(probability), tolerance) {}

    /// Publishes the costs of the dirty states, then brings the tree up to date. O(m + n log n) at most for n states
    /// and m edges; in proportion to the edges of dirty and affected states where these are few.
    /// \throws std::invalid_argument for a goal outside or an offset that is not finite and >= 0; nothing has changed
    /// then.
    template <class Cell>
    Solved solve(TransitionCounts<Cell>& counts, const std::vector<Goal>& goals) {
        detail::require_goals(goals, counts.states());
        const bool known = std::exchange(known_, false) && detail::same_goals(goals, goals_);
        repair_.clear();
        changes_.begin(known ? limit() : 0);
        edges_ += publisher_.publish(counts, changes_);
        if (known && repairable()) {
            tree_.distance.resize(counts.states(), std::numeric_limits<double>::infinity());
            tree_.next.resize(counts.states(), no_state);
            find_lost(counts);
            if (changes_.changed() == 0 && lost_.empty()) return done(counts, Solved::unchanged);
            const bool repaired =
                repair_.repair(counts, changes_, lost_, goals, least_, greatest_, limit(), queue_, tree_);
            edges_ += repair_.work().edges;
            if (repaired) return done(counts, Solved::repaired);
        }
        goals_ = goals;
        graph_.assign(counts);
        const SearchWork work = shortest_paths_to(graph_, goals_, queue_, tree_);
        edges_ += graph_.edges() + work.edges;
        reached_ = work.states;
        least_ = graph_.least_cost();
        greatest_ = graph_.greatest_cost();
        exact_ = absorbs_nothing();
        return done(counts, Solved::searched);
    }

    /// The labels were changed by somebody else, or the tree swapped: the next solve searches from scratch.
    void forget() noexcept { known_ = false; }

    /// The tree of the last solve; empty before the first. Valid until the next.
    [[nodiscard]] const ShortestPathTree& tree() const noexcept { return tree_; }

    /// Exchanges the tree for another one of the same counts (see ResumableSearch). The next solve searches from
    /// scratch.
    void swap_tree(ShortestPathTree& tree) noexcept {
        std::swap(tree_.distance, tree.distance);
        std::swap(tree_.next, tree.next);
        forget();
    }

    /// What the last solve published; not complete() if too much changed to look at it one by one.
    [[nodiscard]] const PublishedChanges& changes() const noexcept { return changes_; }

    /// After `repaired`: the states whose distance or next state may have changed. Empty else.
    [[nodiscard]] const std::vector<StateId>& changed_states() const noexcept { return repair_.states(); }

    /// What publishes the costs.
    [[nodiscard]] const CostPublisher<Cost, Probability>& publisher() const noexcept { return publisher_; }

    /// Looks at edges so far: refreshing, taking snapshots, marking and searching.
    [[nodiscard]] std::uint64_t edges_touched() const noexcept { return edges_; }

    /// Room for that many states.
    void reserve(std::size_t states) {
        tree_.distance.reserve(states);
        tree_.next.reserve(states);
        repair_.reserve(states);
    }

private:
    friend SerializationAccess;

    /// The tree must fit the labels where it says so: repairs rely on it.
    template <class Archive, class Cell>
    void serialize(Archive& archive, const TransitionCounts<Cell>& counts) {
        SerializationAccess::serialize(tree_, archive, counts.states());
        archive(goals_, edges_, least_, greatest_, known_, exact_);
        archive.size(reached_);
        archive.size(pairs_);
        if constexpr (Archive::loading) {
            detail::require_goals(goals_, counts.states());
            if (known_) archive.require(fits(counts), "shortest paths do not fit the costs");
        }
    }

    template <class Cell>
    [[nodiscard]] bool fits(const TransitionCounts<Cell>& counts) const {
        bool sound = least_ >= 0.0 && least_ <= greatest_ && pairs_ <= counts.pairs();
        for (const Goal& goal : goals_) sound = sound && index(goal.state) < tree_.size();
        const double floor = std::max(greatest_ * ReverseGraph::least_ratio, std::numeric_limits<double>::min());
        for (std::size_t s = 0; s < counts.states() && sound; ++s) {
            counts.for_each_successor(state_id(s), [&](const auto& successor) {
                const double label = successor.label();
                sound = sound && (label != label || (std::max(label, floor) >= least_ && label <= greatest_));
                if (s >= tree_.size() || tree_.next[s] != successor.state()) return;
                sound = sound && tree_.distance[s] == tree_.distance[index(successor.state())] + std::max(label, floor);
            });
        }
        return sound;
    }

    /// Beyond how many states a repair is expected to cost more than a search, which also passes over those without a
    /// path.
    [[nodiscard]] std::size_t limit() const noexcept { return std::max(reached_ / 4 * 3, tree_.size() / 64) + 1; }

    /// Whether the tree and the labels are of the kind that can be repaired. Keeps the bounds on the labels: all ever
    /// since the last search, so that they may be wider than need be.
    [[nodiscard]] bool repairable() noexcept {
        least_ = std::min(least_, changes_.least());
        greatest_ = std::max(greatest_, changes_.greatest());
        const double floor = std::max(greatest_ * ReverseGraph::least_ratio, std::numeric_limits<double>::min());
        return exact_ && changes_.complete() && least_ > floor;
    }

    /// Finds the states whose edge to the next state was erased.
    template <class Cell>
    void find_lost(const TransitionCounts<Cell>& counts) {
        lost_.clear();
        if (pairs_ + changes_.added() == counts.pairs()) return;
        for (const StateId s : changes_.states()) {
            edges_ += counts.out_degree(s);
            if (detail::lost_next(counts, tree_, s)) lost_.push_back(s);
        }
    }

    /// Whether every distance is larger than that of the next state. Where it is not, the order of settling made the
    /// tree, which a repair cannot know.
    [[nodiscard]] bool absorbs_nothing() const noexcept {
        double greatest = 0.0;
        for (const double distance : tree_.distance) {
            if (distance < std::numeric_limits<double>::infinity()) greatest = std::max(greatest, distance);
        }
        if (greatest * std::numeric_limits<double>::epsilon() < least_) return true;
        for (std::size_t s = 0; s < tree_.size(); ++s) {
            const StateId next = tree_.next[s];
            if (next != no_state && !(tree_.distance[index(next)] < tree_.distance[s])) return false;
        }
        return true;
    }

    template <class Cell>
    Solved done(const TransitionCounts<Cell>& counts, Solved solved) noexcept {
        pairs_ = counts.pairs();
        known_ = true;
        return solved;
    }

    CostPublisher<Cost, Probability> publisher_;
    PublishedChanges changes_;
    ReverseGraph graph_;
    Queue queue_;
    TreeRepair repair_;
    ShortestPathTree tree_;
    std::vector<Goal> goals_;
    std::vector<StateId> lost_;
    std::uint64_t edges_ = 0;
    std::size_t reached_ = 0;  // states with a path at the last search
    std::size_t pairs_ = 0;    // at the last solve, all of them with a label
    double least_ = 0.0;
    double greatest_ = 0.0;
    bool known_ = false;  // tree_ is that of the labels and goals_
    bool exact_ = false;  // no distance of tree_ absorbs a cost
};

}  // namespace sspql
