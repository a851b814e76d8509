// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "report/line_chart.hpp"
#include "report/svg.hpp"

/// \file
/// A grid map with what was learnt on it, from plain numbers: nothing here knows the environments.

namespace sspql::report {

enum class GridCellKind { free, wall, goal, hazard, start };

/// The learnt action: which way its arrow points.
enum class GridMove { up, down, left, right };

struct GridPictureCell {
    GridCellKind kind = GridCellKind::free;
    std::optional<double> value{};     ///< the cell's colour; none (and NaN) leaves it blank
    std::optional<GridMove> action{};  ///< its arrow
    std::string why{};                 ///< more lines for who points at it
};

/// What `grid_picture` draws. Walls and goals show neither value nor action.
struct GridPicture {
    std::string title{};
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::vector<GridPictureCell> cells{};  ///< row by row from the top
    std::string value_name = "value";      ///< in the legend
    std::optional<ValueRange>
        range{};         ///< what the colours span; none: the values'. Give all pictures of a row the same
    bool legend = true;  ///< below the map
};

/// What may be drawn: more cells are too small to see and too many for a page.
inline constexpr std::size_t most_picture_cells = 2500;

/// Draws the map. \throws std::invalid_argument unless rows * columns == cells.size(), at least 1 and at most
/// `most_picture_cells`.
[[nodiscard]] Svg grid_picture(const GridPicture& picture);

/// What the values of all these pictures span; [0, 1] without values.
[[nodiscard]] ValueRange value_range(const std::vector<GridPicture>& pictures);

/// One legend for pictures without their own: the colour scale over `value_range` and the symbols that occur.
[[nodiscard]] Svg grid_legend(const std::vector<GridPicture>& pictures);

}  // namespace sspql::report
