// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/core/step_budget.hpp>
#include <sspql/learn/goal_book.hpp>
#include <sspql/learn/q_update.hpp>
#include <sspql/learn/value_learner.hpp>
#include <sspql/model/probability.hpp>
#include <sspql/model/transition_counts.hpp>
#include <sspql/paths/auto_queue.hpp>
#include <sspql/paths/cost.hpp>
#include <sspql/paths/queue.hpp>
#include <sspql/paths/shortest_paths.hpp>
#include <sspql/paths/ssp_planner.hpp>
#include <sspql/paths/ssp_values.hpp>

namespace sspql {

/// The types an Sspql is made of; derive and rename one to replace it:
///
///     struct MyPolicies : sspql::SspqlPolicies { using Cost = sspql::ExpectedTries; };
///     sspql::Sspql<MyPolicies> learner(states, actions);
struct SspqlPolicies : ValuePolicies {
    using Cell = CountCell;              ///< what is kept of an (s,a,s')
    using Probability = SumOverActions;  ///< P(s'|s) from counts, eq. 3
    using Cost = RiskWeighted;           ///< of an edge, eq. 2
    using Queue = AutoQueue<>;           ///< of the searches
};

template <class Policies>
class Sspql;

/// Parameters of Sspql, by name. The defaults are the paper's, one set for all its tasks: gamma = alpha = 0.8, lambda 2,
/// w_Q 1, w_SSP = min(1, N^-2), w_EXP 0.1, eta 1.5, noise below 0.01. The other columns of Table 1 are presets.
template <class Policies = SspqlPolicies>
struct SspqlParams : ValueParams<Policies> {
    /// The learner these are for, which Agent deduces.
    using Learner = Sspql<Policies>;

    double w_q = 1.0;                   ///< weight of Q
    double w_ssp = 1.0;                 ///< weight of Q_SSP, times ssp_decay; 0 switches the planner off
    Schedule ssp_decay = VisitDecay{};  ///< eq. 9, by visits of (s,a) since the goals were set
    /// How P(s'|s) comes from the counts, eq. 3.
    typename Policies::Probability probability{};
    typename Policies::Cost cost{};  ///< eq. 2; lambda is in it
    double path_tolerance = 0.0;     ///< costs off by no more than this share stay; 0.01 makes an episode's end cheap
    std::uint64_t path_budget = 0;   ///< edges touched per step for the paths; 0: all at the episode's end

    template <class Archive>
    void serialize(Archive& archive) {
        ValueParams<Policies>::serialize(archive);
        archive(w_q, w_ssp, ssp_decay);
        archive.policy("probability", probability);
        archive.policy("cost", cost);
        archive(path_tolerance, path_budget);
    }

    SspqlParams() { this->w_exp = 0.1; }

    /// All three terms: the defaults, Table 1's "SSPQL with exploration bonus".
    [[nodiscard]] static SspqlParams with_bonus() { return {}; }

    /// Q and Q_SSP: Table 1's "SSPQL".
    [[nodiscard]] static SspqlParams without_bonus() {
        SspqlParams params;
        params.w_exp = 0.0;
        return params;
    }

    /// Q_SSP alone: Table 1's "SSP".
    [[nodiscard]] static SspqlParams ssp_only() {
        SspqlParams params = without_bonus();
        params.w_q = 0.0;
        return params;
    }

    /// Q alone: Table 1's "Q-learning". Acts like QLearning, to the bit.
    [[nodiscard]] static SspqlParams q_only() {
        SspqlParams params = without_bonus();
        params.w_ssp = 0.0;
        return params;
    }

    /// Table 1's weights read literally: w_SSP stays 1. Known to livelock: a blocked action on the shortest path is
    /// repeated for ever. For comparison only.
    [[nodiscard]] static SspqlParams constant_weight() {
        SspqlParams params = without_bonus();
        params.ssp_decay = Constant{1.0};
        return params;
    }
};

/// Stochastic shortest path-based Q-learning: Algorithms 1 and 2 of Kwon, Suh and Lee (2011).
///
/// Every step records the transition (eqs. 3, 4) and updates Q (eq. 1); every episode's end refreshes the expected costs
/// (eq. 2), finds the shortest paths from all states to the goals, and turns them into Q_SSP (eq. 5). Actions are chosen
/// by w_Q Q + w_SSP(N) Q_SSP + w_EXP Q_EXP plus noise (eq. 8). Goals: GoalBook.
///
/// Interface, errors and threads: Learner. A step is O(|A|) and, after reserve(), allocates nothing, except for the
/// first weight other than 1, for masks, and beyond 32 successors of a state or 8 actions. An episode's end looks at
/// states visited since the last one and those whose path changes, or at all where these are many: O(m + n log n) at
/// most for n states and m distinct (s,s'), with the same result to the bit (PathSolver).
///
/// With a path_tolerance eps > 0 paths cost at most (1 + eps) / (1 - eps) times the optimum, and far fewer states
/// change (CostPublisher). With a path_budget no call but set_goals and update_paths does more for the paths than that
/// many touches and one state's edges: an episode's end starts a solve unless one is under way, each step or observe
/// goes on with it, and the paths in use stay the last finished ones until the new ones are complete (SspPlanner). Give
/// it a few times the average number of edges a state has, and reserve(): growing memory is not bounded.
///
/// With step costs every state that ends an episode counts as a goal (GoalBook): where there are hazards too, set_goals.
/// Known limits of the method: an edge's cost is bounded, so a blocked edge is never dropped; paths are renewed only
/// when an episode ends (with a path_budget, some steps after that); one successor per edge counts, so a hazard beside
/// the path costs nothing.
/// Deviation: N(s,a) in eq. 9 counts visits since the goals were last set, so that a new goal is followed at once.
template <class Policies = SspqlPolicies>
class Sspql : public ValueLearner<Sspql<Policies>, Policies, SspqlParams<Policies>> {
    using Base = ValueLearner<Sspql, Policies, SspqlParams<Policies>>;
    friend Base;
    friend Learner<Sspql, typename Policies::LegalActions>;
    friend SerializationAccess;
    static_assert(detail::QueueRequirements<typename Policies::Queue>::met);

public:
    /// Its parameters, by name.
    using Params = SspqlParams<Policies>;
    static constexpr const char* type_name = "SSPQL";  ///< in checkpoints
    /// What it counts in.
    using Counts = TransitionCounts<typename Policies::Cell>;

    /// Knows nothing yet. `seed` decides the noise of eq. 8.
    /// \throws std::invalid_argument for no states or actions (StateCount::growing() starts with none), gamma or alpha
    /// outside [0, 1], a schedule for w_SSP above 1 (eq. 9), negative weights, a path_tolerance outside [0, 0.5],
    /// a path_budget above 10^15, or parameters that are not finite.
    Sspql(StateCount states, std::size_t actions, Params params = {}, std::uint64_t seed = 0)
        : Base(states, actions, std::move(params), seed),
          counts_(states.initial(), actions),
          goals_(states.initial()),
          planner_(Base::params_.cost, Base::params_.probability, Base::params_.path_tolerance),
          budget_(in_instalments() ? StepBudget(Base::params_.path_budget, Base::params_.path_budget)
                                   : StepBudget::unlimited()) {
        const Params& p = Base::params_;
        require_not_negative("w_q", p.w_q);
        require_not_negative("w_ssp", p.w_ssp);
        require_in("w_SSP's schedule (eq. 9)", p.ssp_decay.greatest(), 0.0, 1.0);
    }

    /// Room for `states` states and `pairs` distinct (s,s') in all (0: four a state).
    void reserve(std::size_t states, std::size_t pairs = 0) {
        Base::reserve_values(states);
        pairs = pairs == 0 ? 4 * states : pairs;
        counts_.reserve(states, pairs);
        goals_.reserve(states);
        planner_.reserve(states, in_instalments() ? pairs : 0);
    }

    /// The terms of eq. 8 for (s,a). \throws std::invalid_argument for ids outside.
    [[nodiscard]] ActionTerms terms(StateId s, ActionId a) const {
        Base::require_known(s, a);
        return {this->params_.w_q * this->q_(s, a), ssp_term(s, a), bonus_term(s, a), Base::hint_term(s, a),
                static_cast<double>(counts_.n(s, a))};
    }

    /// Renews the shortest paths and Q_SSP now (Algorithm 1) instead of at the episode's end, all at once whatever the
    /// path_budget. O(m + n log n).
    void update_paths() {
        if (this->params_.w_ssp != 0.0) planner_.update(counts_, goals_.goals(), Base::legal());
    }

    /// What was observed.
    [[nodiscard]] const Counts& counts() const noexcept { return counts_; }

    /// The goals that hold now.
    [[nodiscard]] std::vector<Goal> goals() const { return goals_.goals(); }

    /// The shortest paths as of the last update; states added since are not in it.
    [[nodiscard]] const ShortestPathTree& tree() const noexcept { return planner_.tree(); }

    /// Q_SSP as of the last update.
    [[nodiscard]] const SspValues& ssp_values() const noexcept { return planner_.values(); }

    /// Records and edges of the model touched so far: a record each step, at most a few looks at each edge a solve.
    [[nodiscard]] std::uint64_t model_operations() const noexcept { return records_ + planner_.edges_touched(); }

private:
    template <class Archive>
    void serialize(Archive& archive) {
        Base::serialize(archive);
        archive.section("model", [&] { archive(counts_, records_); });
        archive.section("goals", [&] { archive(goals_); });
        archive.section("paths", [&] {
            SerializationAccess::serialize(planner_, archive, counts_);
            archive(budget_);
        });
    }

    void add_states(std::size_t n) {
        Base::add_states(n);
        counts_.grow(n);
        goals_.grow(n);
    }

    [[nodiscard]] double ssp_term(StateId s, ActionId a) const noexcept {
        return this->params_.w_ssp * this->params_.ssp_decay(this->visits_(s, a)) * planner_.values()(s, a);
    }

    [[nodiscard]] double bonus_term(StateId s, ActionId a) const noexcept {
        return this->params_.w_exp * this->params_.bonus(static_cast<std::uint64_t>(counts_.n(s, a)));
    }

    [[nodiscard]] double score(StateId s, ActionId a) const noexcept {
        double sum = value(s, a);
        if (this->params_.w_exp > 0.0) sum += bonus_term(s, a);
        if (!this->hints_.empty()) sum += Base::hint_term(s, a);
        return sum;
    }

    [[nodiscard]] double value(StateId s, ActionId a) const noexcept {
        const double q = this->params_.w_q * this->q_(s, a);
        return planner_.values().action(s) == a ? q + ssp_term(s, a) : q;
    }

    void learn(const Transition& t) {
        ++records_;
        counts_.record(t.state, t.action, t.next, t.terminated, t.reward, t.weight);
        this->visits_.add(t.state, t.action);
        q_update(this->q_, t, this->params_.alpha(this->visits_(t.state, t.action)), this->params_.gamma,
                 Base::legal());
        goals_.observe(t);
        if (in_instalments()) {
            budget_.earn();
            planner_.advance(counts_, Base::legal(), budget_);
        }
    }

    void episode_ended() {
        if (!in_instalments()) {
            update_paths();
        } else if (!planner_.running()) {
            planner_.start(counts_, goals_.goals());
        }
    }

    void legal_actions_changed(StateId s) { planner_.mask_changed(s); }  // counts from the next update on

    void goals_changed(const std::vector<Goal>& goals) {
        goals_.set(goals);
        Base::reset_values();
        update_paths();
    }

    [[nodiscard]] bool in_instalments() const noexcept {
        return this->params_.path_budget != 0 && this->params_.w_ssp != 0.0;
    }

    Counts counts_;
    GoalBook goals_;
    // A Queue that is none was refused above; that stays the only error.
    using Queue = std::conditional_t<is_queue_v<typename Policies::Queue>, typename Policies::Queue, AutoQueue<>>;
    SspPlanner<typename Policies::Cost, typename Policies::Probability, Queue> planner_;
    StepBudget budget_;
    std::uint64_t records_ = 0;
};

/// The paper's method with its preset: `Agent robot(states, actions, sspql::paper());`
[[nodiscard]] inline SspqlParams<> paper() { return {}; }

}  // namespace sspql
