// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <sspql/core/random.hpp>
#include <sspql/sim/pose.hpp>
#include <sspql/sim/sensors/sensor_params.hpp>

namespace sspql::sim {

/// A movement as the wheels tell it: so far along the mean heading, then turned by so much.
struct Travel {
    double distance_m = 0.0;  ///< < 0 backwards
    double turn_rad = 0.0;    ///< change of heading, > 0 to the left
};

/// The travel that leads from one pose to another. Sliding sideways is lost: wheels do not feel it.
[[nodiscard]] inline Travel travel_between(const Pose& from, const Pose& to) noexcept {
    const double turn = wrap_angle(to.heading_rad - from.heading_rad);
    const Direction way = direction(from.heading_rad + 0.5 * turn);
    return {(to.x_m - from.x_m) * way.x + (to.y_m - from.y_m) * way.y, turn};
}

/// The pose after a travel: along the chord of the arc, then the new heading.
[[nodiscard]] inline Pose moved(const Pose& pose, const Travel& travel) noexcept {
    const Point there = ahead(position(pose), direction(pose.heading_rad + 0.5 * travel.turn_rad), travel.distance_m);
    return {there.x_m, there.y_m, wrap_angle(pose.heading_rad + travel.turn_rad)};
}

/// Wheel encoders: distance and turn of each action, with errors in proportion. `read` is O(1), takes two normal draws.
class Odometer {
public:
    /// An odometer of these errors. \throws std::invalid_argument for parameters out of range.
    explicit Odometer(const SensorParams& params = {})
        : distance_noise_((params.validate(), params.noise * params.odometry_distance_noise)),
          turn_noise_(params.noise * params.odometry_turn_noise) {}

    /// The travel between two poses as the wheels tell it.
    [[nodiscard]] Travel read(const Pose& before, const Pose& after, Random& random) const {
        const double distance_error = random.normal();
        const double turn_error = random.normal();
        const Travel travel = travel_between(before, after);
        return {travel.distance_m * (1.0 + distance_noise_ * distance_error),
                travel.turn_rad * (1.0 + turn_noise_ * turn_error)};
    }

private:
    double distance_noise_;
    double turn_noise_;
};

}  // namespace sspql::sim
