// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/core/step_budget.hpp>
#include <sspql/model/transition_counts.hpp>
#include <sspql/paths/path_solver.hpp>
#include <sspql/paths/published_changes.hpp>
#include <sspql/paths/resumable_search.hpp>
#include <sspql/paths/shortest_paths.hpp>
#include <sspql/paths/ssp_values.hpp>
#include <sspql/spaces/legal_actions.hpp>

namespace sspql {

/// Algorithm 1 of Kwon, Suh and Lee (2011) from counts to Q_SSP, kept up to date: labels (eq. 2), the tree of shortest
/// paths, and the values (eq. 5), all at once (update) or in instalments of bounded size (start, advance).
///
/// update() recomputes what changed (PathSolver), and values only in states with new counts, a new next state or a new
/// mask (mask_changed); of LegalActions other than AllActions and LegalActionTable it assumes nothing and recomputes
/// all.
///
/// advance() refreshes labels, searches a frozen snapshot and computes values, a few edges a call; tree() and values()
/// stay the last finished ones and change together, in one call. What is recorded meanwhile waits for the next start().
/// Call it after each record: it first takes over the counts' dirty list, one touch a state. A solve in instalments
/// searches from scratch, or not at all if no label changed; then the values of refreshed states are renewed in place.
/// Threads: const members may run together.
template <class Cost, class Probability, class Queue>
class SspPlanner {
public:
    /// See CostPublisher for the three. \throws std::invalid_argument for a tolerance outside [0, 0.5].
    explicit SspPlanner(Cost cost = Cost{}, Probability probability = Probability{}, double tolerance = 0.0)
        : solver_(std::move(cost), std::move(probability), tolerance) {}

    /// Brings everything up to date now; an unfinished solve in instalments is dropped.
    /// \throws std::invalid_argument for a goal outside or an offset that is not finite and >= 0.
    template <class Cell, class LegalActions>
    void update(TransitionCounts<Cell>& counts, const std::vector<Goal>& goals, const LegalActions& legal) {
        detail::require_goals(goals, counts.states());
        refresh_waiting(counts);
        const bool searched = solver_.solve(counts, goals) == Solved::searched;
        if (searched || !solver_.changes().complete() || !reports_masks<LegalActions>) {
            values_.assign(counts, tree(), legal);
        } else {
            values_.resize(tree().size());
            for (const StateId s : solver_.changes().states()) values_.update(counts, tree(), s, legal);
            for (const StateId s : solver_.changed_states()) values_.update(counts, tree(), s, legal);
            for (const StateId s : remasked_) values_.update(counts, tree(), s, legal);
        }
        remasked_.clear();
        goals_ = goals;
        current_ = true;
    }

    /// The legal actions of s are others now.
    void mask_changed(StateId s) {
        current_ = false;
        if (index(s) < values_.size()) remasked_.push_back(s);
        if (remasked_.size() > values_.size()) {
            remasked_.clear();
            solver_.forget();
        }
    }

    /// Begins a solve in instalments, unless one is under way. O(number of goals).
    /// \throws std::invalid_argument for a goal outside or an offset that is not finite and >= 0.
    template <class Cell>
    void start(TransitionCounts<Cell>& counts, const std::vector<Goal>& goals) {
        if (running()) return;
        detail::require_goals(goals, counts.states());
        collect(counts);
        same_tree_ = current_ && tree().size() == counts.states() && detail::same_goals(goals, goals_);
        if (same_tree_ && waiting_.empty()) return;
        goals_ = goals;
        refreshing_.clear();
        refreshing_.swap(waiting_);
        ++round_;
        done_ = 0;
        current_ = false;
        solver_.forget();
        changes_.begin(0);
        phase_ = Phase::refresh;
    }

    /// Whether a solve in instalments is under way.
    [[nodiscard]] bool running() const noexcept { return phase_ != Phase::idle; }

    /// Goes on with the solve under way until the budget is spent, exceeding it by one state's edges at most.
    /// \returns true if tree() and values() are new.
    template <class Cell, class LegalActions>
    bool advance(TransitionCounts<Cell>& counts, const LegalActions& legal, StepBudget& budget) {
        budget.spend(collect(counts));
        if (phase_ == Phase::refresh) refresh(counts, budget);
        if (phase_ == Phase::search && search_.advance(counts, budget)) {
            edges_ += search_.work().edges;
            next_values_.clear();
            phase_ = Phase::values;
        }
        if (phase_ == Phase::touch_up) return touch_up(counts, legal, budget);
        return phase_ == Phase::values && compute_values(counts, legal, budget);
    }

    /// The last finished tree; empty before the first solve.
    [[nodiscard]] const ShortestPathTree& tree() const noexcept { return solver_.tree(); }
    /// The last finished values, those of tree().
    [[nodiscard]] const SspValues& values() const noexcept { return values_; }
    /// What solves all at once.
    [[nodiscard]] const PathSolver<Cost, Probability, Queue>& solver() const noexcept { return solver_; }

    /// Looks at edges so far: refreshing, taking snapshots, marking and searching.
    [[nodiscard]] std::uint64_t edges_touched() const noexcept { 
        return solver_.edges_touched() + edges_ + (phase_ == Phase::search ? search_.work().edges : 0);
    }

    /// Room for that many states; with `pairs` > 0 also for a solve in instalments over as many (s,s').
    void reserve(std::size_t states, std::size_t pairs = 0) {
        solver_.reserve(states);
        values_.reserve(states);
        if (pairs == 0) return;
        search_.reserve(states, pairs);
        next_values_.reserve(states);
        waiting_.reserve(states);
        refreshing_.reserve(states);
        round_of_.reserve(states);
    }

private:
    friend SerializationAccess;

    enum class Phase : std::uint8_t { idle, refresh, search, values, touch_up };

    template <class Archive, class Cell>
    void serialize(Archive& archive, const TransitionCounts<Cell>& counts) {
        const std::size_t states = counts.states();
        SerializationAccess::serialize(solver_, archive, counts);
        SerializationAccess::serialize(values_, archive, states, counts.actions());
        SerializationAccess::serialize(search_, archive, counts);
        SerializationAccess::serialize(next_values_, archive, states, counts.actions());
        archive(goals_, remasked_, edges_, current_, changes_, refreshing_, waiting_, round_of_, round_, phase_, same_tree_);
        archive.size(done_);
        if constexpr (Archive::loading) {
            detail::require_goals(goals_, states);
            const auto within = [](const std::vector<StateId>& list, std::size_t n) {
                return std::all_of(list.begin(), list.end(), [n](StateId s) { return index(s) < n; });
            };
            archive.require(within(remasked_, values_.size()) && within(refreshing_, states) && within(waiting_, states) &&
                                round_of_.size() <= states && done_ <= refreshing_.size() && phase_ <= Phase::touch_up,
                            "a solve under way is wrong");
            archive.require(search_.running() == (phase_ == Phase::search), "a search is in the wrong phase");
            archive.require(!running() || !same_tree_ || within(refreshing_, tree().size()), "the tree is too small");
            archive.require(phase_ != Phase::touch_up || within(refreshing_, values_.size()), "values are too few");
            archive.require(phase_ != Phase::values || next_values_.size() <= search_.tree().size(), "values are too many");
        }
    }

    template <class LegalActions>
    static constexpr bool reports_masks =
        std::is_same_v<LegalActions, AllActions> || std::is_same_v<LegalActions, LegalActionTable>;

    /// Takes over the dirty list. \returns its length.
    template <class Cell>
    std::size_t collect(TransitionCounts<Cell>& counts) {
        const std::size_t found = counts.dirty().size();
        if (round_of_.size() < counts.states()) round_of_.resize(counts.states(), 0);
        for (const StateId s : counts.dirty()) {
            if (round_of_[index(s)] == round_) continue;
            round_of_[index(s)] = round_;
            waiting_.push_back(s);
        }
        counts.clear_dirty();
        return found;
    }

    template <class Cell>
    void refresh(TransitionCounts<Cell>& counts, StepBudget& budget) {
        for (; done_ < refreshing_.size(); ++done_) {
            if (budget.exhausted()) return;
            const StateId s = refreshing_[done_];
            const std::size_t edges = solver_.publisher().publish_state(counts, s, changes_);
            same_tree_ = same_tree_ && changes_.changed() == 0 && !detail::lost_next(counts, tree(), s);
            edges_ += edges;
            budget.spend(edges + 1);
        }
        done_ = 0;
        phase_ = same_tree_ ? Phase::touch_up : Phase::search;
        if (!same_tree_) search_.start(counts, goals_);
    }

    template <class Cell, class LegalActions>
    bool compute_values(const TransitionCounts<Cell>& counts, const LegalActions& legal, StepBudget& budget) {
        const ShortestPathTree& tree = search_.tree();
        while (next_values_.size() < tree.size()) {
            if (budget.exhausted()) return false;
            const StateId s = state_id(next_values_.size());
            next_values_.resize(index(s) + 1);
            next_values_.update(counts, tree, s, legal);
            budget.spend(counts.out_degree(s) + 1);
        }
        solver_.swap_tree(search_.tree());
        values_.swap(next_values_);
        return finish();
    }

    template <class Cell, class LegalActions>
    bool touch_up(const TransitionCounts<Cell>& counts, const LegalActions& legal, StepBudget& budget) {
        for (; done_ < refreshing_.size(); ++done_) {
            if (budget.exhausted()) return false;
            values_.update(counts, tree(), refreshing_[done_], legal);
            budget.spend(counts.out_degree(refreshing_[done_]) + 1);
        }
        return finish();
    }

    bool finish() noexcept {
        phase_ = Phase::idle;
        current_ = true;
        return true;
    }

    /// Refreshes what instalments took over from the dirty list and did not get to.
    template <class Cell>
    void refresh_waiting(TransitionCounts<Cell>& counts) {
        if (waiting_.empty() && !running()) return;
        solver_.forget();
        current_ = false;
        edges_ += phase_ == Phase::search ? search_.work().edges : 0;
        changes_.begin(0);
        if (phase_ == Phase::refresh) waiting_.insert(waiting_.end(), refreshing_.begin(), refreshing_.end());
        for (const StateId s : waiting_) edges_ += solver_.publisher().publish_state(counts, s, changes_);
        waiting_.clear();
        ++round_;
        search_.stop();
        phase_ = Phase::idle;
    }

    PathSolver<Cost, Probability, Queue> solver_;
    SspValues values_;
    std::vector<Goal> goals_;  // of the tree in use, or of the one being found
    std::vector<StateId> remasked_;
    std::uint64_t edges_ = 0;
    bool current_ = false;  // tree and values are those of the labels, goals and masks

    // Instalments: the next tree and its values, the states to refresh for it, and those for the one after.
    ResumableSearch<Queue> search_;
    SspValues next_values_;
    PublishedChanges changes_;
    std::vector<StateId> refreshing_;
    std::vector<StateId> waiting_;
    std::vector<std::uint32_t> round_of_;  // by state: the round in which it came to waiting_
    std::size_t done_ = 0;  // of refreshing_
    std::uint32_t round_ = 1;
    Phase phase_ = Phase::idle;
    bool same_tree_ = false;
};

}  // namespace sspql
