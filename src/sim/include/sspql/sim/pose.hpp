// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

/// \file
/// Points, directions and poses in the plane: metres, radians, x right, y up, angles from +x towards +y.
///
/// Everything here is a pure function of values; safe from any thread, no allocation, O(1).

namespace sspql::sim {

/// Half a turn, in radians.
inline constexpr double pi = 3.14159265358979323846;

/// An angle given in degrees, in radians.
[[nodiscard]] constexpr double from_degrees(double angle_deg) noexcept { return angle_deg * (pi / 180.0); }

/// An angle given in radians, in degrees.
[[nodiscard]] constexpr double to_degrees(double angle_rad) noexcept { return angle_rad * (180.0 / pi); }

/// A place in the plane.
struct Point {
    double x_m = 0.0;  ///< to the right
    double y_m = 0.0;  ///< up
};

/// A place and the direction the body there looks in.
struct Pose {
    double x_m = 0.0;          ///< to the right
    double y_m = 0.0;          ///< up
    double heading_rad = 0.0;  ///< 0 looks along +x, pi / 2 along +y
};

/// A unit vector: the cosine and sine of a heading, so that one heading costs one pair of calls.
struct Direction {
    double x = 1.0;  ///< cosine
    double y = 0.0;  ///< sine
};

/// The same place, to the bit.
[[nodiscard]] constexpr bool operator==(const Point& a, const Point& b) noexcept {
    return a.x_m == b.x_m && a.y_m == b.y_m;
}
/// Another place.
[[nodiscard]] constexpr bool operator!=(const Point& a, const Point& b) noexcept { return !(a == b); }

/// The same place and heading, to the bit: 0 and 2 pi are different.
[[nodiscard]] constexpr bool operator==(const Pose& a, const Pose& b) noexcept {
    return a.x_m == b.x_m && a.y_m == b.y_m && a.heading_rad == b.heading_rad;
}
/// Another place or heading.
[[nodiscard]] constexpr bool operator!=(const Pose& a, const Pose& b) noexcept { return !(a == b); }

/// Where the pose is, without its heading.
[[nodiscard]] constexpr Point position(const Pose& pose) noexcept { return {pose.x_m, pose.y_m}; }

/// Whether no number is NaN or infinite.
[[nodiscard]] inline bool is_finite(const Point& p) noexcept { return std::isfinite(p.x_m) && std::isfinite(p.y_m); }

/// Whether no number is NaN or infinite.
[[nodiscard]] inline bool is_finite(const Pose& p) noexcept {
    return is_finite(position(p)) && std::isfinite(p.heading_rad);
}

/// The same angle in (-pi, pi]: pi itself stays, -pi becomes pi. Exact up to one rounding however large the angle; NaN
/// or infinity gives NaN.
[[nodiscard]] inline double wrap_angle(double angle_rad) noexcept {
    if (angle_rad > -pi && angle_rad <= pi) return angle_rad;
    const double wrapped = std::remainder(angle_rad, 2.0 * pi);  // [-pi, pi]
    return wrapped <= -pi ? pi : wrapped;
}

/// The unit vector of a heading.
[[nodiscard]] inline Direction direction(double heading_rad) noexcept {
    return {std::cos(heading_rad), std::sin(heading_rad)};
}

/// The direction turned by the angle of another one (a product of complex numbers).
[[nodiscard]] constexpr Direction turned(const Direction& d, const Direction& by) noexcept {
    return {d.x * by.x - d.y * by.y, d.x * by.y + d.y * by.x};
}

/// The opposite direction.
[[nodiscard]] constexpr Direction reversed(const Direction& d) noexcept { return {-d.x, -d.y}; }

/// The point reached from `p` by going `distance_m` (may be negative) along `d`.
[[nodiscard]] constexpr Point ahead(const Point& p, const Direction& d, double distance_m) noexcept {
    return {p.x_m + distance_m * d.x, p.y_m + distance_m * d.y};
}

/// Euclidean distance in metres. A plain square root: exact enough for arenas, the same bits on every compiler.
[[nodiscard]] inline double distance_m(const Point& a, const Point& b) noexcept {
    const double dx = b.x_m - a.x_m;
    const double dy = b.y_m - a.y_m;
    return std::sqrt(dx * dx + dy * dy);
}

/// Where a point is as seen from a pose: the angle from its heading, in (-pi, pi].
[[nodiscard]] inline double bearing_rad(const Pose& from, const Point& to) noexcept {
    return wrap_angle(std::atan2(to.y_m - from.y_m, to.x_m - from.x_m) - from.heading_rad);
}

/// A pose given in the frame of another one (its origin and +x axis), in that one's own frame.
[[nodiscard]] inline Pose from_frame(const Pose& frame, const Pose& pose) noexcept {
    const Direction d = direction(frame.heading_rad);
    return {frame.x_m + pose.x_m * d.x - pose.y_m * d.y, frame.y_m + pose.x_m * d.y + pose.y_m * d.x,
            wrap_angle(frame.heading_rad + pose.heading_rad)};
}

}  // namespace sspql::sim
