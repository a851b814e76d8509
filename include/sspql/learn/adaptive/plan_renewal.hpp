// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/core/step_budget.hpp>
#include <sspql/learn/adaptive/goal_distances.hpp>
#include <sspql/learn/adaptive/optimism_scale.hpp>
#include <sspql/learn/adaptive/optimistic_planner.hpp>
#include <sspql/learn/transition.hpp>
#include <sspql/model/cells.hpp>
#include <sspql/paths/shortest_paths.hpp>

namespace sspql {

/// The work of AdaptiveSspql that comes due all at once, cut into slices: at the end of an episode shortest paths are
/// searched, and levels of optimism set by them; at the first goal, and for goals that were told, all values start anew
/// from the levels and are queued for a backup, which works like a search from the goal. One such chore is under way at
/// a time; each call of the user goes on with it until its slice is spent (OptimisticPlanner::begin_call).
///
/// Paths and levels are amortised: each step earns `path_budget` edge touches for either, and an episode's end without
/// enough of them leaves things as they are.
template <class Derived, class Policies, class ParamsType>
class PlanRenewal : public OptimisticPlanner<Derived, Policies, ParamsType> {
    using Base = OptimisticPlanner<Derived, Policies, ParamsType>;

protected:
    PlanRenewal(StateCount states, std::size_t actions, ParamsType params, std::uint64_t seed)
        : Base(states, actions, std::move(params), seed),
          scale_(this->params_.gamma, this->params_.optimism),
          distances_(states.initial()),
          leads_out_(states.initial(), 0) {
        this->scale_step_ = scale_.step_value();
    }

    template <class Archive>
    void serialize(Archive& archive) {
        Base::serialize(archive);
        archive.section("scale", [&] { archive(scale_); });
        archive.section("paths", [&] { archive(distances_); });
        archive.section("chores", [&] {
            archive(order_, exits_, chore_, restarted_, path_bank_, path_cost_, level_bank_, levels_top_, labelled_unit_,
                    labelled_costs_);
            archive.size(cursor_);
            archive.fixed(leads_out_);
            archive.require(cursor_ <= order_.size() && chore_ <= Chore::enqueue &&
                                (chore_ == Chore::search) == distances_.searching(),
                            "a chore under way is wrong");
            if constexpr (Archive::loading) check_lists(archive);
        });
    }

    void add_states(std::size_t n) {
        Base::add_states(n);
        distances_.grow(n);
        leads_out_.resize(n, 0);
    }

    void reserve_tables(std::size_t states, std::size_t pairs) {
        Base::reserve_tables(states, pairs);
        distances_.reserve(states);
        leads_out_.reserve(states);
        order_.reserve(states);
        exits_.reserve(states);
        seeds_.reserve(states);
    }

    void set_level(StateId s) {
        const double path = this->params_.bound_by_paths ? distances_.distance(s) : 0.0;
        const OptimismScale::Level level = scale_.level(path);
        this->at(s).here = level.here;
        this->at(s).ahead = level.ahead;
        this->at(s).reach = scale_.reach(path);
    }

    void remember_exit(StateId s) {
        if (leads_out_[index(s)] != 0) return;
        leads_out_[index(s)] = 1;
        exits_.push_back(s);
    }

    void earn() noexcept {
        this->budget_.earn();
        path_bank_ += this->params_.path_budget;
        level_bank_ += this->params_.path_budget;
    }

    /// Steps turned out to cost, or not: levels follow. What is known so far is few states, as a rule.
    void rescale() {
        this->goals_.renew(scale_);
        if (chore_ == Chore::none) begin_chore(Chore::levels);
    }

    /// What was collected on the way grew, in an episode that may never end.
    void follow_income() {
        if (chore_ != Chore::none || !scale_.goal_known()) return;
        if (!(std::fabs(scale_.top() - levels_top_) > 0.1 * std::fabs(scale_.top()))) return;
        if (!restarted_) {
            begin_renewal();
        } else if (level_bank_ >= static_cast<double>(order_.size())) {
            begin_chore(Chore::levels);
        }
    }

    /// An episode ended: new paths and levels, if enough was earned and no chore is under way.
    void renew() {
        if (chore_ == Chore::none && scale_.goal_known()) begin_renewal();
    }

    /// Other goals hold: everything from the beginning.
    void start_over() {
        restarted_ = false;
        distances_.abandon();
        begin_renewal();
    }

    /// Goes on with the chore under way.
    void go_on() {
        if (this->params_.bound_by_paths && !distances_.searching() &&
            this->model_.counts().dirty().size() >= most_dirty) {
            charge(distances_.refresh(this->model_.counts(), step_cost()));
        }
        while (chore_ != Chore::none && !Base::call_over()) {
            if (chore_ == Chore::search) {
                search(this->call_ends_ - this->operations_);
            } else {
                next_state();
            }
        }
    }

    OptimismScale scale_;
    GoalDistances distances_;
    std::vector<StateId> order_;  // states in the order they were seen

private:
    enum class Chore : std::uint8_t { none, relabel, search, levels, restart, enqueue };

    static constexpr std::size_t most_dirty = 200;  // states whose labels may wait

    void begin_chore(Chore chore) {
        chore_ = chore;
        cursor_ = 0;
    }

    void begin_renewal() {
        this->goals_.renew(scale_);
        if (this->params_.bound_by_paths && (!restarted_ || path_bank_ >= path_cost_)) {
            path_bank_ = 0.0;
            path_cost_ = 0.0;
            const bool costs = scale_.costs();
            const bool rescaled = labelled_costs_ != costs || (costs && labelled_unit_ != scale_.unit());
            labelled_costs_ = costs;
            labelled_unit_ = scale_.unit();
            if (rescaled) return begin_chore(Chore::relabel);
            begin_search();
        } else if (!restarted_ || level_bank_ >= static_cast<double>(order_.size())) {
            begin_chore(Chore::levels);
        }
    }

    /// Every state seen is listed once, and so is every one with a way out.
    template <class Archive>
    void check_lists(Archive& archive) const {
        std::vector<bool> listed(Base::states(), false);
        for (const StateId s : order_) {
            archive.require(index(s) < listed.size() && !listed[index(s)] && this->at(s).seen, "the list of states is wrong");
            listed[index(s)] = true;
        }
        for (std::size_t s = 0; s < listed.size(); ++s) {
            archive.require(this->at(state_id(s)).seen == listed[s], "the list of states is incomplete");
        }
        for (const StateId s : exits_) {
            archive.require(index(s) < listed.size() && leads_out_[index(s)] == 1, "the list of exits is wrong");
        }
    }

    /// The chore's next state, or the next chore.
    void next_state() {
        if (cursor_ == order_.size()) return finish();
        const StateId s = order_[cursor_++];
        ++this->operations_;
        switch (chore_) {
            case Chore::relabel: charge(distances_.relabel(this->model_.counts(), s, step_cost())); break;
            case Chore::levels: renew_level(s); break;
            case Chore::restart: restart(s); break;
            default: enqueue(s); break;
        }
    }

    void finish() {
        switch (chore_) {
            case Chore::relabel: begin_search(); break;
            case Chore::levels:
                level_bank_ = 0.0;
                levels_top_ = scale_.top();
                if (restarted_) return begin_chore(Chore::none);
                this->queue_.clear();
                begin_chore(Chore::restart);
                break;
            case Chore::restart: begin_chore(Chore::enqueue); break;
            default:
                restarted_ = scale_.goal_known();
                this->budget_.grant(this->budget_.per_step() * this->model_.steps());
                begin_chore(Chore::none);
                Base::sweep();
                break;
        }
    }

    void renew_level(StateId s) {
        const double before = this->at(s).value;
        set_level(s);
        Base::renew_value(s);
        if (restarted_) Base::pass_on(s, before);
    }

    /// Q(s,.) as if nothing but the next step were known.
    void restart(StateId s) {
        for (std::size_t i = 0; i < Base::actions(); ++i) {
            const ActionId a = action_id(i);
            if (!this->model_.tried(s, a)) continue;
            const auto sums = Base::sum_outcomes(s, a, [this](StateId next) { return this->at(next).ahead; });
            this->q_(s, a) = (sums.value + this->params_.gamma * sums.staying * this->at(s).ahead) /
                             this->model_.counts().n(s, a);
        }
        Base::renew_best(s);
    }

    void enqueue(StateId s) {
        for (std::size_t i = 0; i < Base::actions(); ++i) {
            const ActionId a = action_id(i);
            if (!this->model_.tried(s, a)) continue;
            const double off = std::fabs(Base::backup(s, a) - this->q_(s, a));
            if (off > 0.0) this->queue_.raise(s, a, off);
        }
    }

    [[nodiscard]] auto step_cost() const {
        const bool costs = scale_.costs();
        const double unit = scale_.unit();
        return [costs, unit](double mean_reward) { return costs ? std::max(1.0, -mean_reward / unit) : 1.0; };
    }

    void begin_search() {
        charge(distances_.refresh(this->model_.counts(), step_cost()));
        find_seeds();
        distances_.start(seeds_);
        chore_ = Chore::search;
    }

    void search(std::uint64_t edges) {
        StepBudget budget(edges, edges);
        budget.earn();
        const std::size_t before = distances_.work();
        const bool finished = distances_.advance(this->model_.counts(), budget);
        charge(distances_.work() - before);
        if (finished) begin_chore(Chore::levels);
    }

    /// The states from which an episode ended well, and how far the end is from there.
    void find_seeds() {
        seeds_.clear();
        for (const StateId s : exits_) {
            double least = GoalDistances::unknown;
            this->model_.counts().for_each_successor(s, [&](const auto& successor) {
                const bool told = this->goals_.contains(successor.state());
                successor.for_each_action([&](ActionId a, const FadingCell& cell) {
                    if (cell.n < 0.5 || !(told || cell.terminal())) return;
                    const double reward = told ? this->goals_.worth(successor.state()) : cell.mean_reward();
                    if (!told && (!this->goals_.empty() || !scale_.counts_as_goal(reward))) return;
                    const double steps = std::max(0.0, scale_.cost_of(reward)) + (scale_.costs() ? 0.0 : 1.0);
                    least = std::min(least, steps * this->model_.counts().n(s, a) / cell.n);
                });
            });
            if (least < GoalDistances::unknown) seeds_.push_back({s, least});
        }
    }

    void charge(std::size_t edges) noexcept {
        this->operations_ += edges;
        path_cost_ += static_cast<double>(edges);
    }

    std::vector<std::uint8_t> leads_out_;  // whether an episode ended from there
    std::vector<StateId> exits_;           // those
    std::vector<Goal> seeds_;
    Chore chore_ = Chore::none;
    std::size_t cursor_ = 0;  // the chore's next place in order_
    bool restarted_ = false;
    double path_bank_ = 0.0;  // edge touches earned for paths, and what the last search took
    double path_cost_ = 0.0;
    double level_bank_ = 0.0;
    double levels_top_ = 0.0;  // the best reward when levels were set
    double labelled_unit_ = 0.0;
    bool labelled_costs_ = false;
};

}  // namespace sspql
