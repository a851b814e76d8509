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
class RMax;

/// Parameters of RMax. alpha is not used: backups are full. initial_q, the value of what is unknown (R_max / (1 - gamma)
/// in the source), is 1: right for tasks that pay 1 once, at the goal.
template <class Policies = ModelPolicies>
struct RMaxParams : ModelParams<Policies> {
    /// The learner these are for, which Agent deduces.
    using Learner = RMax<Policies>;

    std::size_t known_after = 3;  ///< m: an (s,a) is unknown, and worth initial_q, until tried so often
    double threshold = 1e-4;      ///< planning stops when no value is further off

    template <class Archive>
    void serialize(Archive& archive) {
        ModelParams<Policies>::serialize(archive);
        archive.size(known_after);
        archive(threshold);
    }

    RMaxParams() { this->initial_q = 1.0; }
};

/// R-Max (Brafman and Tennenholtz 2002): what was tried fewer than m times is worth the most there is; an (s,a) that
/// becomes known is planned with, to convergence. The first m outcomes of an (s,a) are its model for good, unless a cap
/// lets them fade: then the model goes on learning, and so does planning, at every step.
/// After set_goals everything is unknown again, and each (s,a) is learnt anew once it is tried.
///
/// Interface, errors and threads: Learner. A step that makes something known costs as many backups as values move (by
/// prioritized sweeping), any other O(|A|).
template <class Policies = ModelPolicies>
class RMax : public SweepingLearner<RMax<Policies>, Policies, RMaxParams<Policies>> {
    using Base = SweepingLearner<RMax, Policies, RMaxParams<Policies>>;
    friend Base;
    friend ModelLearner<RMax, Policies, RMaxParams<Policies>>;
    friend ValueLearner<RMax, Policies, RMaxParams<Policies>>;
    friend Learner<RMax, typename Policies::LegalActions>;
    friend SerializationAccess;

public:
    /// Its parameters, by name.
    using Params = RMaxParams<Policies>;
    static constexpr const char* type_name = "R-Max";  ///< in checkpoints

    /// Knows nothing yet. `seed` decides exploration.
    /// \throws std::invalid_argument for no states or actions, or parameters out of range.
    RMax(StateCount states, std::size_t actions, Params params = {}, std::uint64_t seed = 0)
        : Base(states, actions, std::move(params), seed) {
        if (this->params_.known_after == 0) throw_invalid("known_after", "be at least 1", 0);
        require_positive("threshold", this->params_.threshold);
        require_in("gamma", this->params_.gamma, 0.0, 0.999999);
    }

    /// Whether (s,a) was tried often enough to be planned with.
    [[nodiscard]] bool known(StateId s, ActionId a) const {
        Base::require_known(s, a);
        return this->visits_(s, a) >= this->params_.known_after;
    }

private:
    void learn(const Transition& t) {
        const std::uint32_t before = this->visits_(t.state, t.action);
        if (before >= this->params_.known_after && this->params_.cap == 0.0) {
            this->visits_.add(t.state, t.action);
            return;
        }
        if (before == 0 && this->model_.counts().n(t.state, t.action) > 0) this->model_.forget(t.state, t.action);
        Base::remember(t);
        if (this->visits_(t.state, t.action) < this->params_.known_after) return;
        this->queue_.raise(t.state, t.action, 1.0);
        while (!this->queue_.empty()) Base::sweep_one();
    }

    [[nodiscard]] bool sweeps(StateId u, ActionId b) const noexcept {
        return this->visits_(u, b) >= this->params_.known_after;
    }
};

}  // namespace sspql
