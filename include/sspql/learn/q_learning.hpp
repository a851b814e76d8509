// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/learn/q_update.hpp>
#include <sspql/learn/value_learner.hpp>

namespace sspql {

template <class Policies>
class QLearning;

/// Parameters of QLearning.
template <class Policies = ValuePolicies>
struct QLearningParams : ValueParams<Policies> {
    /// The learner these are for, which Agent deduces.
    using Learner = QLearning<Policies>;
};

/// Q-learning (Watkins 1989; eq. 1 of Kwon, Suh and Lee 2011), without a model: the baseline. Chooses by
/// Q + w_exp Q_EXP. Interface, errors and threads: Learner. A step is O(|A|); memory 12 bytes an (s,a).
///
/// Without a model another goal means starting over: set_goals resets the values and the visit counts; which goals
/// those are it does not use.
template <class Policies = ValuePolicies>
class QLearning : public ValueLearner<QLearning<Policies>, Policies, QLearningParams<Policies>> {
    using Base = ValueLearner<QLearning, Policies, QLearningParams<Policies>>;
    friend Base;
    friend Learner<QLearning, typename Policies::LegalActions>;
    friend SerializationAccess;

public:
    /// Its parameters, by name.
    using Params = QLearningParams<Policies>;
    static constexpr const char* type_name = "Q-learning";  ///< in checkpoints

    /// Knows nothing yet. `seed` decides exploration.
    /// \throws std::invalid_argument for no states or actions (StateCount::growing() starts with none), gamma outside
    /// [0, 1], alpha outside [0, 1], or parameters that are not finite.
    QLearning(StateCount states, std::size_t actions, Params params = {}, std::uint64_t seed = 0)
        : Base(states, actions, std::move(params), seed) {}

    /// Room for this many states in all, without allocation on the way there.
    void reserve(std::size_t states) { Base::reserve_values(states); }

    /// Records and edges of a model touched so far: none.
    [[nodiscard]] std::uint64_t model_operations() const noexcept { return 0; }

private:
    void learn(const Transition& t) {
        this->visits_.add(t.state, t.action);
        q_update(this->q_, t, this->params_.alpha(this->visits_(t.state, t.action)), this->params_.gamma,
                 Base::legal());
    }

    void episode_ended() noexcept {}

    void goals_changed(const std::vector<Goal>& /*goals*/) { Base::reset_values(); }
};

}  // namespace sspql
