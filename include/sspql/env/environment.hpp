// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>

#include <sspql/core/concepts.hpp>

namespace sspql {

/// What one command did, in the meaning of Gymnasium. `terminated`: the task itself ended here (a goal, a hazard), the
/// state has no future value. `truncated`: somebody stopped the episode (a time limit, an operator), the state still
/// has one. Both may be set.
template <class Observation>
struct Step {
    Observation observation{};  ///< what is seen after the command
    double reward = 0.0;        ///< what it brought
    bool terminated = false;    ///< whether the task ended
    bool truncated = false;     ///< whether the episode was cut short
};

namespace detail {

template <class E>
using ResetExpression = decltype(std::declval<E&>().reset(std::uint64_t{}));

template <class E, class C>
using StepExpression = decltype(std::declval<E&>().step(std::declval<const C&>()));

template <class S>
using StepMembers = std::void_t<decltype(std::declval<S&>().observation), decltype(std::declval<S&>().reward),
                                decltype(std::declval<S&>().terminated), decltype(std::declval<S&>().truncated)>;

}  // namespace detail

/// What an Environment's `reset` and `step` return as observation.
template <class Environment>
using ObservationOf = std::decay_t<detail::detected_t<detail::ResetExpression, Environment>>;

/// Environment (concept): `reset(std::uint64_t seed) -> Observation` starts an episode, all of whose chance comes from
/// the seed; `step(const Command&) -> Step<Observation>` (or a type with the same four members). An environment never
/// counts its own time limit: that is TimeLimit's.
template <class Environment, class Command>
inline constexpr bool is_environment_v =
    detail::is_detected_v<detail::ResetExpression, Environment> &&
    detail::is_detected_v<detail::StepExpression, Environment, Command> &&
    detail::is_detected_v<detail::StepMembers, detail::detected_t<detail::StepExpression, Environment, Command>>;

namespace detail {

/// One error per missing requirement, each naming the expression; instantiate it before using an Environment.
template <class Environment, class Command>
struct EnvironmentRequirements {
    static_assert(is_detected_v<ResetExpression, Environment>,
                  "sspql: this Environment lacks `environment.reset(std::uint64_t seed) -> Observation`");
    static_assert(!is_detected_v<ResetExpression, Environment> || is_detected_v<StepExpression, Environment, Command>,
                  "sspql: this Environment lacks `environment.step(const Command&) -> sspql::Step<Observation>`");
    static_assert(!is_detected_v<StepExpression, Environment, Command> ||
                      is_detected_v<StepMembers, detected_t<StepExpression, Environment, Command>>,
                  "sspql: `environment.step(command)` must return the members observation, reward, terminated and "
                  "truncated (sspql::Step<Observation> has them)");
};

}  // namespace detail

}  // namespace sspql
