// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <sspql/core/random.hpp>
#include <sspql/sim/pose.hpp>
#include <sspql/sim/sensors/scene.hpp>
#include <sspql/sim/sensors/sensor_params.hpp>

namespace sspql::sim {

/// What the camera tells of a thing in view: where to, in the robot's frame, and of the goal how far, by its size.
struct Sighting {
    double bearing_rad = 0.0;  ///< robot frame, > 0 to the left
    double range_m = 0.0;      ///< goal only; 0 for the box
    bool whole = true;         ///< false: only a part of the goal's edge, with twice the errors
};

/// What the camera tells at one moment.
struct CameraView {
    std::optional<Sighting> box{};   ///< if in view
    std::optional<Sighting> goal{};  ///< if in view, or a part of it
};

/// One camera on the robot's centre, looking ahead. A thing is in view if the bearing of its centre lies within half
/// the field of view to either side (edges included) and it is not hidden: the box by a wall; the goal, a disc on the
/// floor, by the box or a wall. Of the goal three points are looked for: its centre and its two sides, as seen from the
/// robot. One side is enough to tell a circle of known size, with twice the errors; none of the three: hidden.
///
/// `look` is O(1), never allocates and always takes three normal draws. One object may serve several threads.
class Camera {
public:
    /// A camera of this sight and these errors. \throws std::invalid_argument for parameters out of range.
    explicit Camera(const SensorParams& params = {})
        : half_field_rad_((params.validate(), 0.5 * params.camera_field_rad)),
          bearing_noise_rad_(params.noise * params.bearing_noise_rad),
          range_noise_(params.noise * params.goal_range_noise),
          goal_radius_m_(params.goal_radius_m) {}

    /// What is in view, with the errors of this look.
    [[nodiscard]] CameraView look(const Scene& scene, Random& random) const {
        const double box_error = random.normal();
        const double goal_error = random.normal();
        const double range_error = random.normal();
        CameraView view;
        if (sees_box(scene)) {
            view.box = Sighting{bearing_rad(scene.robot, scene.box.centre) + bearing_noise_rad_ * box_error, 0.0};
        }
        const int sides = goal_sides_in_view(scene);
        if (sides > 0) {
            const double errors = sides > 1 ? 1.0 : 2.0;
            const double range = distance_m(position(scene.robot), scene.goal);
            view.goal = Sighting{bearing_rad(scene.robot, scene.goal) + errors * bearing_noise_rad_ * goal_error,
                                 range * std::max(0.0, 1.0 + errors * range_noise_ * range_error), sides > 1};
        }
        return view;
    }

    /// Whether the box is in view.
    [[nodiscard]] bool sees_box(const Scene& scene) const noexcept {
        const Point& box = scene.box.centre;
        const double side = scene.arena_half_side_m;
        return is_in_field(scene, box) && std::max(std::fabs(box.x_m), std::fabs(box.y_m)) <= side;
    }

    /// How much of the goal is in view: 0 nothing, 1 one of its sides, 2 both or its centre.
    [[nodiscard]] int goal_sides_in_view(const Scene& scene) const noexcept {
        if (!is_in_field(scene, scene.goal)) return 0;
        const Point eye = position(scene.robot);
        if (is_clear_line(scene, eye, scene.goal)) return 2;
        const double range = distance_m(eye, scene.goal);
        const Direction side{-(scene.goal.y_m - eye.y_m) / range, (scene.goal.x_m - eye.x_m) / range};
        const bool left = is_clear_line(scene, eye, ahead(scene.goal, side, goal_radius_m_));
        const bool right = is_clear_line(scene, eye, ahead(scene.goal, side, -goal_radius_m_));
        return (left ? 1 : 0) + (right ? 1 : 0);
    }

private:
    [[nodiscard]] bool is_in_field(const Scene& scene, const Point& p) const noexcept {
        return std::fabs(bearing_rad(scene.robot, p)) <= half_field_rad_;
    }

    double half_field_rad_;
    double bearing_noise_rad_;
    double range_noise_;
    double goal_radius_m_;
};

}  // namespace sspql::sim
