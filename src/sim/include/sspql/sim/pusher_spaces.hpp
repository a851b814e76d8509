// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/sim/box_frame.hpp>
#include <sspql/sim/pose.hpp>
#include <sspql/spaces/action_policy.hpp>

/// \file
/// What the pusher's tasks say and hear, and the policies that turn it into ids: section 4.2 of the paper.
/// All classes are empty values; every function is pure, O(1) and safe from any thread; only `describe` allocates.

namespace sspql::sim {

/// What the robot knows before a command, in the arena's frame. The learning study takes the true poses.
struct PusherObservation {
    Pose robot{};  ///< its centre and where it looks
    Pose box{};    ///< its centre and the direction of its sides
    Point goal{};  ///< where the box's centre is to go
};

/// What a command does: drive along the heading, or turn on the spot.
enum class Motion { translate, rotate };

/// One primitive action: metres (> 0 forward) or radians (> 0 to the left). A translation may be a curve.
struct PusherCommand {
    Motion motion = Motion::translate;  ///< drive or turn
    double amount = 0.0;                ///< metres or radians
    double curve_rad = 0.0;             ///< change of heading over a translation; rotations ignore it
};

/// eq. (10) of an observation: the robot in the box frame.
/// \throws std::invalid_argument for numbers that are not finite, or a goal in the box's centre.
[[nodiscard]] inline Pose to_box_frame(const PusherObservation& observation) {
    return to_box_frame(observation.robot, position(observation.box), observation.goal);
}

/// StatePolicy of 'approach': the 432 cells of Fig. 7, ids as `box_state` gives them.
/// `encode` throws std::invalid_argument for numbers that are not finite, or a goal in the box's centre.
class ApproachState {
public:
    /// The number of states, 432.
    [[nodiscard]] static constexpr std::size_t size() noexcept { return box_states; }

    /// The cell of an observation.
    [[nodiscard]] static StateId encode(const PusherObservation& observation) {
        return box_state(box_cell(to_box_frame(observation)));
    }

    /// See describe_box_state. \throws std::invalid_argument for an id of 432 or more.
    [[nodiscard]] static std::string describe(StateId s) { return describe_box_state(s); }
};

/// StatePolicy of 'turn': the 12 heading bins, bin 0 = looking at the goal along the box's way, +-15 degrees.
/// `encode` throws std::invalid_argument for numbers that are not finite, or a goal in the box's centre.
class TurnState {
public:
    /// The number of states, 12.
    [[nodiscard]] static constexpr std::size_t size() noexcept { return heading_bins; }

    /// The heading bin of an observation.
    [[nodiscard]] static StateId encode(const PusherObservation& observation) {
        return state_id(thirty_degree_bin(to_box_frame(observation).heading_rad));
    }

    /// "heading 30 deg". \throws std::invalid_argument for an id of 12 or more.
    [[nodiscard]] static std::string describe(StateId s) {
        return "heading " + std::to_string(index(sspql::detail::require_state_of(s, size())) * 30) + " deg";
    }
};

namespace detail {

struct NamedCommand {
    PusherCommand command{};
    const char* text = "";
};

}  // namespace detail

/// ActionPolicy of 'approach': 0 forward 0.3 m, 1 backward 0.2 m, 2 turn 30 degrees, 3 turn -25 degrees.
/// `decode` and `describe` throw std::invalid_argument for an action outside.
class ApproachActions {
public:
    /// The number of actions, 4.
    [[nodiscard]] static constexpr std::size_t size() noexcept { return actions.size(); }

    /// The action's command.
    [[nodiscard]] static PusherCommand decode(ActionId a) { return at(a).command; }

    /// The action in words.
    [[nodiscard]] static std::string describe(ActionId a) { return at(a).text; }

private:
    static constexpr std::array<detail::NamedCommand, 4> actions{
        detail::NamedCommand{{Motion::translate, 0.3}, "forward 0.3 m"},
        detail::NamedCommand{{Motion::translate, -0.2}, "backward 0.2 m"},
        detail::NamedCommand{{Motion::rotate, from_degrees(30.0)}, "turn 30 deg"},
        detail::NamedCommand{{Motion::rotate, from_degrees(-25.0)}, "turn -25 deg"}};

    [[nodiscard]] static const detail::NamedCommand& at(ActionId a) {
        return actions[index(sspql::detail::require_action_of(a, size()))];
    }
};

/// ActionPolicy of 'turn': 0 turn 30 degrees, 1 turn -25 degrees.
/// `decode` and `describe` throw std::invalid_argument for an action outside.
class TurnActions {
public:
    /// The number of actions, 2.
    [[nodiscard]] static constexpr std::size_t size() noexcept { return actions.size(); }

    /// The action's command.
    [[nodiscard]] static PusherCommand decode(ActionId a) { return at(a).command; }

    /// The action in words.
    [[nodiscard]] static std::string describe(ActionId a) { return at(a).text; }

private:
    static constexpr std::array<detail::NamedCommand, 2> actions{
        detail::NamedCommand{{Motion::rotate, from_degrees(30.0)}, "turn 30 deg"},
        detail::NamedCommand{{Motion::rotate, from_degrees(-25.0)}, "turn -25 deg"}};

    [[nodiscard]] static const detail::NamedCommand& at(ActionId a) {
        return actions[index(sspql::detail::require_action_of(a, size()))];
    }
};

}  // namespace sspql::sim
