// SPDX-License-Identifier: MIT
#include "viewer/arena_view.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <sspql/sim/box_frame.hpp>

#include "viewer/arena_frame.hpp"
#include "viewer/policy_view.hpp"

namespace sspql::viewer {

namespace {

using experiment::LiveRun;
using experiment::LiveSession;
using report::Ink;

constexpr double goal_radius_m = 0.30;
constexpr std::size_t newest = 250;  // poses of a long way that are drawn brightly

void draw_fence(Canvas& canvas, const ArenaFrame& frame) {
    constexpr int dots = 90;
    for (int i = 0; i < dots; ++i) {
        const double angle = 2.0 * sim::pi * i / dots;
        canvas.arc(frame.at(frame.box), frame.length(frame.params.fence_radius_m), angle, angle + 0.02,
                   colour(Ink::wall, 0.9), 2.0F);
    }
}

/// The goal, and which way the box has to go.
void draw_goal(Canvas& canvas, const ArenaFrame& frame) {
    const Spot goal = frame.at(frame.goal);
    canvas.circle(goal, frame.length(goal_radius_m), colour(Ink::goal, 0.85), colour(Ink::goal_edge), 2.0F);
    canvas.text({goal.x, goal.y + 6.0F}, "goal", {Ink::text, 17.0F, Align::centre, true});
    const double from_m = 0.5 * frame.params.box_side_m + 0.10;
    const double to_m = sim::distance_m(sim::position(frame.box), frame.goal) - goal_radius_m - 0.05;
    if (to_m - from_m < 0.1) return;
    const auto along = [&](double m) {
        return polar(frame.at(frame.box), static_cast<double>(frame.length(m)), frame.to_goal_rad);
    };
    const sf::Color ink = colour(Ink::goal_edge, 0.8);
    canvas.dashed(along(from_m), along(to_m - 0.06), ink, 2.5F, 8.0F);
    canvas.arrow(along(to_m - 0.07), along(to_m), ink, 2.5F, 14.0F);
}

void draw_box(Canvas& canvas, const ArenaFrame& frame) {
    const auto corners = [&](double scale) {
        const double reach = scale * static_cast<double>(frame.length(frame.params.box_side_m)) / std::sqrt(2.0);
        std::vector<Spot> spots;
        for (int i = 0; i < 5; ++i) {  // the first once more: closed
            spots.push_back(polar(frame.at(frame.box), reach, frame.box.heading_rad + sim::pi * (0.25 + 0.5 * i)));
        }
        return spots;
    };
    const std::vector<Spot> inside = corners(0.68);
    canvas.polygon(corners(1.0), colour(Ink::box));
    canvas.polyline(corners(1.0), colour(Ink::box_edge), 2.5F);
    canvas.polyline(inside, colour(Ink::box_edge), 1.2F);
    canvas.line(inside[0], inside[2], colour(Ink::box_edge), 1.2F);
    canvas.line(inside[1], inside[3], colour(Ink::box_edge), 1.2F);
}

/// The way of the episode before.
void draw_old_way(Canvas& canvas, const ArenaFrame& frame, const std::vector<sim::Pose>& way) {
    std::vector<Spot> spots;
    spots.reserve(way.size());
    for (const sim::Pose& pose : way) spots.push_back(frame.at(pose));
    canvas.polyline(spots, colour(Ink::series0, 0.4), 1.5F);
}

/// The way of this episode, up to where the robot is seen; a dot for each action, but only a line where it is long ago.
void draw_way(Canvas& canvas, const ArenaFrame& frame, const std::vector<sim::Pose>& way) {
    std::vector<Spot> spots;
    spots.reserve(way.size());
    for (std::size_t i = 0; i + 1 < way.size(); ++i) spots.push_back(frame.at(way[i]));
    spots.push_back(frame.at(frame.robot));
    const std::size_t begin = spots.size() > newest ? spots.size() - newest : 0;
    const auto split = spots.begin() + static_cast<std::ptrdiff_t>(begin);
    if (begin > 0) canvas.polyline({spots.begin(), split + 1}, colour(Ink::series0, 0.25), 1.5F);
    canvas.polyline({split, spots.end()}, colour(Ink::series0, 0.9), 3.0F);
    for (auto spot = split; spot + 1 != spots.end(); ++spot) canvas.circle(*spot, 3.6F, colour(Ink::series0));
}

void draw_robot(Canvas& canvas, const ArenaFrame& frame, bool is_there) {
    const Spot centre = frame.at(frame.robot);
    const float radius = frame.length(frame.params.body.radius_m);
    const sf::Color edge = colour(is_there ? Ink::series3 : Ink::text);
    canvas.circle(centre, radius, colour(Ink::robot, 0.92), edge, is_there ? 5.0F : 2.5F);
    const auto around = [&](double part, double angle) {
        return polar(centre, part * static_cast<double>(radius), frame.robot.heading_rad + angle);
    };
    canvas.polygon({around(0.84, 0.0), around(0.66, 2.4), around(0.22, sim::pi), around(0.66, -2.4)}, edge);
}

const char* reason_of(sim::Stop stop) {
    switch (stop) {
        case sim::Stop::guard: return "stopped by the guard: something is near";
        case sim::Stop::fence: return "stopped at the fence";
        case sim::Stop::contact: return "stopped by a contact";
        case sim::Stop::stall: return "stopped: it could not get on";
        case sim::Stop::done: break;
    }
    return "";
}

/// How the episode ended, or what stopped the last move.
void draw_outcome(Canvas& canvas, Spot baseline, const LiveSession& session) {
    const LiveRun& run = session.run();
    if (run.is_episode_over()) {
        const experiment::LiveEpisode& episode = run.episodes().back();
        const std::string steps = std::to_string(episode.steps) + (episode.steps == 1 ? " step" : " steps");
        canvas.text(baseline, episode.success ? "there in " + steps : "cut after " + steps,
                    {episode.success ? Ink::series3 : Ink::series0, 22.0F, Align::left, true});
    } else if (run.last() && session.is_followable()) {
        canvas.text(baseline, reason_of(run.last_move().stop), {Ink::faint, 16.0F});
    }
}

void draw_scale(Canvas& canvas, Spot left, float length) {
    const Spot right(left.x + length, left.y);
    canvas.line(left, right, colour(Ink::faint), 2.0F);
    for (const Spot& end : {left, right}) {
        canvas.line({end.x, end.y - 5.0F}, {end.x, end.y + 5.0F}, colour(Ink::faint), 2.0F);
    }
    canvas.text({0.5F * (left.x + right.x), left.y - 9.0F}, "0.5 m", {Ink::faint, 14.0F, Align::centre});
}

}  // namespace

void draw_arena(Canvas& canvas, Spot corner, float side, const LiveSession& session) {
    const LiveRun& run = session.run();
    const ArenaFrame frame(corner, side, session);
    const bool is_approach = run.world().states() == sim::box_states;
    canvas.rect(corner, {side, side}, colour(Ink::floor));
    if (is_approach) draw_cells(canvas, frame, session);
    draw_fence(canvas, frame);
    draw_goal(canvas, frame);
    draw_box(canvas, frame);
    if (!is_approach) draw_dial(canvas, frame, session);
    draw_old_way(canvas, frame, run.last_trail());
    draw_way(canvas, frame, run.trail());
    draw_robot(canvas, frame, run.is_episode_over() && run.episodes().back().success);
    draw_outcome(canvas, {corner.x + 18.0F, corner.y + 34.0F}, session);
    const float low = corner.y + side - 18.0F;
    draw_scale(canvas, {corner.x + 18.0F, low}, frame.length(0.5));
    canvas.text({corner.x + side - 18.0F, low + 4.0F},
                is_approach ? "arrows: its choice in each cell, looking this way; brighter: worth more"
                            : "arrows: its choice at each heading; brighter: worth more",
                {Ink::faint, 14.0F, Align::right});
}

}  // namespace sspql::viewer
