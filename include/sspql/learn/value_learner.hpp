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
#include <sspql/learn/q_table.hpp>
#include <sspql/learn/schedule.hpp>
#include <sspql/learn/taught_learner.hpp>

namespace sspql {

/// The types every learner with a Q table is made of; derive and rename one to replace it.
struct ValuePolicies {
    using Selector = ActionSelector;        ///< how actions are chosen
    using LegalActions = LegalActionTable;  ///< which actions a state has
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
    /// Eq. 8's noise, or another way to explore.
    typename Policies::Selector selector{};
    /// Which actions a state has.
    typename Policies::LegalActions legal_actions{};

    template <class Archive>
    void serialize(Archive& archive) {
        archive(gamma, alpha, initial_q, w_exp, bonus, hint_fading);
        archive.policy("selector", selector);
        archive.policy("legal actions", legal_actions);
    }
};

/// What the learners with a Q table share: the table, visit counts, selection by
/// Q + w_exp Q_EXP + hints (eq. 8 without its SSP term), and the trainer.
///
/// For implementers (CRTP), besides Learner's: Derived may hide score(s, a), value(s, a) and add_states(n); it supplies
/// learn(t), episode_ended() and goals_changed(goals).
template <class Derived, class Policies, class ParamsType>
class ValueLearner : public TaughtLearner<Derived, Policies, ParamsType> {
    using Base = TaughtLearner<Derived, Policies, ParamsType>;

public:
    /// The terms of eq. 8 for (s,a). \throws std::invalid_argument for ids outside.
    [[nodiscard]] ActionTerms terms(StateId s, ActionId a) const {
        Base::require_known(s, a);
        return {q_(s, a), 0.0, bonus_term(s, a), Base::hint_term(s, a), static_cast<double>(visits_(s, a))};
    }

    /// Q(s,a) as learnt so far.
    [[nodiscard]] const QTable& q() const noexcept { return q_; }

protected:
    /// \throws std::invalid_argument for parameters out of range.
    ValueLearner(StateCount states, std::size_t actions, ParamsType params, std::uint64_t seed)
        : Base(states, actions, std::move(params), seed), q_(states.initial(), actions, params_.initial_q) {
        require_in("gamma", params_.gamma, 0.0, 1.0);
        require_in("alpha", params_.alpha.greatest(), 0.0, 1.0);
        require_not_negative("w_exp", params_.w_exp);
    }

    template <class Archive>
    void serialize(Archive& archive) {
        Base::serialize(archive);
        archive.section("values", [&] { archive(q_); });
    }

    void add_states(std::size_t n) {
        Base::add_states(n);
        q_.grow(n);
    }

    void reserve_values(std::size_t states) {
        Base::reserve_visits(states);
        q_.reserve(states);
    }

    ActionId select(StateId s) {
        const Derived& self = static_cast<const Derived&>(*this);
        return Base::choose(s, [&](ActionId a) { return self.score(s, a); });
    }

    [[nodiscard]] double score(StateId s, ActionId a) const noexcept {
        double sum = q_(s, a);
        if (params_.w_exp > 0.0) sum += bonus_term(s, a);
        if (!hints_.empty()) sum += Base::hint_term(s, a);
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

    /// Values, visits and hints as at the beginning: other goals pay from now on.
    void reset_values() {
        q_.reset();
        visits_.reset();
        hints_.clear();
    }

    QTable q_;

    using Base::hints_;
    using Base::params_;
    using Base::visits_;
};

}  // namespace sspql
