// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/learn/sweeping_learner.hpp>

namespace sspql {

template <class Policies>
class PrioritizedSweeping;

/// Parameters of PrioritizedSweeping. alpha is not used: backups are full.
template <class Policies = ModelPolicies>
struct PrioritizedSweepingParams : ModelParams<Policies> {
    /// The learner these are for, which Agent deduces.
    using Learner = PrioritizedSweeping<Policies>;

    std::size_t planning_steps = 10;  ///< backups after each real step, at most
    double threshold = 1e-4;          ///< smaller changes are not passed on

    template <class Archive>
    void serialize(Archive& archive) {
        ModelParams<Policies>::serialize(archive);
        archive.size(planning_steps);
        archive(threshold);
    }

    /// Q starts at 1, at most 5 observations count, pseudo-count 0.05: the strong baseline for goals that pay 1.
    [[nodiscard]] static PrioritizedSweepingParams optimistic() {
        PrioritizedSweepingParams params;
        params.initial_q = 1.0;
        params.cap = 5.0;
        params.kappa = 0.05;
        return params;
    }
};

/// Prioritized sweeping (Moore and Atkeson 1993): after each step, full expected backups where values are most out of
/// date, found through predecessor lists and an indexed heap; never a scan over all (s,a). A changed max_a Q(s,a) raises
/// every (u,b) that leads to s to the priority gamma P(s|u,b) |change|.
///
/// Interface, errors and threads: Learner. A backup is O(degrees x |A| + log n), whatever the number of states.
template <class Policies = ModelPolicies>
class PrioritizedSweeping
    : public SweepingLearner<PrioritizedSweeping<Policies>, Policies, PrioritizedSweepingParams<Policies>> {
    using Base = SweepingLearner<PrioritizedSweeping, Policies, PrioritizedSweepingParams<Policies>>;
    friend Base;
    friend ModelLearner<PrioritizedSweeping, Policies, PrioritizedSweepingParams<Policies>>;
    friend ValueLearner<PrioritizedSweeping, Policies, PrioritizedSweepingParams<Policies>>;
    friend Learner<PrioritizedSweeping, typename Policies::LegalActions>;
    friend SerializationAccess;

public:
    /// Its parameters, by name.
    using Params = PrioritizedSweepingParams<Policies>;
    static constexpr const char* type_name = "prioritized sweeping";  ///< in checkpoints

    /// Knows nothing yet. `seed` decides exploration.
    /// \throws std::invalid_argument for no states or actions, or parameters out of range.
    PrioritizedSweeping(StateCount states, std::size_t actions, Params params = {}, std::uint64_t seed = 0)
        : Base(states, actions, std::move(params), seed) {
        require_not_negative("threshold", this->params_.threshold);
    }

private:
    void learn(const Transition& t) {
        Base::remember(t);
        const double expected =
            this->model_.backup(t.state, t.action, this->q_, this->params_, Base::legal());
        const double change = std::fabs(expected - this->q_(t.state, t.action));
        if (change > this->params_.threshold) this->queue_.raise(t.state, t.action, change);
        for (std::size_t k = 0; k < this->params_.planning_steps && !this->queue_.empty(); ++k) Base::sweep_one();
    }

    [[nodiscard]] bool sweeps(StateId /*u*/, ActionId /*b*/) const noexcept { return true; }
};

}  // namespace sspql
