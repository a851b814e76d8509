// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/spaces/state_policy.hpp>

namespace sspql {

/// StatePolicy: sector x ring around the origin, as in Fig. 7(a) of the paper (12 sectors, 3 rings). The observation is
/// anything whose [0] and [1] are x and y in the frame of the centre, in the unit of the ring edges.
///
/// Sector k is centred on the angle k * 360 / sectors degrees, measured from +x towards +y: sector 0 points along +x.
/// Ring r holds distances in [edge[r-1], edge[r]); the last ring has no outer edge, so there is one ring more than
/// edges. Id = ring * sectors + sector. `encode` is O(rings), allocates nothing and throws std::invalid_argument for
/// NaN or infinite values and for a vector of fewer than two; the origin itself counts as angle 0.
///
/// \throws std::invalid_argument for no sectors, or edges that are not finite, positive and increasing.
class PolarGrid {
public:
    /// `sectors` equal sectors and one ring more than there are edges, which must be positive and increase.
    PolarGrid(std::size_t sectors, std::vector<double> ring_edges)
        : sectors_(detail::require_id_count("sectors", sectors)), edges_(std::move(ring_edges)) {
        double previous = 0.0;
        for (const double edge : edges_) {
            require_finite("ring edge", edge);
            if (!(edge > previous)) throw_invalid("ring edges", "be positive and increase", edge);
            previous = edge;
        }
        detail::require_id_count("sectors x rings", sectors_ * rings());
    }

    /// The number of states, sectors x rings.
    [[nodiscard]] std::size_t size() const noexcept { return sectors_ * rings(); }
    /// The number of sectors.
    [[nodiscard]] std::size_t sectors() const noexcept { return sectors_; }
    /// The number of rings, one more than there are edges.
    [[nodiscard]] std::size_t rings() const noexcept { return edges_.size() + 1; }

    /// The state of a position: anything with x in [0] and y in [1].
    template <class Observation>
    [[nodiscard]] auto encode(const Observation& position) const
        -> decltype(static_cast<double>(position[0]) + static_cast<double>(position[1]), StateId{}) {
        detail::require_numbers(position, 2);
        const double x = require_finite("x", static_cast<double>(position[0]));
        const double y = require_finite("y", static_cast<double>(position[1]));
        return state_id(ring_of(std::hypot(x, y)) * sectors_ + sector_of(std::atan2(y, x)));
    }

    /// The ring of a distance (>= 0).
    [[nodiscard]] std::size_t ring_of(double distance) const noexcept {
        std::size_t ring = 0;
        while (ring < edges_.size() && distance >= edges_[ring]) ++ring;
        return ring;
    }

    /// The sector of a finite angle in radians.
    [[nodiscard]] std::size_t sector_of(double angle_rad) const noexcept {
        const auto n = static_cast<double>(sectors_);
        const double turns = angle_rad / 6.283185307179586476925;
        double sector = std::floor((turns - std::floor(turns)) * n + 0.5);
        if (sector >= n) sector = 0.0;
        return static_cast<std::size_t>(sector);
    }

    /// "sector 6 (180 deg), ring 0 (< 0.7)".
    [[nodiscard]] std::string describe(StateId s) const {
        const std::size_t id = index(detail::require_state_of(s, size()));
        const std::size_t sector = id % sectors_;
        const std::size_t ring = id / sectors_;
        const double angle = 360.0 * static_cast<double>(sector) / static_cast<double>(sectors_);
        std::string extent;
        if (edges_.empty()) {
            extent = "any distance";
        } else if (ring == 0) {
            extent = "< " + detail::to_text(edges_[0]);
        } else if (ring == edges_.size()) {
            extent = ">= " + detail::to_text(edges_[ring - 1]);
        } else {
            extent = detail::to_text(edges_[ring - 1]) + " to " + detail::to_text(edges_[ring]);
        }
        return "sector " + std::to_string(sector) + " (" + detail::to_text(angle) + " deg), ring " + std::to_string(ring) +
               " (" + extent + ")";
    }

private:
    std::size_t sectors_;
    std::vector<double> edges_;
};

}  // namespace sspql
