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
#include <sspql/learn/last_outcomes.hpp>
#include <sspql/learn/q_update.hpp>
#include <sspql/learn/value_learner.hpp>

namespace sspql {

template <class Policies>
class DynaQPlus;

/// Parameters of DynaQPlus.
template <class Policies = ValuePolicies>
struct DynaQPlusParams : ValueParams<Policies> {
    /// The learner these are for, which Agent deduces.
    using Learner = DynaQPlus<Policies>;

    std::size_t planning_steps = 10;  ///< k, after each real step
    double time_bonus = 1e-4;         ///< reward for what was not tried for long: time_bonus sqrt(steps since)

    template <class Archive>
    void serialize(Archive& archive) {
        ValueParams<Policies>::serialize(archive);
        archive.size(planning_steps);
        archive(time_bonus);
    }
};

/// Dyna-Q+ (Sutton 1990; Sutton and Barto 2018, section 8.3), for worlds that change: planning steps replay last
/// outcomes of states visited before, with the reward raised by time_bonus sqrt(tau), tau = real steps since (s,a) was
/// last tried. Legal actions never tried in a visited state are planned too, as leading back to it with reward 0.
///
/// Interface, errors and threads: Learner. A planning step is O(|A|).
template <class Policies = ValuePolicies>
class DynaQPlus : public ValueLearner<DynaQPlus<Policies>, Policies, DynaQPlusParams<Policies>> {
    using Base = ValueLearner<DynaQPlus, Policies, DynaQPlusParams<Policies>>;
    friend Base;
    friend Learner<DynaQPlus, typename Policies::LegalActions>;
    friend SerializationAccess;

public:
    /// Its parameters, by name.
    using Params = DynaQPlusParams<Policies>;
    static constexpr const char* type_name = "Dyna-Q+";  ///< in checkpoints

    /// Knows nothing yet. `seed` decides exploration and what is replayed.
    /// \throws std::invalid_argument for no states or actions, or parameters out of range.
    DynaQPlus(StateCount states, std::size_t actions, Params params = {}, std::uint64_t seed = 0)
        : Base(states, actions, std::move(params), seed),
          outcomes_(actions),
          visited_mark_(states.initial(), false),
          last_try_(states.initial() * actions, 0) {
        require_not_negative("time_bonus", this->params_.time_bonus);
    }

    /// Room for that many states in all, without allocation on the way there.
    void reserve(std::size_t states) {
        Base::reserve_values(states);
        outcomes_.reserve(states);
        visited_.reserve(states);
        visited_mark_.reserve(states);
        last_try_.reserve(states * Base::actions());
    }

    /// Outcomes looked up for planning so far.
    [[nodiscard]] std::uint64_t model_operations() const noexcept { return operations_; }

private:
    template <class Archive>
    void serialize(Archive& archive) {
        Base::serialize(archive);
        archive.section("outcomes", [&] {
            SerializationAccess::serialize(outcomes_, archive, Base::states());
            archive(visited_, now_, operations_);
            archive.fixed(last_try_);
            for (const StateId s : visited_) {
                archive.require(index(s) < Base::states() && (!Archive::loading || !visited_mark_[index(s)]),
                                "the list of visited states is wrong");
                if constexpr (Archive::loading) visited_mark_[index(s)] = true;
            }
            for (const std::uint64_t time : last_try_) archive.require(time <= now_, "something was tried in the future");
        });
    }

    void add_states(std::size_t n) {
        Base::add_states(n);
        visited_mark_.resize(n, false);
        last_try_.resize(n * Base::actions(), 0);
    }

    void learn(const Transition& t) {
        ++now_;
        ++operations_;
        this->visits_.add(t.state, t.action);
        outcomes_.observe(t);
        last_try_[index(t.state) * Base::actions() + index(t.action)] = now_;
        if (!visited_mark_[index(t.state)]) {
            visited_mark_[index(t.state)] = true;
            visited_.push_back(t.state);
        }
        update(t);
        for (std::size_t k = 0; k < this->params_.planning_steps; ++k) plan();
    }

    void plan() {
        const StateId s = visited_[this->random_.below(visited_.size())];
        const auto allowed = Base::legal().allowed(s);
        std::size_t choices = 0;
        for (std::size_t a = 0; a < Base::actions(); ++a) choices += allowed.contains(action_id(a)) ? 1u : 0u;
        if (choices == 0) return;
        std::size_t left = this->random_.below(choices);
        std::size_t a = 0;
        while (!allowed.contains(action_id(a)) || left-- > 0) ++a;
        ++operations_;
        const Transition* seen = outcomes_.find(s, action_id(a));
        Transition t = seen != nullptr ? *seen : Transition{s, action_id(a), 0.0, s, false, 1.0};
        const auto idle = static_cast<double>(now_ - last_try_[index(s) * Base::actions() + a]);
        t.reward += this->params_.time_bonus * std::sqrt(idle);
        update(t);
    }

    void update(const Transition& t) {
        q_update(this->q_, t, this->params_.alpha(this->visits_(t.state, t.action)), this->params_.gamma,
                 Base::legal());
    }

    void episode_ended() noexcept {}

    void goals_changed(const std::vector<Goal>& /*goals*/) { Base::reset_values(); }

    LastOutcomes outcomes_;
    std::vector<StateId> visited_;
    std::vector<bool> visited_mark_;
    std::vector<std::uint64_t> last_try_;
    std::uint64_t now_ = 0;
    std::uint64_t operations_ = 0;
};

}  // namespace sspql
