// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <sspql/core/errors.hpp>
#include <sspql/sim/pose.hpp>

namespace sspql::sim {

/// The numbers of the robot's sensors. All errors are normal; `noise` multiplies all their deviations (0: exact).
/// Plain data; sensors call `validate` and keep a copy.
struct SensorParams {
    double noise = 1.0;  ///< multiplies all deviations below

    double sonar_noise_m = 0.01;  ///< of a sonar's reading
    double sonar_range_m = 5.0;   ///< a sonar that meets nothing nearer reads this

    double scan_field_rad = from_degrees(180.0);  ///< of the range finder, centred on the front
    double scan_noise_m = 0.01;                   ///< of a beam's reading
    double scan_range_m = 8.0;                    ///< a beam that meets nothing nearer reads this

    double camera_field_rad = from_degrees(60.0);  ///< centred on the front
    double bearing_noise_rad = from_degrees(1.0);  ///< of the camera's bearings
    double goal_range_noise = 0.03;                ///< of the distance, which the camera tells from the goal's size
    double goal_radius_m = 0.30;                   ///< of the disc it looks for

    double odometry_distance_noise = 0.02;  ///< of the distance
    double odometry_turn_noise = 0.02;      ///< of the angle

    /// Checks every member. \throws std::invalid_argument naming the first member out of range, with its value.
    void validate() const {
        require_not_negative("sensor noise", noise);
        require_not_negative("sonar_noise_m", sonar_noise_m);
        require_positive("sonar_range_m", sonar_range_m);
        require_in("scan_field_rad", scan_field_rad, from_degrees(1.0), 2.0 * pi);
        require_not_negative("scan_noise_m", scan_noise_m);
        require_positive("scan_range_m", scan_range_m);
        require_in("camera_field_rad", camera_field_rad, from_degrees(1.0), pi);
        require_not_negative("bearing_noise_rad", bearing_noise_rad);
        require_not_negative("goal_range_noise", goal_range_noise);
        require_positive("goal_radius_m", goal_radius_m);
        require_not_negative("odometry_distance_noise", odometry_distance_noise);
        require_not_negative("odometry_turn_noise", odometry_turn_noise);
    }
};

}  // namespace sspql::sim
