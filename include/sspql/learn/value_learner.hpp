// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <sspql/core/assert.hpp>
#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/random.hpp>
#include <sspql/learn/action_selector.hpp>
#include <sspql/learn/exploration_bonus.hpp>
#include <sspql/learn/hints.hpp>
#include <sspql/learn/learner.hpp>
#include <sspql/learn/q_table.hpp>
#include <sspql/learn/schedule.hpp>
#include <sspql/learn/visit_counts.hpp>

namespace sspql {

/// The types every learner with a Q table is made of; derive and rename one to replace it.
struct ValuePolicies {
    using Selector = ActionSelector;
    using LegalActions = LegalActionTable;
};

/// Parameters every learner with a Q table has, by name. Defaults: the paper's gamma = alpha = 0.8, Q starts at 0, no
/// exploration bonus, eq. 8's uniform noise below 0.01.
template <class Policies>
struct ValueParams {
    double gamma = 0.8;                    ///< discount, in [0, 1]
    Schedule alpha = 0.8;                  ///< learning rate by visits of (s,a), in [0, 1]
    double initial_q = 0.0;                ///< Q of what was never tried; 1 is optimistic where the goal pays 1
    double w_exp = 0.0;                    ///< weight of the exploration bonus; the paper's is 0.1
    ExplorationBonus bonus{1.5};           ///< eq. 7
    Schedule hint_fading = VisitDecay{};   ///< of a trainer's hints, by visits of (s,a) since the hint
    typename Policies::Selector selector{};
    typename Policies::LegalActions legal_actions{};
};

/// What the learners with a Q table share: the table, visit counts, selection by
/// Q + w_exp Q_EXP + hints (eq. 8 without its SSP term), and the trainer.
///
/// For implementers (CRTP), besides Learner's: Derived may hide score(s, a), value(s, a) and add_states(n); it supplies
/// learn(t), episode_ended() and goals_changed(goals).
template <class Derived, class Policies, class ParamsType>
class ValueLearner : public Learner<Derived, typename Policies::LegalActions> {
    using Base = Learner<Derived, typename Policies::LegalActions>;
    static_assert(is_selector_v<typename Policies::Selector>,
                  "sspql: this Selector lacks `ActionId operator()(std::size_t actions, const Allowed&, const Score&, "
                  "Random&) const`");

public:
    using Params = ParamsType;

    /// A trainer's hint: in s, take a. `strength` adds to the action's score (a reached goal that pays 1 is worth up to
    /// 1; negative warns) and fades with the visits of (s,a) from now on. A new hint replaces the old one; 0 takes it
    /// back. The first hint allocates 16 bytes an (s,a).
    /// \throws std::invalid_argument for ids outside or a strength that is not finite; a growing learner admits s.
    void teach(StateId s, ActionId a, double strength = 1.0) {
        detail::require_action_of(a, Base::actions());
        require_finite("strength of a hint", strength);
        Base::grow_to(Base::admitted(s, Base::states(), "state"));
        hints_.set(s, a, strength, visits_(s, a), Base::states());
    }

    /// A demonstration: learns from the step like observe, and teaches its action.
    void demonstrate(const Transition& t, double strength = 1.0) {
        require_finite("strength of a hint", strength);
        Base::observe(t.state, t.action, t.reward, t.next, t.terminated, t.weight);
        teach(t.state, t.action, strength);
    }

    /// The terms of eq. 8 for (s,a). \throws std::invalid_argument for ids outside.
    [[nodiscard]] ActionTerms terms(StateId s, ActionId a) const {
        Base::require_known(s, a);
        return {q_(s, a), 0.0, bonus_term(s, a), hint_term(s, a), static_cast<double>(visits_(s, a))};
    }

    [[nodiscard]] const QTable& q() const noexcept { return q_; }
    [[nodiscard]] const VisitCounts& visits() const noexcept { return visits_; }
    [[nodiscard]] const Params& params() const noexcept { return params_; }

protected:
    /// \throws std::invalid_argument for parameters out of range.
    ValueLearner(StateCount states, std::size_t actions, Params params, std::uint64_t seed)
        : Base(states, actions, params.legal_actions),
          params_(std::move(params)),
          q_(states.initial(), actions, params_.initial_q),
          visits_(states.initial(), actions),
          hints_(actions),
          random_(seed, RandomStream::learner) {
        require_in("gamma", params_.gamma, 0.0, 1.0);
        require_in("alpha", params_.alpha.greatest(), 0.0, 1.0);
        require_not_negative("w_exp", params_.w_exp);
    }

    void add_states(std::size_t n) {
        q_.grow(n);
        visits_.grow(n);
    }

    void reserve_values(std::size_t states) {
        q_.reserve(states);
        visits_.reserve(states);
    }

    ActionId select(StateId s) {
        const Derived& self = static_cast<const Derived&>(*this);
        const auto& allowed = Base::legal().allowed(s);
        const ActionId chosen = params_.selector(
            Base::actions(), allowed, [&](ActionId a) { return self.score(s, a); }, random_);
        SSPQL_ASSERT(index(chosen) < Base::actions() && allowed.contains(chosen), "a Selector chooses an allowed action");
        return chosen;
    }

    [[nodiscard]] double score(StateId s, ActionId a) const noexcept {
        double sum = q_(s, a);
        if (params_.w_exp > 0.0) sum += bonus_term(s, a);
        if (!hints_.empty()) sum += hint_term(s, a);
        return sum;
    }

    [[nodiscard]] double value(StateId s, ActionId a) const noexcept { return q_(s, a); }

    /// The learning rate of (s,a); a constant one costs no look at the visits.
    [[nodiscard]] double rate(StateId s, ActionId a) const noexcept {
        return params_.alpha.constant() ? params_.alpha.greatest() : params_.alpha(visits_(s, a));
    }

    [[nodiscard]] double bonus_term(StateId s, ActionId a) const noexcept {
        return params_.w_exp * params_.bonus(visits_(s, a));
    }
    [[nodiscard]] double hint_term(StateId s, ActionId a) const noexcept {
        return hints_(s, a, visits_(s, a), params_.hint_fading);
    }

    /// Values, visits and hints as at the beginning: other goals pay from now on.
    void reset_values() {
        q_.reset();
        visits_.reset();
        hints_.clear();
    }

    Params params_;
    QTable q_;
    VisitCounts visits_;
    Hints hints_;
    Random random_;
};

}  // namespace sspql
