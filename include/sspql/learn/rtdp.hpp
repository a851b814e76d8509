// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/learn/model_learner.hpp>

namespace sspql {

template <class Policies>
class Rtdp;

/// Parameters of Rtdp. alpha is not used: backups are full.
template <class Policies = ModelPolicies>
struct RtdpParams : ModelParams<Policies> {
    /// The learner these are for, which Agent deduces.
    using Learner = Rtdp<Policies>;
};

/// Adaptive real-time dynamic programming (Barto, Bradtke and Singh 1995), on the learnt model: after each step a full
/// expected backup of every action tried in the state just left, the only state updated.
///
/// Interface, errors and threads: Learner. A step is O(out-degree x |A|^2).
template <class Policies = ModelPolicies>
class Rtdp : public ModelLearner<Rtdp<Policies>, Policies, RtdpParams<Policies>> {
    using Base = ModelLearner<Rtdp, Policies, RtdpParams<Policies>>;
    friend Base;
    friend ValueLearner<Rtdp, Policies, RtdpParams<Policies>>;
    friend Learner<Rtdp, typename Policies::LegalActions>;
    friend SerializationAccess;

public:
    /// Its parameters, by name.
    using Params = RtdpParams<Policies>;
    static constexpr const char* type_name = "RTDP";  ///< in checkpoints

    /// Knows nothing yet. `seed` decides exploration.
    /// \throws std::invalid_argument for no states or actions, or parameters out of range.
    Rtdp(StateCount states, std::size_t actions, Params params = {}, std::uint64_t seed = 0)
        : Base(states, actions, std::move(params), seed) {}

private:
    void learn(const Transition& t) {
        Base::remember(t);
        for (std::size_t a = 0; a < Base::actions(); ++a) {
            if (this->model_.counts().n(t.state, action_id(a)) > 0) Base::back_up(t.state, action_id(a));
        }
    }
};

}  // namespace sspql
