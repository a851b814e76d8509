// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <sspql/sim/pose.hpp>
#include <sspql/sim/pusher_params.hpp>

#include "experiment/live_session.hpp"
#include "viewer/canvas.hpp"

namespace sspql::viewer {

/// Where the things of the arena are on the canvas: the fence about the box's place, and a margin, fill a square.
/// Holds for one frame.
struct ArenaFrame {
    ArenaFrame(Spot corner, float side, const experiment::LiveSession& session)
        : params(session.run().world().params()),
          middle(corner.x + 0.5F * side, corner.y + 0.5F * side),
          unit(0.5F * side / static_cast<float>(params.fence_radius_m + margin_m)),
          robot(session.shown_robot()),
          box(session.run().observation().box),
          goal(session.run().observation().goal),
          to_goal_rad(std::atan2(goal.y_m - box.y_m, goal.x_m - box.x_m)) {}

    [[nodiscard]] Spot at(const sim::Point& p) const {
        return {middle.x + length(p.x_m - params.box_place.x_m), middle.y - length(p.y_m - params.box_place.y_m)};
    }
    [[nodiscard]] Spot at(const sim::Pose& pose) const { return at(sim::position(pose)); }
    [[nodiscard]] float length(double m) const { return unit * static_cast<float>(m); }

    static constexpr double margin_m = 0.42;

    const sim::PusherParams& params;
    Spot middle;
    float unit;  ///< to a metre
    sim::Pose robot;
    sim::Pose box;
    sim::Point goal;
    double to_goal_rad;  ///< the way from box to goal: the box frame's x axis
};

}  // namespace sspql::viewer
