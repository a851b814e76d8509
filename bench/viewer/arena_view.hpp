// SPDX-License-Identifier: MIT
#pragma once

#include "experiment/live_session.hpp"
#include "viewer/canvas.hpp"

namespace sspql::viewer {

/// The part of the arena the robot moves in, seen from above, as a square: box, goal, robot, its way and the one of the
/// episode before, and what the learner thinks of the states (policy_view.hpp).
void draw_arena(Canvas& canvas, Spot corner, float side, const experiment::LiveSession& session);

}  // namespace sspql::viewer
