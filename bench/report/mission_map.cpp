// SPDX-License-Identifier: MIT
#include "report/mission_map.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "report/arena_symbols.hpp"

namespace sspql::report {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double degree = pi / 180.0;
constexpr std::size_t sectors = 12;
constexpr std::size_t rings = 3;
constexpr std::size_t headings = 12;
constexpr std::size_t push_sector = 6;
constexpr double width = 720.0;
constexpr std::array<double, rings> middles{128.0, 206.0, 288.0};  // of the rings, for the eye: not to scale
constexpr std::array<double, rings + 1> edges{84.0, 166.0, 246.0, 330.0};
constexpr std::array<double, rings> dials{26.0, 33.0, 36.0};
constexpr std::array<Ink, 4> action_inks{Ink::series2, Ink::series4, Ink::series3, Ink::series1};

class MapPainter {
public:
    explicit MapPainter(const LearntMap& map)
        : map_(map), svg_(width, 760.0, "The learnt action in each cell about the box, for each heading") {}

    Svg paint() {
        svg_.sector(centre_, edges[rings], pi - 15.0 * degree, pi + 15.0 * degree, {Ink::region, Ink::none, 1.0, 0.6});
        for (const double edge : edges) svg_.circle(centre_, edge, {Ink::none, Ink::axis, 1.0, 0.8});
        for (std::size_t i = 0; i < sectors; ++i) {
            const double angle = (30.0 * static_cast<double>(i) + 15.0) * degree;
            svg_.line(polar(edges[0], angle), polar(edges[rings], angle), {Ink::none, Ink::axis, 1.0, 0.5});
        }
        draw_box(svg_, centre_, 56.0, 0.0);
        draw_arrow(svg_, {centre_.x + 34.0, centre_.y}, {centre_.x + 80.0, centre_.y}, Ink::goal_edge);
        svg_.text({centre_.x + 336.0, centre_.y - 8.0}, "goal", {Ink::text, 14.0, Anchor::middle, true, 90.0});
        svg_.text({centre_.x - 342.0, centre_.y + 5.0}, "A", {Ink::region_text, 20.0, Anchor::middle, true});
        for (std::size_t ring = 0; ring < rings; ++ring) {
            for (std::size_t sector = 0; sector < sectors; ++sector) paint_dial(ring, sector);
        }
        paint_legend();
        return std::move(svg_);
    }

private:
    [[nodiscard]] Point polar(double radius, double angle) const {
        return {centre_.x + radius * std::cos(angle), centre_.y - radius * std::sin(angle)};
    }

    void paint_dial(std::size_t ring, std::size_t sector) {
        if (sector == push_sector) return;  // the task is over there
        const Point middle = polar(middles[ring], 30.0 * static_cast<double>(sector) * degree);
        svg_.circle(middle, dials[ring], {Ink::paper, Ink::axis, 1.0});
        for (std::size_t heading = 0; heading < headings; ++heading) {
            const int best = map_.best[(ring * sectors + sector) * headings + heading];
            if (best < 0) continue;
            const double angle = 30.0 * static_cast<double>(heading) * degree;
            const Ink ink = action_inks[static_cast<std::size_t>(best) % action_inks.size()];
            svg_.sector(middle, dials[ring] - 1.0, angle - 14.0 * degree, angle + 14.0 * degree, {ink});
        }
        svg_.circle(middle, 4.0, {Ink::paper});
    }

    void paint_legend() {
        double x = 20.0;
        for (std::size_t a = 0; a < map_.actions.size(); ++a) {
            svg_.rect({x, 722.0}, 16.0, 16.0, {action_inks[a % action_inks.size()]}, 3.0);
            svg_.text({x + 22.0, 735.0}, map_.actions[a], {Ink::text, 14.0});
            x += 38.0 + text_width(map_.actions[a], 14.0);
        }
        svg_.circle({x + 8.0, 730.0}, 8.0, {Ink::paper, Ink::axis, 1.0});
        svg_.text({x + 22.0, 735.0}, "never tried", {Ink::text, 14.0});
    }

    const LearntMap& map_;
    Point centre_{width / 2.0, 352.0};
    Svg svg_;
};

}  // namespace

Svg mission_map(const LearntMap& map) {
    if (map.best.size() != rings * sectors * headings) {
        throw std::invalid_argument("a map of learnt actions must have 432 states, got " +
                                    std::to_string(map.best.size()));
    }
    return MapPainter(map).paint();
}

}  // namespace sspql::report
