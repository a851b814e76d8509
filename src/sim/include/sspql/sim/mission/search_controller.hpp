// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include <sspql/sim/belief.hpp>
#include <sspql/sim/pose.hpp>
#include <sspql/sim/pusher_spaces.hpp>
#include <sspql/sim/sensors/sonar_ring.hpp>

namespace sspql::sim {

/// 'search', predetermined: turn and travel until box and goal are believed to be somewhere, then come within
/// `near_m` of the box, where 'approach' was learnt.
///
/// A full turn of 45 degrees at a time; if that did not show both, a leg along the sonar with the longest free way (if
/// the box is known: rather past it than towards it, for it may be what hides the goal), and another turn. No chance,
/// no allocation, O(16) per call. A value; one object per thread.
class SearchController {
public:
    /// A search begins.
    void begin() noexcept {
        turned_ = 0;
        leg_m_ = 0.0;
    }

    /// What to do next; nothing: box and goal are believed and the box is near.
    [[nodiscard]] std::optional<PusherCommand> next(const Belief& belief, const SonarRing::Readings& sonars) {
        if (belief.is_complete()) return come_near(belief);
        if (leg_m_ > 0.0) {
            const double leg = leg_m_;
            begin();
            return PusherCommand{Motion::translate, leg};
        }
        if (turned_ < full_turn) {
            ++turned_;
            return PusherCommand{Motion::rotate, 2.0 * pi / full_turn};
        }
        return start_leg(belief, sonars);
    }

    static constexpr double near_m = 1.15;        ///< from the robot's centre to the box's: the box is near
    static constexpr int full_turn = 8;           ///< looks, 45 degrees apart
    static constexpr double longest_leg_m = 0.8;  ///< travelled between two turns, at most

private:
    [[nodiscard]] std::optional<PusherCommand> come_near(const Belief& belief) const noexcept {
        const Point& box = belief.box()->place;
        const Pose& robot = belief.robot();
        const double range = distance_m(position(robot), box);
        if (range <= near_m) return std::nullopt;
        const double bearing = bearing_rad(robot, box);
        if (std::fabs(bearing) > from_degrees(10.0)) {
            const double most = from_degrees(60.0);
            return PusherCommand{Motion::rotate, std::clamp(bearing, -most, most)};
        }
        return PusherCommand{Motion::translate, std::min(0.5, range - near_m + 0.05)};
    }

    [[nodiscard]] PusherCommand start_leg(const Belief& belief, const SonarRing::Readings& sonars) noexcept {
        std::size_t best = 0;
        double best_worth = -1.0;
        for (std::size_t i = 0; i < SonarRing::count; ++i) {
            double worth = std::min(sonars[i], 2.0);
            if (belief.box()) {
                const double to_box = bearing_rad(belief.robot(), belief.box()->place);
                worth *= 0.2 + std::fabs(std::sin(SonarRing::bearing_rad(i) - to_box));
            }
            if (worth > best_worth) {
                best_worth = worth;
                best = i;
            }
        }
        leg_m_ = std::clamp(sonars[best] - 0.2, 0.1, longest_leg_m);
        return {Motion::rotate, SonarRing::bearing_rad(best)};
    }

    int turned_ = 0;      // steps of the full turn made
    double leg_m_ = 0.0;  // > 0: turned towards it, to be driven next
};

}  // namespace sspql::sim
