// SPDX-License-Identifier: MIT
#include "report/arena_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>

#include "report/arena_symbols.hpp"
#include "report/numbers.hpp"

namespace sspql::report {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double picture_width = 640.0;
constexpr double margin = 16.0;
constexpr double text_size = 15.0;
constexpr double legend_row = 28.0;

struct LegendItem {
    std::string text;
    std::function<void(Point)> symbol;  ///< drawn about this point, 26 units wide
};

/// Draws one arena; the legend grows with what is drawn.
class ArenaPainter {
public:
    explicit ArenaPainter(const Arena& arena)
        : arena_(arena),
          unit_((picture_width - 2.0 * margin) / (2.0 * arena.half_width_m)),
          goal_direction_(std::atan2(arena.goal.y_m - arena.box.y_m, arena.goal.x_m - arena.box.x_m)),
          legend_(legend_items()),
          svg_(picture_width, arena_bottom() + 18.0 + static_cast<double>(legend_rows()) * legend_row + 6.0,
               label_of(arena)) {}

    Svg paint() {
        paint_floor();
        paint_cells();
        paint_objects();
        paint_starts();
        for (std::size_t i = 0; i < arena_.paths.size(); ++i) paint_path(i);
        paint_scale();
        paint_legend();
        return std::move(svg_);
    }

private:
    static std::string label_of(const Arena& arena) {
        std::string label = "The arena from above: box, goal, region A, the cells about the box, starting places";
        for (const ArenaPath& path : arena.paths) label += ", path of " + path.name;
        return label;
    }

    [[nodiscard]] double arena_bottom() const { return picture_width - margin; }
    [[nodiscard]] double length(double metres) const { return unit_ * metres; }
    [[nodiscard]] Point at(double x_m, double y_m) const {
        return {margin + length(x_m + arena_.half_width_m), margin + length(arena_.half_width_m - y_m)};
    }
    [[nodiscard]] Point at(const ArenaPose& pose) const { return at(pose.x_m, pose.y_m); }
    /// A point at a distance from the box, in a direction counted from the goal's.
    [[nodiscard]] Point about_box(double distance_m, double angle_rad) const {
        const double angle = goal_direction_ + angle_rad;
        return at(arena_.box.x_m + distance_m * std::cos(angle), arena_.box.y_m + distance_m * std::sin(angle));
    }
    [[nodiscard]] double sector_width() const { return 2.0 * pi / arena_.sectors; }
    [[nodiscard]] Ink ink_of(std::size_t path) const {
        return path < arena_.inks.size() ? arena_.inks[path] : series_ink(path);
    }

    void paint_floor() {
        const double side = length(2.0 * arena_.half_width_m);
        svg_.rect({margin - 4.0, margin - 4.0}, side + 8.0, side + 8.0, {Ink::floor, Ink::wall, 8.0}, 3.0);
    }

    void paint_cells() {
        const Point centre = at(arena_.box);
        if (arena_.show_region) {
            const double middle = goal_direction_ + pi;
            svg_.sector(centre, length(arena_.fence_m), middle - 0.5 * sector_width(), middle + 0.5 * sector_width(),
                        {Ink::region, Ink::none, 1.0, 0.75});
        }
        for (int i = 0; i < arena_.sectors; ++i) {
            const double angle = (i + 0.5) * sector_width();
            svg_.line(about_box(0.75 * arena_.box_side_m, angle), about_box(arena_.fence_m, angle),
                      {Ink::none, Ink::axis, 1.0, 0.6});
        }
        for (const double ring : arena_.rings_m) {
            svg_.circle(centre, length(ring), {Ink::none, Ink::axis, 1.2, 0.9});
            ring_label(ring, short_text(ring, 2) + " m");
        }
        svg_.circle(centre, length(arena_.fence_m), {Ink::none, Ink::wall, 2.0, 1.0, "3 6"});
        ring_label(arena_.fence_m, short_text(arena_.fence_m, 2) + " m");
        if (arena_.show_region) {
            const Point place = about_box(arena_.fence_m + 0.17, pi);
            svg_.text({place.x, place.y + 0.36 * 1.7 * text_size}, "A",
                      {Ink::region_text, 1.7 * text_size, Anchor::middle, true, 0.0, Ink::floor});
        }
    }

    /// On the circle, in the middle of the sector beside the goal's: paths seldom pass there.
    void ring_label(double radius_m, const std::string& text) {
        const Point place = about_box(radius_m, -sector_width());
        const double size = 0.9 * text_size;
        const double half_width = 0.5 * text_width(text, size) + 2.0;
        svg_.rect({place.x - half_width, place.y - 0.6 * size}, 2.0 * half_width, 1.2 * size, {Ink::floor});
        svg_.text({place.x, place.y + 0.35 * size}, text, {Ink::faint, size, Anchor::middle});
    }

    void paint_objects() {
        const Point goal = at(arena_.goal);
        svg_.circle(goal, length(arena_.goal_radius_m), {Ink::goal, Ink::goal_edge, 2.0, 0.9});
        svg_.text({goal.x, goal.y + 0.35 * text_size}, "goal", {Ink::text, text_size, Anchor::middle, true});
        // Which way the box has to go: from beside it to the goal's edge, unless it is already there.
        const double distance_m = std::hypot(arena_.goal.x_m - arena_.box.x_m, arena_.goal.y_m - arena_.box.y_m);
        const double from_m = 0.5 * arena_.box_side_m + 0.10;
        const double to_m = distance_m - arena_.goal_radius_m - 0.06;
        if (from_m < to_m) draw_arrow(svg_, about_box(from_m, 0.0), about_box(to_m, 0.0), Ink::goal_edge);
        draw_box(svg_, at(arena_.box), length(arena_.box_side_m), arena_.box.heading_rad);
    }

    void paint_starts() {
        for (std::size_t i = 0; i < arena_.starts.size(); ++i) {
            const ArenaPose& start = arena_.starts[i];
            const Point place = at(start);
            draw_robot(svg_, place, length(arena_.robot_radius_m), start.heading_rad, {Ink::robot, Ink::wall, 1.8});
            const double away = std::atan2(start.y_m - arena_.box.y_m, start.x_m - arena_.box.x_m);
            const double reach = length(arena_.robot_radius_m) + 0.7 * text_size;
            const double c = std::cos(away);
            const double s = std::sin(away);
            const Anchor anchor = c > 0.5 ? Anchor::start : c < -0.5 ? Anchor::end : Anchor::middle;
            const std::string text = arena_.starts.size() > 1 ? "start " + std::to_string(i + 1) : "start";
            svg_.text({place.x + reach * c, place.y - reach * s + (0.35 - 0.4 * s) * text_size}, text,
                      {Ink::text, text_size, anchor, false, 0.0, Ink::floor});
        }
    }

    /// The way as a line with a dot per step; a short tick shows the heading, so turns on the spot are seen as well.
    void paint_path(std::size_t position) {
        const ArenaPath& path = arena_.paths[position];
        if (path.poses.empty()) return;
        const Ink ink = ink_of(position);
        svg_.begin_group("path", path_text(path));
        std::vector<Point> points;
        points.reserve(path.poses.size());
        for (const ArenaPose& pose : path.poses) points.push_back(at(pose));
        svg_.polyline(points, {Ink::none, Ink::floor, 6.0, 0.8});
        svg_.polyline(points, {Ink::none, ink, 3.0});
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double heading = path.poses[i].heading_rad;
            const Point tip{points[i].x + 11.0 * std::cos(heading), points[i].y - 11.0 * std::sin(heading)};
            svg_.line(points[i], tip, {Ink::none, ink, 1.5});
            svg_.circle(points[i], 3.6, {ink, Ink::floor, 1.0}, "step " + std::to_string(i));
        }
        const Point end = points.back();
        svg_.circle(end, length(arena_.robot_radius_m), {ink, Ink::none, 1.0, 0.16});
        draw_robot(svg_, end, length(arena_.robot_radius_m), path.poses.back().heading_rad, {Ink::none, ink, 2.4});
        svg_.end_group();
    }

    void paint_scale() {
        const double y = arena_bottom() - 26.0;
        const double left = margin + 22.0;
        const double right = left + length(1.0);
        const Style style{Ink::none, Ink::text, 2.0};
        svg_.line({left, y}, {right, y}, style);
        svg_.line({left, y - 5.0}, {left, y + 5.0}, style);
        svg_.line({right, y - 5.0}, {right, y + 5.0}, style);
        svg_.text({0.5 * (left + right), y - 9.0}, "1 m", {Ink::text, text_size, Anchor::middle});
    }

    static std::string path_text(const ArenaPath& path) {
        const std::size_t steps = path.poses.empty() ? 0 : path.poses.size() - 1;
        return path.name + ": " + std::to_string(steps) + (steps == 1 ? " step" : " steps");
    }

    /// The legend's items, in reading order. The symbols draw with svg_, when it exists.
    std::vector<LegendItem> legend_items() {
        std::vector<LegendItem> items;
        for (std::size_t i = 0; i < arena_.paths.size(); ++i) {
            items.push_back({path_text(arena_.paths[i]), [this, i](Point p) {
                                 const Ink ink = ink_of(i);
                                 svg_.line({p.x - 13.0, p.y}, {p.x + 13.0, p.y}, {Ink::none, ink, 3.0});
                                 svg_.circle({p.x - 9.0, p.y}, 3.6, {ink, Ink::paper, 1.0});
                                 svg_.circle({p.x + 9.0, p.y}, 3.6, {ink, Ink::paper, 1.0});
                             }});
        }
        items.push_back({"robot at the start", [this](Point p) {
                             draw_robot(svg_, p, 10.0, 0.0, {Ink::robot, Ink::wall, 1.8});
                         }});
        if (!arena_.paths.empty()) {
            items.push_back({"robot at the end of its path", [this](Point p) {
                                 draw_robot(svg_, p, 10.0, 0.0, {Ink::none, ink_of(0), 2.4});
                             }});
        }
        items.push_back({"box, and the way it shall go", [this](Point p) { draw_box(svg_, p, 20.0, 0.0); }});
        if (arena_.show_region) {
            items.push_back({arena_.region_meaning, [this](Point p) {
                                 svg_.rect({p.x - 13.0, p.y - 8.0}, 26.0, 16.0, {Ink::region, Ink::none, 1.0, 0.75});
                             }});
        }
        items.push_back({"cells: " + std::to_string(arena_.sectors) + " sectors, " +
                             std::to_string(arena_.rings_m.size() + 1) + " rings",
                         [this](Point p) {
                             svg_.line({p.x - 13.0, p.y}, {p.x + 13.0, p.y}, {Ink::none, Ink::axis, 1.2});
                         }});
        items.push_back({"fence: the robot stays inside", [this](Point p) {
                             svg_.line({p.x - 13.0, p.y}, {p.x + 13.0, p.y}, {Ink::none, Ink::wall, 2.0, 1.0, "3 6"});
                         }});
        return items;
    }

    [[nodiscard]] std::size_t legend_rows() const { return (legend_.size() + 1) / 2; }

    void paint_legend() {
        for (std::size_t i = 0; i < legend_.size(); ++i) {
            const double left = i < legend_rows() ? margin : 0.5 * picture_width + margin;
            const double y = arena_bottom() + 18.0 + (static_cast<double>(i % legend_rows()) + 0.5) * legend_row;
            legend_[i].symbol({left + 14.0, y});
            svg_.text({left + 38.0, y + 0.35 * text_size}, legend_[i].text, {Ink::text, text_size});
        }
    }

    const Arena& arena_;
    double unit_;
    double goal_direction_;
    std::vector<LegendItem> legend_;
    Svg svg_;
};

}  // namespace

Svg arena_picture(const Arena& arena) { return ArenaPainter(arena).paint(); }

}  // namespace sspql::report
