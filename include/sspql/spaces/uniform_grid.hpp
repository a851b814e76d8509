// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/spaces/state_policy.hpp>

namespace sspql {

/// One dimension of a UniformGrid: `cells` equal intervals over [low, high), in the unit of the observation.
/// `periodic`: the quantity comes round (an angle): values are taken modulo high - low. Otherwise values outside fall
/// into the first or last cell.
struct GridAxis {
    double low = 0.0;       ///< the lower end, included
    double high = 1.0;      ///< the upper end, excluded; > low
    std::size_t cells = 1;  ///< how many intervals, at least 1
    bool periodic = false;  ///< whether the quantity comes round
};

/// StatePolicy: equal boxes over R^N. The observation is anything with operator[] that gives N numbers
/// (std::array<double, N>, std::vector<double>, an Eigen vector); use ProjectedState to pick them out of a struct.
///
/// Ids run row by row, last dimension fastest. `encode` is O(N), allocates nothing and throws std::invalid_argument
/// for NaN or infinite values (a broken sensor must not look like a place) and for a vector of fewer than N numbers.
///
/// \throws std::invalid_argument for an empty, reversed or non-finite range, no cells, or more than 2^32 - 2 boxes.
template <std::size_t N>
class UniformGrid {
    static_assert(N >= 1, "sspql: a UniformGrid needs at least one dimension");

public:
    /// The grid over these axes, the slowest first.
    explicit UniformGrid(const std::array<GridAxis, N>& axes) : axes_(axes) {
        size_ = 1;
        for (const GridAxis& axis : axes_) {
            require_finite("low of a grid axis", axis.low);
            require_finite("high of a grid axis", axis.high);
            if (!(axis.high > axis.low)) throw_invalid("high of a grid axis", "exceed its low", axis.high);
            require_finite("range of a grid axis", axis.high - axis.low);
            detail::require_id_count("cells of a grid axis", axis.cells);
            if (axis.cells > (max_ids - 1) / size_) {
                throw_invalid("number of boxes", "stay below 4294967295; cells of the axis that exceeds it", axis.cells);
            }
            size_ *= axis.cells;
        }
    }

    /// The number of states: of boxes.
    [[nodiscard]] std::size_t size() const noexcept { return size_; }

    /// The state of anything with N numbers in operator[].
    template <class Observation>
    [[nodiscard]] auto encode(const Observation& values) const -> decltype(static_cast<double>(values[0]), StateId{}) {
        detail::require_numbers(values, N);
        return state_id(box(values, std::make_index_sequence<N>{}));
    }

    /// The middle of a state's box: where encode() gives this state back.
    [[nodiscard]] std::array<double, N> center(StateId s) const {
        const auto cells = cells_of(s);
        std::array<double, N> middle{};
        for (std::size_t i = 0; i < N; ++i) {
            const double width = (axes_[i].high - axes_[i].low) / static_cast<double>(axes_[i].cells);
            middle[i] = axes_[i].low + (static_cast<double>(cells[i]) + 0.5) * width;
        }
        return middle;
    }

    /// "[0.5, 1) x [2, 3)".
    [[nodiscard]] std::string describe(StateId s) const {
        const auto cells = cells_of(s);
        std::string text;
        for (std::size_t i = 0; i < N; ++i) {
            const double width = (axes_[i].high - axes_[i].low) / static_cast<double>(axes_[i].cells);
            const double low = axes_[i].low + static_cast<double>(cells[i]) * width;
            text += (i == 0 ? "[" : " x [") + detail::to_text(low) + ", " + detail::to_text(low + width) + ")";
        }
        return text;
    }

    /// The axes, as given.
    [[nodiscard]] const std::array<GridAxis, N>& axes() const noexcept { return axes_; }

private:
    /// Constant indices: they convert without a warning to whatever type the observation counts in.
    template <class Observation, std::size_t... I>
    std::size_t box(const Observation& values, std::index_sequence<I...>) const {
        std::size_t id = 0;
        ((id = id * axes_[I].cells + cell(axes_[I], static_cast<double>(values[I]))), ...);
        return id;
    }

    static std::size_t cell(const GridAxis& axis, double value) {
        require_finite("observation", value);
        double unit = (value - axis.low) / (axis.high - axis.low);
        if (axis.periodic) unit -= std::floor(unit);
        if (!(unit > 0.0)) return 0;
        if (unit >= 1.0) return axis.periodic ? 0 : axis.cells - 1;
        const auto i = static_cast<std::size_t>(unit * static_cast<double>(axis.cells));
        return i < axis.cells ? i : axis.cells - 1;
    }

    [[nodiscard]] std::array<std::size_t, N> cells_of(StateId s) const {
        std::size_t rest = index(detail::require_state_of(s, size_));
        std::array<std::size_t, N> cells{};
        for (std::size_t i = N; i-- > 0;) {
            cells[i] = rest % axes_[i].cells;
            rest /= axes_[i].cells;
        }
        return cells;
    }

    std::array<GridAxis, N> axes_;
    std::size_t size_ = 0;
};

}  // namespace sspql
