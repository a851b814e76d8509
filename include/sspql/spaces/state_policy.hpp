// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>

#include <sspql/core/concepts.hpp>
#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>

/// \file
/// StatePolicy (concept): turns an observation into a state's id.
///
///     std::size_t size() const                 number of states (known so far, if it grows)
///     StateId encode(const Observation&)       the state, 0 to size() - 1
///     std::string describe(StateId) const      optional: the state in words
///     static constexpr bool grows = true;      optional: encode may answer size(), a new state
///
/// Ours: UniformGrid, PolarGrid, EnumState, ProductState, ProjectedState, HashedState.

namespace sspql {

namespace detail {

template <class P>
using SizeExpression = decltype(std::declval<const P&>().size());

template <class P, class Observation>
using EncodeExpression = decltype(std::declval<P&>().encode(std::declval<const Observation&>()));

template <class P>
using DescribeStateExpression = decltype(std::declval<const P&>().describe(StateId{}));

template <class P>
using GrowsExpression = decltype(P::grows);

}  // namespace detail

/// Whether P has the two required members for this Observation.
template <class P, class Observation>
inline constexpr bool is_state_policy_v = detail::is_detected_convertible_v<std::size_t, detail::SizeExpression, P> &&
                                          detail::is_detected_convertible_v<StateId, detail::EncodeExpression, P, Observation>;

namespace detail {

template <class P, class = void>
struct Grows : std::false_type {};
template <class P>
struct Grows<P, std::void_t<GrowsExpression<P>>> : std::bool_constant<P::grows> {};

}  // namespace detail

/// Whether the number of states is discovered while encoding.
template <class P>
inline constexpr bool grows_v = detail::Grows<P>::value;

/// The state in words if the policy can say it, else its number.
template <class P>
[[nodiscard]] std::string describe_state(const P& policy, StateId s) {
    if constexpr (detail::is_detected_v<detail::DescribeStateExpression, P>) {
        return policy.describe(s);
    } else {
        return std::to_string(index(s));
    }
}

namespace detail {

/// `s` if it is one of the policy's states; else std::invalid_argument.
inline StateId require_state_of(StateId s, std::size_t size) {
    if (index(s) >= size) throw_invalid("state", "be below the number of states " + std::to_string(size), index(s));
    return s;
}

/// Throws std::invalid_argument if `values` knows its size and has fewer than `n` numbers.
template <class Values>
void require_numbers(const Values& values, std::size_t n) {
    if constexpr (is_detected_convertible_v<std::size_t, SizeExpression, Values>) {
        const auto size = static_cast<std::size_t>(values.size());
        if (size < n) throw_invalid("observation", "have at least " + std::to_string(n) + " numbers", size);
    } else {
        static_cast<void>(values);
        static_cast<void>(n);
    }
}

}  // namespace detail

}  // namespace sspql
