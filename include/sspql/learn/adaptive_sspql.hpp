// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/learn/adaptive/goal_distances.hpp>
#include <sspql/learn/adaptive/optimism_scale.hpp>
#include <sspql/learn/adaptive/plan_renewal.hpp>
#include <sspql/learn/adaptive/retrace.hpp>
#include <sspql/learn/adaptive_params.hpp>
#include <sspql/learn/transition.hpp>
#include <sspql/model/cells.hpp>
#include <sspql/paths/shortest_paths.hpp>

namespace sspql {

/// What an AdaptiveSspql has come to believe, for reports.
struct AdaptiveStatus {
    std::uint64_t steps = 0;         ///< learnt from so far
    std::size_t states_known = 0;    ///< seen at least once
    std::size_t pairs_tried = 0;     ///< (s,a) tried at least once
    std::uint64_t edge_touches = 0;  ///< of all work so far
    std::uint64_t alarms = 0;        ///< changes of the world noticed
    bool goal_known = false;         ///< whether it is known what there is to be had, see OptimismScale
    double typical_cost = 0.0;       ///< median cost of the last episodes that reached a goal, in steps
    double optimism = 0.0;           ///< c: how far off the goal is believed to be behind what was not tried, in steps
    double noise = 0.0;              ///< how often an outcome is not what the counts lead to expect
    double kappa = 0.0;              ///< the optimistic pseudo-count of every (s,a)
};

/// The adaptive planner, the recommended learner: one set of parameters for every task.
///
/// It counts what actions lead to, plans expected values on these counts with every step (prioritized, within a budget),
/// is optimistic about what it has not tried in proportion to what reaching the goal has cost so far, bounded by the
/// shortest path known (Dijkstra's search over weight / P, as SSPQL's), and notices for each (s,a) by itself when the
/// world has changed. docs/adaptive.md explains it in pictures.
///
/// Interface, errors and threads: Learner. Rewards: goals pay or steps cost, see OptimismScale; hazards, step costs,
/// episodes cut by a time limit and a growing number of states are all fine. Told goals (set_goals) are planned for at
/// once; what they are worth follows from their offsets, in steps, and rewards for ending elsewhere count no more, unless
/// they are negative. Steps told by observe() count into the running episode's cost.
/// LegalActions of your own are read when a state is visited.
/// A step is O(|A| x outcomes + budget x log n) on average. No call touches more edges than a `slice`, the outcomes of
/// the state it is about and one piece of work more (the edges of one state; those of up to 200 states whose paths are
/// due), however many states there are: work that comes due all at once is spread over the steps that follow
/// (PlanRenewal). When a search begins, arrays of 17 bytes a state are cleared at memory speed, and 8 bytes an (s,a) when
/// a first or told goal is planned for. After reserve() nothing is allocated, except for masks, hints, the first weight
/// other than 1, and beyond what TransitionCounts reserves.
template <class Policies = AdaptivePolicies>
class AdaptiveSspql : public PlanRenewal<AdaptiveSspql<Policies>, Policies, AdaptiveParams<Policies>> {
    using Base = PlanRenewal<AdaptiveSspql, Policies, AdaptiveParams<Policies>>;
    friend OptimisticPlanner<AdaptiveSspql, Policies, AdaptiveParams<Policies>>;
    friend Learner<AdaptiveSspql, typename Policies::LegalActions>;
    friend SerializationAccess;

public:
    /// Its parameters, by name.
    using Params = AdaptiveParams<Policies>;
    static constexpr const char* type_name = "adaptive SSPQL";  ///< in checkpoints

    /// Knows nothing yet. Ties are broken by `seed`.
    /// \throws std::invalid_argument for no states or actions, more than 65535 actions, or parameters out of range.
    AdaptiveSspql(StateCount states, std::size_t actions, Params params = {}, std::uint64_t seed = 0)
        : Base(states, actions, checked(std::move(params), actions), seed), retrace_(states.initial(), actions) {}

    /// Room for `states` states and `pairs` distinct (s,s') in all (0: five a state).
    void reserve(std::size_t states, std::size_t pairs = 0) {
        Base::reserve_tables(states, pairs == 0 ? 5 * states : pairs);
        retrace_.reserve(states);
    }

    /// Why: Q(s,a), or what is hoped of an action never tried; the bonus for seldom tried ones; a trainer's hint. The
    /// shortest path enters as a bound on hope, not as a term. \throws std::invalid_argument for ids outside.
    [[nodiscard]] ActionTerms terms(StateId s, ActionId a) const {
        Base::require_known(s, a);
        const double n = this->model_.counts().n(s, a);
        const double hope = this->at(s).seen ? this->at(s).here : scale_.level(GoalDistances::unknown).here;
        return {n > 0.0 ? this->q_(s, a) : untried_worth(s, a, hope), 0.0, bonus_of(s) / (n + 1.0),
                Base::hint_term(s, a), n};
    }

    /// What it believes now, in numbers. O(1).
    [[nodiscard]] AdaptiveStatus status() const noexcept {
        return {this->model_.steps(), order_.size(), this->model_.pairs_tried(), this->operations_,
                this->model_.detector().alarms(), scale_.goal_known(), scale_.typical_cost(), scale_.optimism(),
                this->model_.noise(), this->model_.kappa()};
    }

    /// V(s): what s is believed to be worth. \throws std::invalid_argument for a state outside.
    [[nodiscard]] double state_value(StateId s) const {
        Base::require_known(s);
        return this->at(s).seen ? this->at(s).value : scale_.level(GoalDistances::unknown).here;
    }

    /// The length of the shortest known path from s to a goal, in expected steps, as of the last search; infinite where
    /// none is known. \throws std::invalid_argument for a state outside.
    [[nodiscard]] double path_length(StateId s) const {
        Base::require_known(s);
        return distances_.distance(s);
    }

    /// The goals that hold now: those told, else the states where an episode ended, the last time, with a reward that
    /// counts as a goal's (OptimismScale), ascending. O(distinct (s,a,s') seen).
    [[nodiscard]] std::vector<Goal> goals() const {
        if (!this->goals_.empty()) return this->goals_.goals();
        std::vector<bool> reached(Base::states(), false);
        for (const StateId s : order_) {
            this->model_.counts().for_each_successor(s, [&](const auto& successor) {
                successor.for_each_action([&](ActionId, const FadingCell& cell) {
                    if (!cell.terminal() || !scale_.counts_as_goal(cell.mean_reward())) return;
                    reached[index(successor.state())] = true;
                });
            });
        }
        std::vector<Goal> goals;
        for (std::size_t s = 0; s < reached.size(); ++s) {
            if (reached[s]) goals.push_back({state_id(s), 0.0});
        }
        return goals;
    }

    /// The scale between values and steps.
    [[nodiscard]] const OptimismScale& scale() const noexcept { return scale_; }

private:
    using Base::distances_;
    using Base::order_;
    using Base::scale_;

    static Params checked(Params params, std::size_t actions) {
        params.validate();
        if (actions > 65535) throw_invalid("number of actions", "be at most 65535", actions);
        return params;
    }

    template <class Archive>
    void serialize(Archive& archive) {
        Base::serialize(archive);
        archive.section("retrace", [&] { archive(retrace_); });
    }

    void add_states(std::size_t n) {
        Base::add_states(n);
        retrace_.grow(n);
    }

    // --- what was not tried ---

    /// Before a goal is known an action that probably leads back where the agent came from attracts a little less.
    [[nodiscard]] double untried_worth(StateId s, ActionId a, double level) const noexcept {
        if (scale_.goal_known() || scale_.costs()) return level;
        return level * (1.0 - this->params_.retrace * retrace_.rate(s, a));
    }

    [[nodiscard]] double best_untried(StateId s, double level) const noexcept {
        if (scale_.goal_known() || scale_.costs()) return level;
        double best = Base::never;
        Base::for_each_legal(s, [&](ActionId a) {
            if (!this->model_.tried(s, a)) best = std::max(best, untried_worth(s, a, level));
        });
        return best;
    }

    [[nodiscard]] double open_worth(StateId s) const noexcept { return best_untried(s, this->at(s).ahead); }
    [[nodiscard]] double unseen_worth(StateId s) const noexcept { return best_untried(s, this->at(s).here); }

    /// s turned up, from a state `from` if not no_state.
    void know(StateId s, StateId from) {
        if (this->at(s).seen) {
            if constexpr (!std::is_same_v<typename Policies::LegalActions, AllActions> &&
                          !std::is_same_v<typename Policies::LegalActions, LegalActionTable>) {
                legal_actions_changed(s);
            }
            return;
        }
        this->at(s).seen = true;
        order_.push_back(s);
        if (from != no_state) distances_.set_distance(s, distances_.distance(from));
        Base::set_level(s);
        Base::count_actions(s);
        Base::renew_best(s);
    }

    void legal_actions_changed(StateId s) {
        if (!this->at(s).seen) return;
        const double before = this->at(s).value;
        Base::count_actions(s);
        Base::renew_best(s);
        Base::pass_on(s, before);
    }

    // --- choosing ---

    [[nodiscard]] double bonus_of(StateId s) const noexcept {
        if (!scale_.goal_known() || !this->at(s).seen) return 0.0;
        const double left = std::max(0.0, scale_.cost_of(this->at(s).value)) * scale_.step_value();
        return this->params_.bonus * left * std::min(1.0, this->params_.bonus_scale / scale_.typical_cost());
    }

    ActionId select(StateId s) {
        know(s, no_state);
        const double bonus = bonus_of(s);
        const ActionId heading = retrace_.heading(s);
        return Base::choose(s, [&](ActionId a) {
            const double n = this->model_.counts().n(s, a);
            double score = n > 0.0 ? this->q_(s, a) : untried_worth(s, a, this->at(s).here);
            score += bonus / (n + 1.0);
            if (!this->hints_.empty()) score += Base::hint_term(s, a);
            if (a == heading && !(n > 0.0)) score += 1e-9 * (std::fabs(score) + this->scale_step_);  // of equals: go on
            return score;
        });
    }

    /// For best(): what was never tried is no better than anything that was.
    [[nodiscard]] double value(StateId s, ActionId a) const noexcept {
        return this->model_.tried(s, a) ? this->q_(s, a) : -1e300;
    }

    // --- learning ---

    void episode_begun() noexcept {
        scale_.begin_episode();
        retrace_.begin_episode();
    }

    void learn(const Transition& t) {
        Base::begin_call();
        const StateId s = t.state;
        const bool told = this->goals_.contains(t.next);
        know(s, no_state);
        know(t.next, t.terminated || told ? no_state : s);
        const bool costs = scale_.costs();
        double before = this->at(s).value;
        const bool first = this->model_.observe(t);
        if (told) {
            scale_.observe_end(this->goals_.worth(t.next), true);
        } else if (t.terminated) {
            scale_.observe_end(t.reward, this->goals_.empty() && scale_.counts_as_goal(t.reward));
        } else {
            scale_.observe_step(t.reward, first);
        }
        this->scale_step_ = scale_.step_value();
        this->visits_.add(s, t.action);
        retrace_.observe(t);
        if (t.terminated || told) Base::remember_exit(s);
        if (first) Base::count_actions(s);
        if (scale_.costs() != costs) {
            Base::rescale();
            Base::go_on();  // before anything is backed up from levels that hold no longer
            before = this->at(s).value;
        }

        Base::earn();
        this->q_(s, t.action) = Base::backup(s, t.action);
        Base::for_each_legal(s, [&](ActionId b) {
            if (b != t.action && this->model_.tried(s, b)) this->q_(s, b) = Base::backup(s, b);
        });
        Base::renew_best(s);
        Base::pass_on(s, before);
        if (first && !scale_.goal_known()) look_back(t.next);
        Base::sweep();
        if (!t.terminated && !told) Base::follow_income();
        Base::go_on();
    }

    /// By entering s the agent may have learnt that an untried action there leads back.
    void look_back(StateId s) {
        if (this->at(s).open == 0) return;
        const double before = this->at(s).value;
        Base::renew_value(s);
        Base::pass_on(s, before);
    }

    void episode_ended() {
        const bool costs = scale_.costs();
        scale_.end_episode();
        retrace_.begin_episode();
        this->scale_step_ = scale_.step_value();
        if (scale_.goal_known()) this->model_.doubt_few();
        if (scale_.costs() != costs) Base::rescale();
        Base::renew();
        Base::go_on();
    }

    void goals_changed(const std::vector<Goal>& goals) {
        Base::begin_call();
        if (goals.empty()) {
            scale_.discover_goals();
        } else {
            scale_.told_goals();
        }
        this->goals_.set(goals, scale_);
        for (const Goal& goal : goals) {
            this->model_.counts().for_each_predecessor(goal.state,
                                                       [this](StateId s, double) { Base::remember_exit(s); });
        }
        this->scale_step_ = scale_.step_value();
        this->hints_.clear();
        Base::start_over();
        Base::go_on();
    }

    Retrace retrace_;
};

}  // namespace sspql
