// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/random.hpp>
#include <sspql/learn/action_selector.hpp>
#include <sspql/learn/exploration_bonus.hpp>
#include <sspql/learn/learner.hpp>
#include <sspql/learn/q_table.hpp>
#include <sspql/learn/q_update.hpp>
#include <sspql/learn/schedule.hpp>
#include <sspql/learn/visit_counts.hpp>

namespace sspql {

/// The types a QLearning is made of; derive and rename one to replace it.
struct QLearningPolicies {
    using Selector = ActionSelector;
    using LegalActions = LegalActionTable;
};

template <class Policies>
class QLearning;

/// Parameters of QLearning, by name. Defaults: the paper's gamma = alpha = 0.8, Q starts at 0, no exploration bonus,
/// eq. 8's uniform noise below 0.01.
template <class Policies = QLearningPolicies>
struct QLearningParams {
    using Learner = QLearning<Policies>;

    double gamma = 0.8;           ///< discount, in [0, 1]
    Schedule alpha = 0.8;         ///< learning rate by N(s,a), in [0, 1]
    double initial_q = 0.0;       ///< 1 is optimistic where the goal pays 1
    double w_exp = 0.0;           ///< weight of the exploration bonus; the paper's is 0.1
    ExplorationBonus bonus{1.5};  ///< eq. 7
    typename Policies::Selector selector{};
    typename Policies::LegalActions legal_actions{};
};

/// Q-learning (Watkins 1989; eq. 1 of Kwon, Suh and Lee 2011), without a model: the baseline. Chooses by
/// Q + w_exp Q_EXP. Interface, errors and threads: Learner. A step is O(|A|); memory 12 bytes an (s,a).
///
/// Without a model another goal means starting over: set_goals resets the values and the visit counts; which goals
/// those are it does not use.
template <class Policies = QLearningPolicies>
class QLearning : public Learner<QLearning<Policies>, typename Policies::LegalActions> {
    using Base = Learner<QLearning, typename Policies::LegalActions>;
    friend Base;
    static_assert(is_selector_v<typename Policies::Selector>,
                  "sspql: this Selector lacks `ActionId operator()(std::size_t actions, const Allowed&, const Score&, "
                  "Random&) const`");

public:
    using Params = QLearningParams<Policies>;

    /// \throws std::invalid_argument for no states or actions (StateCount::growing() starts with none), gamma outside
    /// [0, 1], alpha outside [0, 1], or parameters that are not finite.
    QLearning(StateCount states, std::size_t actions, Params params = {}, std::uint64_t seed = 0)
        : Base(states, actions, std::move(params.legal_actions)),
          params_(std::move(params)),
          q_(states.initial(), actions, params_.initial_q),
          visits_(states.initial(), actions),
          random_(seed, RandomStream::learner) {
        detail::require_q_params(params_);
    }

    /// Room for this many states in all, without allocation on the way there.
    void reserve(std::size_t states) {
        q_.reserve(states);
        visits_.reserve(states);
    }

    /// The terms of eq. 8 for (s,a); ssp is 0.
    /// \throws std::invalid_argument for ids outside.
    [[nodiscard]] ActionTerms terms(StateId s, ActionId a) const {
        Base::require_known(s, a);
        const std::uint32_t n = visits_(s, a);
        return {q_(s, a), 0.0, params_.w_exp * params_.bonus(n), static_cast<double>(n)};
    }

    [[nodiscard]] const QTable& q() const noexcept { return q_; }
    [[nodiscard]] const VisitCounts& visits() const noexcept { return visits_; }
    [[nodiscard]] const Params& params() const noexcept { return params_; }

    /// Records and edges of a model touched so far: none.
    [[nodiscard]] std::uint64_t model_operations() const noexcept { return 0; }

private:
    void add_states(std::size_t n) {
        q_.grow(n);
        visits_.grow(n);
    }

    ActionId select(StateId s) {
        return params_.selector(
            Base::actions(), Base::legal().allowed(s),
            [&](ActionId a) {
                return params_.w_exp > 0.0 ? q_(s, a) + params_.w_exp * params_.bonus(visits_(s, a)) : q_(s, a);
            },
            random_);
    }

    void learn(const Transition& t) {
        visits_.add(t.state, t.action);
        q_update(q_, t, params_.alpha(visits_(t.state, t.action)), params_.gamma, Base::legal());
    }

    void episode_ended() noexcept {}

    [[nodiscard]] double value(StateId s, ActionId a) const noexcept { return q_(s, a); }

    void goals_changed(const std::vector<Goal>& /*goals*/) {
        q_.reset();
        visits_.reset();
    }

    Params params_;
    QTable q_;
    VisitCounts visits_;
    Random random_;
};

}  // namespace sspql
