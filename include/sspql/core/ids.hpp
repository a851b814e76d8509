// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <sspql/core/errors.hpp>

namespace sspql {

/// A state's dense index, 0 to |S| - 1. A type of its own: an action or a bare number does not pass for a state.
enum class StateId : std::uint32_t {};

/// An action's dense index, 0 to |A| - 1.
enum class ActionId : std::uint32_t {};

/// "No state": the successor of a goal, or of a state that reaches none.
inline constexpr StateId no_state{0xFFFFFFFFu};
/// "No action".
inline constexpr ActionId no_action{0xFFFFFFFFu};

/// Ids run up to this many states or actions; the last value stands for "none".
inline constexpr std::size_t max_ids = 0xFFFFFFFFu;

/// The id as an index into an array.
[[nodiscard]] constexpr std::size_t index(StateId s) noexcept { return static_cast<std::size_t>(s); }
/// The same of an action.
[[nodiscard]] constexpr std::size_t index(ActionId a) noexcept { return static_cast<std::size_t>(a); }

/// The id with this index. Precondition (unchecked): i < max_ids.
[[nodiscard]] constexpr StateId state_id(std::size_t i) noexcept { return StateId{static_cast<std::uint32_t>(i)}; }
/// The same of an action.
[[nodiscard]] constexpr ActionId action_id(std::size_t i) noexcept { return ActionId{static_cast<std::uint32_t>(i)}; }

namespace detail {

/// Throws std::invalid_argument unless 1 <= n < max_ids.
inline std::size_t require_id_count(const char* name, std::size_t n) {
    if (n == 0 || n >= max_ids) throw_invalid(name, "lie between 1 and 4294967294", n);
    return n;
}

}  // namespace detail

}  // namespace sspql
