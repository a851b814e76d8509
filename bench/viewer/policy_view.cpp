// SPDX-License-Identifier: MIT
#include "viewer/policy_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <sspql/sim/box_frame.hpp>

namespace sspql::viewer {

namespace {

using experiment::LiveRun;
using experiment::LiveSession;
using experiment::StateView;
using report::Ink;

constexpr double bin_rad = 2.0 * sim::pi / static_cast<double>(sim::box_sectors);
static_assert(sim::heading_bins == sim::box_sectors);

/// How bright states are: from 0, the least valuable of those tried, to 1.
std::vector<double> brightness(const std::vector<StateView>& views) {
    double low = 1e300;
    double high = -1e300;
    for (const StateView& view : views) {
        if (!view.tried) continue;
        low = std::min(low, view.value);
        high = std::max(high, view.value);
    }
    std::vector<double> all;
    all.reserve(views.size());
    for (const StateView& view : views) {
        // Values fall off by the discount with every step from the goal: the root keeps the far ones apart.
        all.push_back(view.tried && low < high ? std::sqrt((view.value - low) / (high - low)) : 0.0);
    }
    return all;
}

sf::Color value_colour(double bright) { return colour(Ink::value, 0.14 + 0.72 * bright); }
sf::Color sign_colour(double bright) { return colour(Ink::text, 0.5 + 0.4 * bright); }

/// The radii that part the rings, from beside the box to the fence.
std::array<float, sim::box_rings + 1> ring_edges(const ArenaFrame& frame) {
    return {frame.length(0.72 * frame.params.box_side_m), frame.length(sim::inner_ring_edge_m),
            frame.length(sim::outer_ring_edge_m), frame.length(frame.params.fence_radius_m)};
}

void frame_cell(Canvas& canvas, Spot centre, float inner, float outer, double angle_rad) {
    const double from = angle_rad - 0.5 * bin_rad;
    const double to = angle_rad + 0.5 * bin_rad;
    const sf::Color ink = colour(Ink::series4);
    canvas.arc(centre, inner, from, to, ink, 2.5F);
    canvas.arc(centre, outer, from, to, ink, 2.5F);
    canvas.line(polar(centre, inner, from), polar(centre, outer, from), ink, 2.5F);
    canvas.line(polar(centre, inner, to), polar(centre, outer, to), ink, 2.5F);
}

}  // namespace

void draw_cells(Canvas& canvas, const ArenaFrame& frame, const LiveSession& session) {
    const LiveRun& run = session.run();
    const std::size_t heading = sim::thirty_degree_bin(frame.robot.heading_rad - frame.to_goal_rad);
    const double looks_rad = frame.to_goal_rad + bin_rad * static_cast<double>(heading);
    const auto edges = ring_edges(frame);
    const Spot centre = frame.at(frame.box);
    std::vector<StateView> views;
    for (std::size_t i = 0; i < sim::box_rings * sim::box_sectors; ++i) {
        StateView view = run.view(sim::box_state({i / sim::box_sectors, i % sim::box_sectors, heading}));
        if (i % sim::box_sectors == sim::push_sector) view.tried = false;  // the episode is over there
        views.push_back(view);
    }
    const std::vector<double> bright = brightness(views);
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (!views[i].tried) continue;
        const float inner = edges[i / sim::box_sectors];
        const float outer = edges[i / sim::box_sectors + 1];
        const double angle = frame.to_goal_rad + bin_rad * static_cast<double>(i % sim::box_sectors);
        canvas.ring_sector(centre, inner, outer, angle - 0.5 * bin_rad, angle + 0.5 * bin_rad, value_colour(bright[i]));
        draw_action_sign(canvas, polar(centre, 0.5 * static_cast<double>(inner + outer), angle), frame.length(0.075),
                         looks_rad, run.world().command(views[i].best), sign_colour(bright[i]));
    }
    const double behind = frame.to_goal_rad + sim::pi;
    canvas.ring_sector(centre, edges[0], edges[3], behind - 0.5 * bin_rad, behind + 0.5 * bin_rad,
                       colour(Ink::region, 0.75));
    for (std::size_t i = 0; i < sim::box_sectors; ++i) {
        const double angle = frame.to_goal_rad + bin_rad * (static_cast<double>(i) + 0.5);
        canvas.line(polar(centre, edges[0], angle), polar(centre, edges[3], angle), colour(Ink::axis, 0.45));
    }
    canvas.arc(centre, edges[1], 0.0, 2.0 * sim::pi, colour(Ink::axis, 0.6), 1.2F);
    canvas.arc(centre, edges[2], 0.0, 2.0 * sim::pi, colour(Ink::axis, 0.6), 1.2F);
    const Spot name = polar(centre, static_cast<double>(edges[3] + frame.length(0.14)), behind);
    canvas.text({name.x, name.y + 9.0F}, "A", {Ink::region_text, 26.0F, Align::centre, true});

    const sim::BoxCell cell = sim::box_cell(session.shown_decision().state);
    frame_cell(canvas, centre, edges[cell.ring], edges[cell.ring + 1],
               frame.to_goal_rad + bin_rad * static_cast<double>(cell.sector));
}

void draw_dial(Canvas& canvas, const ArenaFrame& frame, const LiveSession& session) {
    const LiveRun& run = session.run();
    const Spot centre = frame.at(frame.robot);
    const float inner = frame.length(sim::reach_m(frame.params.body) + 0.06);
    const float outer = inner + frame.length(0.26);
    std::vector<StateView> views;
    for (std::size_t i = 0; i < sim::heading_bins; ++i) views.push_back(run.view(state_id(i)));
    const std::vector<double> bright = brightness(views);
    for (std::size_t i = 0; i < views.size(); ++i) {
        const double angle = frame.to_goal_rad + bin_rad * static_cast<double>(i);
        const double half = 0.47 * bin_rad;
        const Spot middle = polar(centre, 0.5 * static_cast<double>(inner + outer), angle);
        if (i == 0) {
            canvas.ring_sector(centre, inner, outer, angle - half, angle + half, colour(Ink::region, 0.9));
            canvas.text({middle.x, middle.y + 6.0F}, "0°", {Ink::region_text, 16.0F, Align::centre, true});
            continue;
        }
        canvas.ring_sector(centre, inner, outer, angle - half, angle + half,
                           views[i].tried ? value_colour(bright[i]) : colour(Ink::grid));
        if (!views[i].tried) continue;
        draw_action_sign(canvas, middle, frame.length(0.06), angle, run.world().command(views[i].best),
                         sign_colour(bright[i]));
    }
    frame_cell(canvas, centre, inner, outer,
               frame.to_goal_rad + bin_rad * static_cast<double>(index(session.shown_decision().state)));
}

void draw_action_sign(Canvas& canvas, Spot centre, float size, double heading_rad, const sim::PusherCommand& command,
                      sf::Color ink) {
    const float width = std::max(1.5F, 0.16F * size);
    if (command.motion == sim::Motion::rotate) {
        const double side = command.amount >= 0.0 ? 1.0 : -1.0;
        canvas.arc(centre, 0.75F * size, heading_rad - side * 1.9, heading_rad + side * 1.5, ink, width, 0.6F * size);
        return;
    }
    const bool forward = command.amount >= 0.0;
    const double way = forward ? heading_rad : heading_rad + sim::pi;
    const Spot tail = polar(centre, static_cast<double>(size), way + sim::pi);
    canvas.arrow(tail, polar(centre, static_cast<double>(size), way), ink, width, 0.75F * size);
    if (forward) return;
    const double half = 0.5 * static_cast<double>(size);
    canvas.line(polar(tail, half, way + 0.5 * sim::pi), polar(tail, half, way - 0.5 * sim::pi), ink, width);
}

}  // namespace sspql::viewer
