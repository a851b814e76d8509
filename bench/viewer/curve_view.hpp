// SPDX-License-Identifier: MIT
#pragma once

#include "experiment/live_session.hpp"
#include "viewer/canvas.hpp"

namespace sspql::viewer {

/// Steps of each episode so far, on a logarithmic scale, and faintly what the learners did that ran before with the
/// same seed. A long run is thinned: a point is then the mean of some episodes in a row.
void draw_curve(Canvas& canvas, Spot corner, Spot size, const experiment::LiveSession& session);

}  // namespace sspql::viewer
