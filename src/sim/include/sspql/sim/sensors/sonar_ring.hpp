// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include <sspql/core/random.hpp>
#include <sspql/sim/pose.hpp>
#include <sspql/sim/sensors/scene.hpp>
#include <sspql/sim/sensors/sensor_params.hpp>

namespace sspql::sim {

/// 16 sonars on the robot's outline, evenly around it; each reads the free way outward along one ray. Sonar 0 looks
/// ahead, sonar i looks 22.5 i degrees to the left of it.
///
/// `read` is O(16), never allocates and always takes 16 normal draws. One object may serve several threads.
class SonarRing {
public:
    /// How many sonars there are.
    static constexpr std::size_t count = 16;
    /// Metres by sonar.
    using Readings = std::array<double, count>;

    /// Sonars of this reach and error. \throws std::invalid_argument for parameters out of range.
    explicit SonarRing(const SensorParams& params = {})
        : noise_m_((params.validate(), params.noise * params.sonar_noise_m)), range_m_(params.sonar_range_m) {}

    /// The bearing of a sonar in the robot's frame, in (-pi, pi].
    [[nodiscard]] static double bearing_rad(std::size_t i) noexcept {
        return wrap_angle(2.0 * pi * static_cast<double>(i) / static_cast<double>(count));
    }

    /// Metres from the outline to box or wall, in [0, sonar_range_m].
    [[nodiscard]] Readings read(const Scene& scene, Random& random) const {
        Readings readings{};
        for (std::size_t i = 0; i < count; ++i) {
            const double bearing = bearing_rad(i);
            const Direction way = direction(scene.robot.heading_rad + bearing);
            const Point sonar = ahead(position(scene.robot), way, outline_m(scene.body, bearing));
            const double error = random.normal();
            readings[i] = std::clamp(ray_m(scene, sonar, way) + noise_m_ * error, 0.0, range_m_);
        }
        return readings;
    }

private:
    double noise_m_;
    double range_m_;
};

}  // namespace sspql::sim
