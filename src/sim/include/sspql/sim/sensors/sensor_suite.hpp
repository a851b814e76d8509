// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <sspql/core/random.hpp>
#include <sspql/sim/pose.hpp>
#include <sspql/sim/sensors/camera.hpp>
#include <sspql/sim/sensors/odometer.hpp>
#include <sspql/sim/sensors/range_finder.hpp>
#include <sspql/sim/sensors/scene.hpp>
#include <sspql/sim/sensors/sensor_params.hpp>
#include <sspql/sim/sensors/sonar_ring.hpp>

namespace sspql::sim {

/// What all sensors say at one moment.
struct SensorReadings {
    SonarRing::Readings sonars{};    ///< metres, by sonar
    RangeFinder::Readings ranges{};  ///< metres, by beam of the range finder
    CameraView view{};               ///< what the camera sees
};

/// The robot's sensors with one random stream. Every look takes the same number of draws whatever is in view, and so
/// does every reading of the odometer: runs with different outcomes stay comparable. Copyable; one object per thread.
class SensorSuite {
public:
    static constexpr std::uint64_t random_stream = 4;  ///< beside those of RandomStream

    /// All sensors with these numbers. \throws std::invalid_argument for parameters out of range.
    explicit SensorSuite(const SensorParams& params = {})
        : params_(params), sonars_(params), finder_(params), camera_(params), odometer_(params) {}

    /// Begins the sequence of errors of this seed.
    void reset(std::uint64_t seed) noexcept { random_ = Random(seed, random_stream); }

    /// What all sensors say of a scene. 110 normal draws.
    [[nodiscard]] SensorReadings look(const Scene& scene) {
        SensorReadings readings;
        readings.sonars = sonars_.read(scene, random_);
        readings.ranges = finder_.read(scene, random_);
        readings.view = camera_.look(scene, random_);
        return readings;
    }

    /// What the odometer says of a movement. Two normal draws.
    [[nodiscard]] Travel travelled(const Pose& before, const Pose& after) {
        return odometer_.read(before, after, random_);
    }

    /// Reach and errors of all sensors.
    [[nodiscard]] const SensorParams& params() const noexcept { return params_; }
    /// The range finder, which knows its beams' bearings.
    [[nodiscard]] const RangeFinder& range_finder() const noexcept { return finder_; }
    /// The camera.
    [[nodiscard]] const Camera& camera() const noexcept { return camera_; }

private:
    SensorParams params_;
    SonarRing sonars_;
    RangeFinder finder_;
    Camera camera_;
    Odometer odometer_;
    Random random_{0, random_stream};
};

}  // namespace sspql::sim
