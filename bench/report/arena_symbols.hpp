// SPDX-License-Identifier: MIT
#pragma once

#include "report/svg.hpp"

/// \file
/// The things of the arena as they look, in the picture's units; used at their places and in the legend.

namespace sspql::report {

/// A crate, turned counter-clockwise.
void draw_box(Svg& svg, Point centre, double side, double turn_rad);

/// A disc with a nose that shows the heading (counter-clockwise from the right).
void draw_robot(Svg& svg, Point centre, double radius, double heading_rad, const Style& style);

/// A dashed arrow; nothing if it were shorter than its tip.
void draw_arrow(Svg& svg, Point from, Point tip, Ink ink);

}  // namespace sspql::report
