// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiment/live_session.hpp"
#include "viewer/canvas.hpp"

namespace sspql::viewer {

/// What stands above the panel's numbers and does not change: "approach, box2d, noise 1".
struct PanelCaption {
    std::string setting;
};

/// Who learns, how far it is, and why it does what it does: the terms of eq. 8 for each action. Takes `size` units from
/// `corner` on; ends at the returned y.
float draw_panel(Canvas& canvas, Spot corner, float width, const experiment::LiveSession& session,
                 const PanelCaption& caption);

/// The keys, and the learners by number, over everything.
void draw_help(Canvas& canvas, const experiment::LiveSession& session);

/// The keys in one line.
void draw_help_line(Canvas& canvas, Spot baseline);

}  // namespace sspql::viewer
