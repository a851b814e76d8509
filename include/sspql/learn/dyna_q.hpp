// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/learn/last_outcomes.hpp>
#include <sspql/learn/model_learner.hpp>
#include <sspql/learn/q_update.hpp>

namespace sspql {

template <class Policies>
class DynaQ;

/// What a planning step of Dyna-Q replays.
enum class Replay : std::uint8_t {
    from_counts,  ///< an outcome drawn with its observed frequency, mean reward
    last_outcome  ///< what happened last, as in Sutton and Barto's deterministic mazes
};

/// Parameters of DynaQ.
template <class Policies = ModelPolicies>
struct DynaQParams : ModelParams<Policies> {
    /// The learner these are for, which Agent deduces.
    using Learner = DynaQ<Policies>;

    std::size_t planning_steps = 10;      ///< k, after each real step
    Replay replay = Replay::from_counts;  ///< what a planning step replays

    template <class Archive>
    void serialize(Archive& archive) {
        ModelParams<Policies>::serialize(archive);
        archive.size(planning_steps);
        archive(replay);
        archive.require(replay == Replay::from_counts || replay == Replay::last_outcome, "there is no such replay");
    }
};

/// Dyna-Q (Sutton 1990): after each real step, k planning steps: a (s,a) tried before, uniformly at random, an outcome
/// from the model, and the update of eq. 1 with it. With a pseudo-count kappa the outcome is `unknown_value` with
/// probability kappa / (N + kappa).
///
/// Interface, errors and threads: Learner. A planning step is O(out-degree + |A|).
template <class Policies = ModelPolicies>
class DynaQ : public ModelLearner<DynaQ<Policies>, Policies, DynaQParams<Policies>> {
    using Base = ModelLearner<DynaQ, Policies, DynaQParams<Policies>>;
    friend Base;
    friend ValueLearner<DynaQ, Policies, DynaQParams<Policies>>;
    friend Learner<DynaQ, typename Policies::LegalActions>;
    friend SerializationAccess;

public:
    /// Its parameters, by name.
    using Params = DynaQParams<Policies>;
    static constexpr const char* type_name = "Dyna-Q";  ///< in checkpoints

    /// Knows nothing yet. `seed` decides exploration and what is replayed.
    /// \throws std::invalid_argument for no states or actions, or parameters out of range.
    DynaQ(StateCount states, std::size_t actions, Params params = {}, std::uint64_t seed = 0)
        : Base(states, actions, std::move(params), seed), last_(actions) {}

    /// Room for `states` states and `pairs` distinct (s,s') in all (0: four a state).
    void reserve(std::size_t states, std::size_t pairs = 0) {
        Base::reserve(states, pairs);
        last_.reserve(states);
    }

private:
    static constexpr std::size_t most_at_once = 32;

    template <class Archive>
    void serialize(Archive& archive) {
        Base::serialize(archive);
        archive.section("outcomes", [&] {
            SerializationAccess::serialize(last_, archive, Base::states());
            for (std::size_t i = 0; i < last_.size(); ++i) {
                const Transition& t = last_.tried(i);
                archive.require(this->model_.counts().n(t.state, t.action) > 0, "an outcome is not in the model");
            }
            archive.require(last_.size() != 0 || this->model_.counts().pairs() == 0, "the list of outcomes is incomplete");
        });
    }

    void learn(const Transition& t) {
        Base::remember(t);
        last_.observe(t);
        update(t);
        std::size_t left = this->params_.planning_steps;
        if (this->params_.replay == Replay::from_counts && !(this->params_.kappa > 0.0)) {
            while (left > 0) {
                const std::size_t n = std::min(left, most_at_once);
                plan_at_once(n);
                left -= n;
            }
        }
        for (; left > 0; --left) plan();
    }

    /// The same as n <= most_at_once times plan(): draws, look-ups and outcomes do not depend on the values, so that
    /// those of several steps can wait for memory together.
    void plan_at_once(std::size_t n) {
        std::array<std::size_t, most_at_once> picks;
        std::array<double, most_at_once> draws;
        std::array<typename Base::Model::Drawn, most_at_once> outcomes;
        for (std::size_t i = 0; i < n; ++i) {
            picks[i] = this->random_.below(last_.size());
            draws[i] = this->random_.uniform();
            last_.prefetch(picks[i]);
        }
        for (std::size_t i = 0; i < n; ++i) {
            const Transition& seen = last_.tried(picks[i]);
            this->model_.counts().prefetch(seen.state, seen.action);
            this->q_.prefetch(seen.state);
        }
        for (std::size_t i = 0; i < n; ++i) {
            const Transition& seen = last_.tried(picks[i]);
            outcomes[i] = this->model_.draw(seen.state, seen.action, draws[i]);
            this->q_.prefetch(outcomes[i].next);
        }
        for (std::size_t i = 0; i < n; ++i) {
            const Transition& seen = last_.tried(picks[i]);
            const auto& [cell, next] = outcomes[i];
            update({seen.state, seen.action, cell->reward_sum / cell->count(), next, cell->terminal(), 1.0});
        }
    }

    void plan() {
        const Transition& seen = last_.tried(this->random_.below(last_.size()));
        if (this->params_.replay == Replay::last_outcome) {
            this->model_.count_operation();
            update(seen);
            return;
        }
        if (this->params_.kappa > 0.0) {
            const double n = this->model_.counts().n(seen.state, seen.action);
            if (this->random_.chance(this->params_.kappa / (n + this->params_.kappa))) {
                this->model_.count_operation();
                update({seen.state, seen.action, this->params_.unknown_value, seen.state, true, 1.0});
                return;
            }
        }
        update(this->model_.sample(seen.state, seen.action, this->random_));
    }

    void update(const Transition& t) {
        q_update(this->q_, t, Base::rate(t.state, t.action), this->params_.gamma, Base::legal());
    }

    LastOutcomes last_;
};

}  // namespace sspql
