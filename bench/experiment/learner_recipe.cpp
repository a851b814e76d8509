// SPDX-License-Identifier: MIT
//
// Recipes into learners: the only file that instantiates them all.

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <sspql/learn/adaptive_sspql.hpp>
#include <sspql/learn/dyna_q.hpp>
#include <sspql/learn/dyna_q_plus.hpp>
#include <sspql/learn/prioritized_sweeping.hpp>
#include <sspql/learn/q_learning.hpp>
#include <sspql/learn/r_max.hpp>
#include <sspql/learn/rtdp.hpp>
#include <sspql/learn/sarsa.hpp>
#include <sspql/learn/sspql.hpp>

#include "experiment/any_policies.hpp"
#include "experiment/learner_catalog.hpp"

namespace sspql::experiment {

namespace {

using Settings = LearnerSettings;

AnySelector selector_of(const Settings& s) {
    if (s.selector == "epsilon-greedy") return EpsilonGreedy(s.epsilon);
    if (s.selector == "boltzmann") return Boltzmann(s.temperature);
    return ActionSelector(s.noise);
}

AnyCost cost_of(const Settings& s) {
    if (s.cost == "tries") return ExpectedTries{};
    if (s.cost == "log-risk") return LogRisk(s.lambda);
    if (s.cost == "hops") return HopCount{};
    return RiskWeighted(s.lambda);
}

std::size_t whole(const char* name, double value) {
    if (!(value >= 0.0 && value <= 1e9 && value == std::floor(value))) throw_invalid(name, "be a whole number >= 0", value);
    return static_cast<std::size_t>(value);
}

template <class Params>
Params value_params(const Settings& s) {
    Params params;
    params.gamma = s.gamma;
    params.alpha = s.alpha_decay > 0.0 ? Schedule(VisitDecay{s.alpha_decay}) : Schedule(s.alpha);
    params.initial_q = s.initial_q;
    params.w_exp = s.bonus;
    params.bonus = ExplorationBonus(s.eta);
    params.selector = selector_of(s);
    return params;
}

template <class Params>
Params model_params(const Settings& s) {
    auto params = value_params<Params>(s);
    params.cap = s.cap;
    params.kappa = s.kappa;
    params.unknown_value = s.unknown_value;
    return params;
}

QLearningParams<AnyPolicies> params_of(const Settings& s, QLearning<AnyPolicies>*) {
    return value_params<QLearningParams<AnyPolicies>>(s);
}

SarsaParams<AnyPolicies> params_of(const Settings& s, Sarsa<AnyPolicies>*) {
    auto params = value_params<SarsaParams<AnyPolicies>>(s);
    params.expected = s.expected;
    return params;
}

DynaQParams<AnyModelPolicies> params_of(const Settings& s, DynaQ<AnyModelPolicies>*) {
    auto params = model_params<DynaQParams<AnyModelPolicies>>(s);
    params.planning_steps = whole("k", s.k);
    params.replay = s.replay == "last" ? Replay::last_outcome : Replay::from_counts;
    return params;
}

DynaQPlusParams<AnyPolicies> params_of(const Settings& s, DynaQPlus<AnyPolicies>*) {
    auto params = value_params<DynaQPlusParams<AnyPolicies>>(s);
    params.planning_steps = whole("k", s.k);
    params.time_bonus = s.time_bonus;
    return params;
}

PrioritizedSweepingParams<AnyModelPolicies> params_of(const Settings& s, PrioritizedSweeping<AnyModelPolicies>*) {
    auto params = model_params<PrioritizedSweepingParams<AnyModelPolicies>>(s);
    params.planning_steps = whole("k", s.k);
    params.threshold = s.threshold;
    return params;
}

RtdpParams<AnyModelPolicies> params_of(const Settings& s, Rtdp<AnyModelPolicies>*) {
    return model_params<RtdpParams<AnyModelPolicies>>(s);
}

RMaxParams<AnyModelPolicies> params_of(const Settings& s, RMax<AnyModelPolicies>*) {
    auto params = model_params<RMaxParams<AnyModelPolicies>>(s);
    params.known_after = whole("known_after", s.known_after);
    params.threshold = s.threshold;
    return params;
}

SspqlParams<AnySspqlPolicies> params_of(const Settings& s, Sspql<AnySspqlPolicies>*) {
    auto params = value_params<SspqlParams<AnySspqlPolicies>>(s);
    params.w_q = s.w_q;
    params.w_ssp = s.w_ssp;
    params.ssp_decay = VisitDecay{s.decay};
    params.cost = cost_of(s);
    if (s.probability == "best") params.probability = BestAction{};
    return params;
}

AdaptiveParams<> params_of(const Settings& s, AdaptiveSspql<>*) {
    AdaptiveParams<> params;
    params.gamma = s.gamma;
    const std::size_t budget = whole("budget", s.budget);
    params.budget = StepBudget(budget, std::max<std::uint64_t>(budget, params.budget.bank()));
    params.bonus = s.bonus;
    params.retrace = s.retrace;
    params.bound_by_paths = s.paths == "on";
    params.trust.cap = s.cap;
    params.trust.kappa_noise = s.kappa_noise;
    params.trust.tau = s.tau;
    params.change.threshold = s.alarm;
    params.change.log_offset = s.alarm_offset;
    return params;
}

template <class Learner>
std::unique_ptr<AnyLearner> boxed(const Settings& settings, std::size_t states, std::size_t actions,
                                  std::uint64_t seed) {
    auto params = params_of(settings, static_cast<Learner*>(nullptr));
    return std::make_unique<LearnerBox<Learner>>(Learner(states, actions, std::move(params), seed));
}

}  // namespace

std::unique_ptr<AnyLearner> LearnerRecipe::make(std::size_t states, std::size_t actions, std::uint64_t seed) const {
    switch (kind_) {
        case LearnerKind::q_learning: return boxed<QLearning<AnyPolicies>>(settings_, states, actions, seed);
        case LearnerKind::sarsa: return boxed<Sarsa<AnyPolicies>>(settings_, states, actions, seed);
        case LearnerKind::dyna_q: return boxed<DynaQ<AnyModelPolicies>>(settings_, states, actions, seed);
        case LearnerKind::dyna_q_plus: return boxed<DynaQPlus<AnyPolicies>>(settings_, states, actions, seed);
        case LearnerKind::prioritized_sweeping:
            return boxed<PrioritizedSweeping<AnyModelPolicies>>(settings_, states, actions, seed);
        case LearnerKind::rtdp: return boxed<Rtdp<AnyModelPolicies>>(settings_, states, actions, seed);
        case LearnerKind::r_max: return boxed<RMax<AnyModelPolicies>>(settings_, states, actions, seed);
        case LearnerKind::adaptive: return boxed<AdaptiveSspql<>>(settings_, states, actions, seed);
        case LearnerKind::sspql: break;
    }
    return boxed<Sspql<AnySspqlPolicies>>(settings_, states, actions, seed);
}

}  // namespace sspql::experiment
