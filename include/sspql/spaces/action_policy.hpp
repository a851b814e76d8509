// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <sspql/core/concepts.hpp>
#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>

/// \file
/// ActionPolicy (concept): turns an action's id into the command a robot understands.
///
///     std::size_t size() const                 number of actions
///     Command decode(ActionId) const           the command
///     std::string describe(ActionId) const     optional: the action in words
///
/// Ours: ActionTable (a list of commands), EnumActions (an enum's values).

namespace sspql {

namespace detail {

template <class P>
using DecodeExpression = decltype(std::declval<const P&>().decode(ActionId{}));

template <class P>
using ActionSizeExpression = decltype(std::declval<const P&>().size());

template <class P>
using DescribeActionExpression = decltype(std::declval<const P&>().describe(ActionId{}));

/// `a` if it is one of `size` actions; else std::invalid_argument.
inline ActionId require_action_of(ActionId a, std::size_t size) {
    if (index(a) >= size) throw_invalid("action", "be below the number of actions " + std::to_string(size), index(a));
    return a;
}

}  // namespace detail

/// Whether P has the two required members.
template <class P>
inline constexpr bool is_action_policy_v =
    detail::is_detected_convertible_v<std::size_t, detail::ActionSizeExpression, P> &&
    detail::is_detected_v<detail::DecodeExpression, P>;

/// The command type of an ActionPolicy.
template <class P>
using CommandOf = std::decay_t<detail::detected_t<detail::DecodeExpression, P>>;

/// The action in words if the policy can say it, else its number.
template <class P>
[[nodiscard]] std::string describe_action(const P& policy, ActionId a) {
    if constexpr (detail::is_detected_v<detail::DescribeActionExpression, P>) {
        return policy.describe(a);
    } else {
        return std::to_string(index(a));
    }
}

/// ActionPolicy: action i is the i-th of a list of commands. Commands are kept by value; decode is O(1).
/// \throws std::invalid_argument for an empty list; decode for an action outside.
template <class Command>
class ActionTable {
public:
    /// One action for each command, in this order.
    ActionTable(std::initializer_list<Command> commands) : ActionTable(std::vector<Command>(commands)) {}

    /// The same with a vector, for a list made at run time.
    explicit ActionTable(std::vector<Command> commands) : commands_(std::move(commands)) {
        detail::require_id_count("number of actions", commands_.size());
    }

    /// The number of actions.
    [[nodiscard]] std::size_t size() const noexcept { return commands_.size(); }

    /// The command of an action, valid as long as the table. O(1).
    [[nodiscard]] const Command& decode(ActionId a) const {
        return commands_[index(detail::require_action_of(a, commands_.size()))];
    }

private:
    std::vector<Command> commands_;
};

/// ActionPolicy: action i is the enum (or integer) value i, 0 to size - 1.
/// \throws std::invalid_argument if size is 0; decode for an action outside.
template <class T>
class EnumActions {
    static_assert(std::is_enum_v<T> || std::is_integral_v<T>, "sspql: EnumActions needs an enum or an integer type");

public:
    /// Actions 0 to size - 1.
    explicit EnumActions(std::size_t size) : size_(detail::require_id_count("number of actions", size)) {}

    /// The number of actions.
    [[nodiscard]] std::size_t size() const noexcept { return size_; }

    /// The value of an action. O(1).
    [[nodiscard]] T decode(ActionId a) const { return static_cast<T>(index(detail::require_action_of(a, size_))); }

private:
    std::size_t size_;
};

}  // namespace sspql
