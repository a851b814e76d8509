// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>
#include <utility>

/// \file
/// The detection idiom (C++17) with which templates ask whether a user's type has a member, so that a missing one is
/// reported by one static_assert that names the missing expression.

namespace sspql::detail {

template <class AlwaysVoid, template <class...> class Expression, class... Arguments>
struct Detector : std::false_type {
    struct Type {};
};

template <template <class...> class Expression, class... Arguments>
struct Detector<std::void_t<Expression<Arguments...>>, Expression, Arguments...> : std::true_type {
    using Type = Expression<Arguments...>;
};

/// Whether Expression<Arguments...> is well-formed.
template <template <class...> class Expression, class... Arguments>
inline constexpr bool is_detected_v = Detector<void, Expression, Arguments...>::value;

/// The expression's type, or an empty placeholder when it is ill-formed: signatures can still be written, and the
/// static_assert that names the cause stays the only error.
template <template <class...> class Expression, class... Arguments>
using detected_t = typename Detector<void, Expression, Arguments...>::Type;

/// Whether the expression is well-formed and converts to To.
template <class To, template <class...> class Expression, class... Arguments>
inline constexpr bool is_detected_convertible_v =
    is_detected_v<Expression, Arguments...> && std::is_convertible_v<detected_t<Expression, Arguments...>, To>;

}  // namespace sspql::detail
