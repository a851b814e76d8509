// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include <sspql/sim/geometry.hpp>
#include <sspql/sim/pose.hpp>
#include <sspql/sim/pusher_params.hpp>

namespace sspql::sim {

/// The collision guard of a translation: three sonars in the direction of travel. Each looks from the body's outline
/// outward; their directions are computed once. Its rays leave blind sectors between them: a corner of the box may slip
/// in there and is then touched (by Box2D's box: pushed).
///
/// A value; `reading_m` is const, pure and O(rays), so one object may serve several threads.
class Guard {
public:
    /// The sonars of this body in this arena. Precondition: valid parameters.
    explicit Guard(const PusherParams& params) noexcept : arena_half_side_m_(params.arena_half_side_m) {
        for (std::size_t i = 0; i < rays_.size(); ++i) {
            const double angle = params.guard_angles_rad[i];
            rays_[i] = {direction(angle), outline_m(params.body, angle), outline_m(params.body, angle + pi)};
        }
    }

    /// The least of the readings in metres: the free way from the outline to the box or a wall along the nearest ray;
    /// 0 if a sonar touches. `robot` is the robot's centre, `heading` where its front looks, `forward` whether it
    /// drives that way (front sonars) or backwards (rear ones).
    [[nodiscard]] double reading_m(const Point& robot, const Direction& heading, bool forward,
                                   const Square& box) const noexcept {
        const Direction travel = forward ? heading : reversed(heading);
        double least = no_hit;
        for (const Ray& ray : rays_) {
            const Direction way = turned(travel, ray.way);
            const Point sonar = ahead(robot, way, forward ? ray.front_outline_m : ray.rear_outline_m);
            least = std::min(least, ray_to_square(sonar, way, box));
            least = std::min(least, ray_to_walls(sonar, way, arena_half_side_m_));
        }
        return least;
    }

private:
    struct Ray {
        Direction way{};
        double front_outline_m = 0.0;
        double rear_outline_m = 0.0;
    };

    std::array<Ray, 3> rays_{};
    double arena_half_side_m_;
};

}  // namespace sspql::sim
