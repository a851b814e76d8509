// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "report/grid_picture.hpp"
#include "report/svg.hpp"

/// \file
/// What a planner believes of a grid world, as panels side by side, from plain numbers: nothing here knows the learner.

namespace sspql::report {

struct BeliefCell {
    GridCellKind kind = GridCellKind::free;
    std::optional<double> steps{};   ///< how far the goal is believed to be; none: the cell was never seen
    std::optional<GridMove> next{};  ///< what would be done here
    std::array<bool, 4> untried{};   ///< by GridMove
    std::array<bool, 4> alarmed{};   ///< where the world was noticed to have changed
};

struct BeliefPanel {
    std::string title{};
    std::string subtitle{};
    std::vector<BeliefCell> cells{};     ///< row by row from the top
    std::optional<std::size_t> robot{};  ///< its cell
    std::vector<std::size_t> way{};      ///< cells it came through
};

/// Panels of equally large maps, in rows of `across`, and a legend below; 720 wide. The colour is stronger where the
/// goal is believed to be nearer. \throws std::invalid_argument without panels or with across = 0, for a panel whose
/// cells are not rows * columns > 0, or a robot or way outside.
[[nodiscard]] Svg belief_picture(const std::vector<BeliefPanel>& panels, std::size_t rows, std::size_t columns,
                                 std::size_t across, const std::string& label);

}  // namespace sspql::report
