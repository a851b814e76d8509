// SPDX-License-Identifier: MIT
#pragma once

#include <sspql/sim/pusher_spaces.hpp>

#include "experiment/live_session.hpp"
#include "viewer/arena_frame.hpp"
#include "viewer/canvas.hpp"

/// \file
/// What the learner thinks of the states it tried: the brighter a cell, the more it is worth, with the sign of what it
/// would do there. The cell of the shown decision is framed.

namespace sspql::viewer {

/// For 'approach': the cells about the box, for the heading the robot has now.
void draw_cells(Canvas& canvas, const ArenaFrame& frame, const experiment::LiveSession& session);

/// For 'turn': a dial of headings about the robot.
void draw_dial(Canvas& canvas, const ArenaFrame& frame, const experiment::LiveSession& session);

/// The sign of an action: an arrow along `heading_rad`, one against it with a bar at its tail, or one bent to the left
/// or right.
void draw_action_sign(Canvas& canvas, Spot centre, float size, double heading_rad, const sim::PusherCommand& command,
                      sf::Color ink);

}  // namespace sspql::viewer
