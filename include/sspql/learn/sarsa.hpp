// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/learn/value_learner.hpp>

namespace sspql {

template <class Policies>
class Sarsa;

/// Parameters of Sarsa.
template <class Policies = ValuePolicies>
struct SarsaParams : ValueParams<Policies> {
    /// The learner these are for, which Agent deduces.
    using Learner = Sarsa<Policies>;

    bool expected = false;  ///< expected Sarsa: the mean over a' instead of the one a' chosen

    template <class Archive>
    void serialize(Archive& archive) {
        ValueParams<Policies>::serialize(archive);
        archive(expected);
    }
};

/// Sarsa (Rummery and Niranjan 1994; Sutton and Barto 2018, section 6.4): learns the value of what it does, exploration
/// included: Q(s,a) += alpha [r + gamma Q(s',a') - Q(s,a)], a' the action chosen next. Where nobody chooses next (end of
/// a truncated episode, observe) a' is drawn from the selector for the update alone. Expected Sarsa (section 6.6) backs up
/// the mean of Q(s',a') over the selector's choice instead, and needs a Selector with an `expectation`.
///
/// Interface, errors and threads: Learner. A step is O(|A|). Another goal means starting over, as in QLearning.
template <class Policies = ValuePolicies>
class Sarsa : public ValueLearner<Sarsa<Policies>, Policies, SarsaParams<Policies>> {
    using Base = ValueLearner<Sarsa, Policies, SarsaParams<Policies>>;
    friend Base;
    friend Learner<Sarsa, typename Policies::LegalActions>;
    friend SerializationAccess;

public:
    /// Its parameters, by name.
    using Params = SarsaParams<Policies>;
    static constexpr const char* type_name = "Sarsa";  ///< in checkpoints

    /// Knows nothing yet. `seed` decides exploration.
    /// \throws std::invalid_argument for no states or actions, parameters out of range, or expected Sarsa with a Selector
    /// that has no expectation.
    Sarsa(StateCount states, std::size_t actions, Params params = {}, std::uint64_t seed = 0)
        : Base(states, actions, std::move(params), seed) {
        if (this->params_.expected && !has_expectation_v<Selector>) {
            throw_invalid("expected", "be false for a Selector without expectation()", true);
        }
    }

    /// Room for that many states in all, without allocation on the way there.
    void reserve(std::size_t states) { Base::reserve_values(states); }

    /// Records and edges of a model touched so far: none.
    [[nodiscard]] std::uint64_t model_operations() const noexcept { return 0; }

private:
    using Selector = typename Policies::Selector;

    ActionId advance(const Transition& t) {
        if (this->params_.expected) return Base::advance(t);
        const ActionId a = Base::select(t.next);
        update(t, this->q_(t.next, a));
        return a;
    }

    void learn(const Transition& t) {
        if (t.terminated) {
            update(t, 0.0);
        } else if (this->params_.expected) {
            update(t, expected_value(t.next));
        } else {
            update(t, this->q_(t.next, Base::select(t.next)));
        }
    }

    [[nodiscard]] double expected_value(StateId s) const {
        if constexpr (has_expectation_v<Selector>) {
            return this->params_.selector.expectation(
                Base::actions(), Base::legal().allowed(s), [&](ActionId a) { return Base::score(s, a); },
                [&](ActionId a) { return this->q_(s, a); });
        } else {
            return 0.0;  // refused by the constructor
        }
    }

    void update(const Transition& t, double future) {
        this->visits_.add(t.state, t.action);
        double& value = this->q_(t.state, t.action);
        const double alpha = this->params_.alpha(this->visits_(t.state, t.action));
        value += alpha * (t.reward + this->params_.gamma * future - value);
    }

    void episode_ended() noexcept {}

    void goals_changed(const std::vector<Goal>& /*goals*/) { Base::reset_values(); }
};

}  // namespace sspql
