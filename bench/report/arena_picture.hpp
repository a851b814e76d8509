// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/svg.hpp"

/// \file
/// The box pusher's arena seen from above, from plain numbers: nothing here knows the simulator.

namespace sspql::report {

/// A place and a direction in the arena: x to the right, y up, heading counter-clockwise from x.
struct ArenaPose {
    double x_m = 0.0;
    double y_m = 0.0;
    double heading_rad = 0.0;
};

/// One episode's way: the robot's pose at the start and after each action.
struct ArenaPath {
    std::string name{};  ///< the learner's, perhaps with the start
    std::vector<ArenaPose> poses{};
};

/// What stands in the arena. The defaults are the approach task's.
struct Arena {
    double half_width_m = 2.5;
    double robot_radius_m = 0.20;
    double box_side_m = 0.30;
    ArenaPose box{};
    ArenaPose goal{1.3, 0.0, 0.0};
    double goal_radius_m = 0.30;
    std::vector<double> rings_m{0.7, 1.0};  ///< radii about the box at which the distance class changes
    double fence_m = 1.3;                   ///< the robot keeps within this distance of the box
    int sectors = 12;                       ///< directions about the box, sector 0 centred on the goal's; even
    bool show_region = true;                ///< region A: the sector opposite the goal
    std::string region_meaning = "A: reaching it ends the task";  ///< in the legend
    std::vector<ArenaPose> starts{{0.9, 0.5, 3.14159265358979323846}, {0.2, -1.2, 1.57079632679489661923}};
    std::vector<ArenaPath> paths{};  ///< drawn in the colours of series 0, 1, ... unless `inks` says otherwise
    std::vector<Ink> inks{};         ///< by path
};

/// Draws the arena with its paths, a legend and a scale bar. Without paths the starting places show the robot.
[[nodiscard]] Svg arena_picture(const Arena& arena);

}  // namespace sspql::report
