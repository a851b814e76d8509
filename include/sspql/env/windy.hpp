// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/model/transition_table.hpp>
#include <sspql/model/transition_table_builder.hpp>
#include <sspql/spaces/action_policy.hpp>

namespace sspql {

/// Which actions a windy grid world has, their number at the same time: up, down, left, right; then the diagonals
/// up-left, up-right, down-left, down-right; then staying, where only the wind moves the agent.
enum class WindyMoves : std::uint8_t { four = 4, king = 8, king_or_stay = 9 };

/// Settings of a windy grid world. The defaults are Sutton and Barto's.
struct WindyParams {
    /// A place on the grid.
    struct Cell {
        std::size_t row = 0;     ///< 0 is the uppermost
        std::size_t column = 0;  ///< 0 is the leftmost
    };

    /// By column: so many cells up the wind carries an agent that moves from there; negative ones down.
    std::vector<int> wind{0, 0, 0, 1, 1, 1, 2, 2, 1, 0};
    std::size_t rows = 7;                 ///< how many there are
    Cell start{3, 0};                     ///< where episodes begin
    Cell goal{3, 7};                      ///< which ends them
    WindyMoves moves = WindyMoves::four;  ///< which actions there are
    /// Where there is wind it is one stronger with this chance, and one weaker with the same; in [0, 0.5]. 1/3 in
    /// exercise 6.10.
    double gusts = 0.0;
    double step_reward = -1.0;  ///< of a step
    double goal_reward = -1.0;  ///< of the step that reaches the goal, instead of step_reward
};

/// The actions of a windy grid world in words: "up", "down-left" and so on. \throws std::invalid_argument above 8.
[[nodiscard]] inline std::string windy_move(ActionId a) {
    static constexpr std::array<const char*, 9> names{"up",       "down",      "left",       "right", "up-left",
                                                      "up-right", "down-left", "down-right", "stay"};
    return names[index(detail::require_action_of(a, names.size()))];
}

/// The windy grid world of Sutton and Barto (2018), example 6.5, and with king's moves or gusts that of exercises 6.9
/// and 6.10. States are cells row by row, s = row x columns + column. A move goes one cell and, at the same time, as
/// far up as the wind of the column it starts from blows; the edge stops both. With the defaults the goal is 15 steps
/// away at best, 7 with king's moves. The goal has no actions. \throws std::invalid_argument for a world without cells,
/// a start or goal outside, a start at the goal, gusts out of range or rewards that are not finite.
[[nodiscard]] inline TransitionTable windy_table(const WindyParams& params = {}) {
    const std::size_t columns = params.wind.size();
    detail::require_id_count("number of rows", params.rows);
    detail::require_id_count("number of columns", columns);
    const auto id = [&](const WindyParams::Cell& cell, const char* what) {
        if (cell.row >= params.rows) throw_invalid(std::string("row of the ") + what, "be inside", cell.row);
        if (cell.column >= columns) throw_invalid(std::string("column of the ") + what, "be inside", cell.column);
        return state_id(cell.row * columns + cell.column);
    };
    const StateId start = id(params.start, "start");
    const StateId goal = id(params.goal, "goal");
    if (start == goal) throw_invalid("start", "not be the goal", index(start));
    require_in("gusts", params.gusts, 0.0, 0.5);
    for (const int wind : params.wind) {
        if (wind < -1000000 || wind > 1000000) throw_invalid("wind", "lie between -1000000 and 1000000", wind);
    }

    static constexpr std::array<std::array<int, 2>, 9> ways{
        {{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {-1, 1}, {1, -1}, {1, 1}, {0, 0}}};  // row, column
    const auto within = [](std::size_t at, long long by, std::size_t size) {
        const auto last = static_cast<long long>(size) - 1;
        return static_cast<std::size_t>(std::clamp(static_cast<long long>(at) + by, 0LL, last));
    };
    const auto moves = static_cast<std::size_t>(params.moves);
    TransitionTableBuilder builder(params.rows * columns, moves);
    for (std::size_t s = 0; s < params.rows * columns; ++s) {
        if (state_id(s) == goal) continue;
        const std::size_t row = s / columns;
        const std::size_t column = s % columns;
        for (std::size_t a = 0; a < moves; ++a) {
            const auto add = [&](long long wind, double probability) {
                if (!(probability > 0.0)) return;
                const std::size_t to_row = within(row, ways[a][0] - wind, params.rows);
                const StateId to = state_id(to_row * columns + within(column, ways[a][1], columns));
                builder.add(state_id(s), action_id(a), to, probability,
                            to == goal ? params.goal_reward : params.step_reward, to == goal);
            };
            const int wind = params.wind[column];
            const double gusts = wind != 0 ? params.gusts : 0.0;
            add(wind, 1.0 - 2.0 * gusts);
            add(wind + 1, gusts);
            add(wind - 1, gusts);
        }
    }
    builder.start_in({start});
    return builder.build();
}

}  // namespace sspql
