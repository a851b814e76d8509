// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/learn/reward_model.hpp>
#include <sspql/learn/value_learner.hpp>

namespace sspql {

/// What the learners share that plan on a learnt model of transitions and rewards. For implementers (CRTP): Derived
/// supplies learn(t), and may hide add_states(n), episode_ended() and goals_changed(goals).
///
/// The model knows rewards, not goals: after set_goals the values are reset, and the rewards seen so far are planned
/// from again as they come up; which goals those are is not used.
template <class Derived, class Policies, class ParamsType>
class ModelLearner : public ValueLearner<Derived, Policies, ParamsType> {
    using Base = ValueLearner<Derived, Policies, ParamsType>;

public:
    /// What it plans with.
    using Model = RewardModel<typename Policies::Cell>;

    /// Room for `states` states and `pairs` distinct (s,s') in all (0: four a state).
    void reserve(std::size_t states, std::size_t pairs = 0) {
        Base::reserve_values(states);
        model_.reserve(states, pairs == 0 ? 4 * states : pairs);
    }

    /// What was observed.
    [[nodiscard]] const typename Model::Counts& counts() const noexcept { return model_.counts(); }

    /// Records and edges of the model touched so far.
    [[nodiscard]] std::uint64_t model_operations() const noexcept { return model_.operations(); }

protected:
    ModelLearner(StateCount states, std::size_t actions, ParamsType params, std::uint64_t seed)
        : Base(states, actions, std::move(params), seed), model_(states.initial(), actions) {
        this->params_.validate();
    }

    template <class Archive>
    void serialize(Archive& archive) {
        Base::serialize(archive);
        archive.section("model", [&] { archive(model_); });
    }

    void add_states(std::size_t n) {
        Base::add_states(n);
        model_.grow(n);
    }

    void episode_ended() noexcept {}

    void goals_changed(const std::vector<Goal>& /*goals*/) { Base::reset_values(); }

    /// Visits and model take the step in.
    void remember(const Transition& t) {
        this->visits_.add(t.state, t.action);
        model_.observe(t, this->params_);
    }

    /// Sets Q(s,a) to its expected value under the model. \returns how much max_a Q(s,a) moved.
    double back_up(StateId s, ActionId a) {
        const double before = this->q_.legal_max(s, Base::legal());
        this->q_(s, a) = model_.backup(s, a, this->q_, this->params_, Base::legal());
        const double moved = this->q_.legal_max(s, Base::legal()) - before;
        return moved < 0.0 ? -moved : moved;
    }

    Model model_;
};

}  // namespace sspql
