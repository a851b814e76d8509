// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <sspql/core/random.hpp>

#include "grid_task.hpp"

namespace sspql::floors {

/// The world of the benchmark: a grid without walls, four moves, one step in ten goes in one of the three other
/// directions. The last cell ends the episode.
class SlipperyGrid {
public:
    SlipperyGrid(std::uint32_t columns, std::uint32_t rows) : columns_(columns), rows_(rows) {}

    [[nodiscard]] std::uint32_t states() const { return columns_ * rows_; }

    [[nodiscard]] std::uint32_t moved(std::uint32_t s, std::uint32_t direction) const {
        const std::uint32_t column = s % columns_;
        const std::uint32_t row = s / columns_;
        switch (direction) {
            case 0: return row > 0 ? s - columns_ : s;
            case 1: return row + 1 < rows_ ? s + columns_ : s;
            case 2: return column > 0 ? s - 1 : s;
            default: return column + 1 < columns_ ? s + 1 : s;
        }
    }

    [[nodiscard]] static std::uint32_t direction(std::uint32_t action, Random& random) {
        if (!random.chance(0.1)) return action;
        const auto other = static_cast<std::uint32_t>(random.below(3));
        return other < action ? other : other + 1;
    }

    /// Calls f(Step) for `times` tries of every (s,a), without rewards. The steps of a state come ordered by outcome,
    /// then action, so that everybody who lists outcomes and predecessors as they turn up lists them in one order.
    template <class F>
    void explore(std::uint32_t times, std::uint64_t from, F&& f) const {
        Random random(from, RandomStream::noise);
        for (std::uint32_t s = 0; s + 1 < states(); ++s) {
            std::array<std::array<std::uint32_t, actions>, 4> count{};  // [outcome][action]
            std::array<std::uint32_t, 4> outcome{};
            std::uint32_t outcomes = 0;
            std::array<std::uint32_t, 4> place{};  // of a direction's outcome
            for (std::uint32_t d = 0; d < 4; ++d) {
                std::uint32_t i = 0;
                while (i < outcomes && outcome[i] != moved(s, d)) ++i;
                if (i == outcomes) outcome[outcomes++] = moved(s, d);
                place[d] = i;
            }
            for (std::uint32_t a = 0; a < actions; ++a) {
                for (std::uint32_t k = 0; k < times; ++k) ++count[place[direction(a, random)]][a];
            }
            for (std::uint32_t i = 0; i < outcomes; ++i) {
                for (std::uint32_t a = 0; a < actions; ++a) {
                    for (std::uint32_t k = 0; k < count[i][a]; ++k) {
                        f(Step{s, a, 0.0, outcome[i], outcome[i] + 1 == states()});
                    }
                }
            }
        }
    }

private:
    std::uint32_t columns_;
    std::uint32_t rows_;
};

/// A size at which something is measured, and its name in the tables.
struct GridSize {
    const char* name;
    std::uint32_t columns;
    std::uint32_t rows;

    [[nodiscard]] SlipperyGrid grid() const { return {columns, rows}; }
};

}  // namespace sspql::floors
