// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include <sspql/core/assert.hpp>
#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/random.hpp>
#include <sspql/learn/action_selector.hpp>
#include <sspql/learn/hints.hpp>
#include <sspql/learn/learner.hpp>
#include <sspql/learn/transition.hpp>
#include <sspql/learn/visit_counts.hpp>

namespace sspql {

/// What all our learners share beyond the protocol: parameters, visit counts, selection by a score, and the trainer.
/// ParamsType has a `selector`, `legal_actions` and the schedule `hint_fading`.
template <class Derived, class Policies, class ParamsType>
class TaughtLearner : public Learner<Derived, typename Policies::LegalActions> {
    using Base = Learner<Derived, typename Policies::LegalActions>;
    static_assert(is_selector_v<typename Policies::Selector>,
                  "sspql: this Selector lacks `ActionId operator()(std::size_t actions, const Allowed&, const Score&, "
                  "Random&) const`");

public:
    /// Its parameters, by name.
    using Params = ParamsType;

    /// A trainer's hint: in s, take a. `strength` adds to the action's score (a reached goal that pays 1 is worth up to
    /// 1; negative warns) and fades with the visits of (s,a) from now on. A new hint replaces the old one; 0 takes it
    /// back. The first hint allocates 16 bytes an (s,a).
    /// \throws std::invalid_argument for ids outside or a strength that is not finite; a growing learner admits s.
    void teach(StateId s, ActionId a, double strength = 1.0) {
        detail::require_action_of(a, Base::actions());
        require_finite("strength of a hint", strength);
        Base::grow_to(Base::admitted(s, Base::states(), "state"));
        hints_.set(s, a, strength, visits_(s, a), Base::states());
    }

    /// A demonstration: learns from the step like observe, and teaches its action.
    void demonstrate(const Transition& t, double strength = 1.0) {
        require_finite("strength of a hint", strength);
        Base::observe(t.state, t.action, t.reward, t.next, t.terminated, t.weight);
        teach(t.state, t.action, strength);
    }

    /// How often each (s,a) was taken; since the last set_goals, for learners with a Q table of their own
    /// (ValueLearner).
    [[nodiscard]] const VisitCounts& visits() const noexcept { return visits_; }
    /// Its parameters, as given.
    [[nodiscard]] const Params& params() const noexcept { return params_; }

protected:
    TaughtLearner(StateCount states, std::size_t actions, Params params, std::uint64_t seed)
        : Base(states, actions, params.legal_actions),
          params_(std::move(params)),
          visits_(states.initial(), actions),
          hints_(actions),
          random_(seed, RandomStream::learner) {}

    /// For checkpoints (core/serialization.hpp); parameters were read before the learner was made.
    template <class Archive>
    void serialize(Archive& archive) {
        Base::serialize(archive);
        archive.section("visits", [&] { archive(visits_); });
        archive.section("hints", [&] { archive(hints_); });
        archive.section("random", [&] { archive(random_); });
    }

    void add_states(std::size_t n) { visits_.grow(n); }
    void reserve_visits(std::size_t states) { visits_.reserve(states); }

    /// The selector's choice among the legal actions of s by score(a).
    template <class Score>
    [[nodiscard]] ActionId choose(StateId s, const Score& score) {
        const auto& allowed = Base::legal().allowed(s);
        const ActionId chosen = params_.selector(Base::actions(), allowed, score, random_);
        SSPQL_ASSERT(index(chosen) < Base::actions() && allowed.contains(chosen), "a Selector chooses an allowed action");
        return chosen;
    }

    [[nodiscard]] double hint_term(StateId s, ActionId a) const noexcept {
        return hints_(s, a, visits_(s, a), params_.hint_fading);
    }

    Params params_;
    VisitCounts visits_;
    Hints hints_;
    Random random_;
};

}  // namespace sspql
