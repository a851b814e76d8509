// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/core/step_budget.hpp>
#include <sspql/model/cells.hpp>
#include <sspql/model/transition_counts.hpp>
#include <sspql/paths/dary_heap.hpp>
#include <sspql/paths/shortest_paths.hpp>

namespace sspql {

/// How far every state is from the goals along the shortest known path, in steps: Dijkstra's search backwards over the
/// learnt counts, an edge costing weight / P, the expected number of tries (the paper's search with another cost). Each
/// (s,s') costs what its best action does; outcomes seen less than half a time do not count, nor do ends of episodes,
/// which the seeds stand for.
///
/// The search is resumable: advance() works until a budget is spent, and distance() tells what the last finished search
/// found. Costs are refreshed for dirty states only, never while a search runs: what is recorded meanwhile waits. It is
/// the only reader of these counts' dirty list and the only writer of their labels.
/// O(m + n log n) for a search over n states and m distinct (s,s'). Threads: none inside.
class GoalDistances {
public:
    /// The counts it reads.
    using Counts = TransitionCounts<FadingCell>;
    /// The distance where no path is known.
    static constexpr double unknown = std::numeric_limits<double>::infinity();

    /// All distances are `unknown`.
    explicit GoalDistances(std::size_t states) { grow(states); }

    /// More states, at distance `unknown`.
    void grow(std::size_t states) {
        if (states <= distance_.size()) return;
        distance_.resize(states, unknown);
        tentative_.resize(states, unknown);
        queued_.resize(states, 0);
        queue_.grow(states);
    }
    /// Room for that many states.
    void reserve(std::size_t states) {
        distance_.reserve(states);
        tentative_.reserve(states);
        queued_.reserve(states);
        queue_.reserve(states);
    }

    /// Brings the costs of the edges out of dirty states up to date. `step_cost(mean reward)` is an edge's weight, >= 1.
    /// Does nothing while a search runs. \returns the edges looked at.
    template <class StepCost>
    std::size_t refresh(Counts& counts, const StepCost& step_cost) {
        if (searching_) return 0;
        std::size_t edges = 0;
        for (const StateId s : counts.dirty()) edges += refresh_state(counts, s, step_cost);
        counts.clear_dirty();
        return edges;
    }

    /// The same for the edges out of one state, dirty or not: the weights of steps have changed. Not while a search runs.
    template <class StepCost>
    std::size_t relabel(Counts& counts, StateId s, const StepCost& step_cost) {
        return refresh_state(counts, s, step_cost);
    }

    /// Starts a search from the seeds: states with a way out, and how many steps the goal is away by it.
    void start(const std::vector<Goal>& seeds) {
        std::fill(tentative_.begin(), tentative_.end(), unknown);
        std::fill(queued_.begin(), queued_.end(), std::uint8_t{0});
        queue_.prepare(tentative_.size());
        for (const Goal& seed : seeds) relax(seed.state, seed.offset);
        searching_ = true;
        work_ = 0;
    }

    /// Goes on with the search. \returns whether it is finished; then distance() is renewed.
    bool advance(const Counts& counts, StepBudget& budget) {
        while (!queue_.empty()) {
            if (budget.exhausted()) return false;
            const StateId v{queue_.pop()};
            queued_[index(v)] = 2;
            const double here = tentative_[index(v)];
            std::size_t edges = 1;
            counts.for_each_predecessor(v, [&](StateId u, double cost) {
                ++edges;
                if (u != v && cost < unknown) relax(u, here + cost);  // false for new edges without a cost, too
            });
            budget.spend(edges);
            work_ += edges;
        }
        distance_.swap(tentative_);
        searching_ = false;
        return true;
    }

    /// Gives a running search up; distances stay those of the last finished one.
    void abandon() noexcept { searching_ = false; }

    /// Whether a search is under way.
    [[nodiscard]] bool searching() const noexcept { return searching_; }

    /// Steps from s to the nearest goal, as of the last search that finished; `unknown` without a known path.
    [[nodiscard]] double distance(StateId s) const noexcept { return distance_[index(s)]; }

    /// A first guess for a state that turned up after the search.
    void set_distance(StateId s, double steps) noexcept { distance_[index(s)] = steps; }

    /// Edges touched by the last search, or by the one under way.
    [[nodiscard]] std::size_t work() const noexcept { return work_; }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive) {
        archive.fixed(distance_);
        archive(searching_);
        archive.size(work_);
        for (const double steps : distance_) archive.require(steps >= 0.0, "a distance is negative or no number");
        if (!searching_) return;
        archive.fixed(tentative_);
        archive.fixed(queued_);
        archive(queue_);
        if constexpr (Archive::loading) {
            std::size_t queued = 0;
            for (std::size_t s = 0; s < queued_.size(); ++s) {
                archive.require(queued_[s] <= 2 && tentative_[s] >= 0.0, "a search under way is wrong");
                queued += queued_[s] == 1 ? 1u : 0u;
            }
            queue_.for_each([&](std::uint32_t s, double key) {
                archive.require(queued_[s] == 1 && tentative_[s] == key, "a search's queue is wrong");
            });
            archive.require(queued == queue_.size(), "a search's queue is incomplete");
        }
    }

    template <class StepCost>
    static std::size_t refresh_state(Counts& counts, StateId s, const StepCost& step_cost) {
        std::size_t edges = 0;
        counts.for_each_successor(s, [&](const auto& successor) {
            double best = unknown;
            successor.for_each_action([&](ActionId a, const FadingCell& cell) {
                ++edges;
                if (cell.terminal() || cell.n < 0.5) return;
                best = std::min(best, step_cost(cell.mean_reward()) * counts.n(s, a) / cell.n);
            });
            counts.set_label(successor, best);
        });
        return edges;
    }

    void relax(StateId s, double through) {
        double& known = tentative_[index(s)];
        std::uint8_t& state = queued_[index(s)];
        if (!(through < known) || state == 2) return;
        known = through;
        if (state == 1) {
            queue_.decrease(static_cast<std::uint32_t>(s), through);
        } else {
            state = 1;
            queue_.push(static_cast<std::uint32_t>(s), through);
        }
    }

    std::vector<double> distance_;
    std::vector<double> tentative_;
    std::vector<std::uint8_t> queued_;  // 0: not yet, 1: in the queue, 2: settled
    DaryHeap<4> queue_;
    bool searching_ = false;
    std::size_t work_ = 0;
};

}  // namespace sspql
