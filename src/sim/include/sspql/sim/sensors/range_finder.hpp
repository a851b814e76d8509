// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <sspql/core/random.hpp>
#include <sspql/sim/geometry.hpp>
#include <sspql/sim/pose.hpp>
#include <sspql/sim/sensors/scene.hpp>
#include <sspql/sim/sensors/sensor_params.hpp>

namespace sspql::sim {

/// A scanning range finder on the robot's centre: 91 beams over scan_field_rad (2 degrees apart at the default), the
/// middle one straight ahead, beam 0 the rightmost.
///
/// `read` is O(91), never allocates and always takes 91 normal draws. One object may serve several threads.
class RangeFinder {
public:
    /// How many beams there are.
    static constexpr std::size_t count = 91;
    /// Metres by beam.
    using Readings = std::array<double, count>;

    /// A range finder of this field, reach and error. \throws std::invalid_argument for parameters out of range.
    explicit RangeFinder(const SensorParams& params = {})
        : noise_m_((params.validate(), params.noise * params.scan_noise_m)),
          range_m_(params.scan_range_m),
          field_rad_(params.scan_field_rad) {}

    /// The bearing of a beam in the robot's frame.
    [[nodiscard]] double bearing_rad(std::size_t beam) const noexcept {
        return spacing_rad() * (static_cast<double>(beam) - 0.5 * static_cast<double>(count - 1));
    }

    /// Metres from the robot's centre to box or wall, in [0, scan_range_m].
    [[nodiscard]] Readings read(const Scene& scene, Random& random) const {
        Readings readings{};
        for (std::size_t i = 0; i < count; ++i) {
            const Direction way = direction(scene.robot.heading_rad + bearing_rad(i));
            const double error = random.normal();
            readings[i] = std::clamp(ray_m(scene, position(scene.robot), way) + noise_m_ * error, 0.0, range_m_);
        }
        return readings;
    }

    /// The nearest reading within `half_width_rad` of a bearing: what stands out there from the background. Takes the
    /// beam nearest to the bearing in any case; bearings outside the field count as its edge.
    [[nodiscard]] double nearest_m(const Readings& readings, double bearing_rad, double half_width_rad) const noexcept {
        const double middle = 0.5 * static_cast<double>(count - 1);
        const auto beam = [&](double angle) {
            return static_cast<std::size_t>(
                std::lround(std::clamp(angle / spacing_rad() + middle, 0.0, static_cast<double>(count - 1))));
        };
        double least = no_hit;
        for (std::size_t i = beam(bearing_rad - half_width_rad); i <= beam(bearing_rad + half_width_rad); ++i) {
            least = std::min(least, readings[i]);
        }
        return least;
    }

private:
    [[nodiscard]] double spacing_rad() const noexcept { return field_rad_ / static_cast<double>(count - 1); }

    double noise_m_;
    double range_m_;
    double field_rad_;
};

}  // namespace sspql::sim
