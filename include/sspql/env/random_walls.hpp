// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <sspql/core/errors.hpp>
#include <sspql/core/random.hpp>
#include <sspql/env/grid_map.hpp>

namespace sspql {

/// A square map of `size` x `size` cells, each a wall with chance `walls`, the goal in the last corner, random start.
/// Cells from which the goal cannot be reached become walls; maps where fewer than nine tenths of the cells that were
/// meant to be free remain are drawn anew. The same seed gives the same map. O(size^2) expected.
/// \throws std::invalid_argument for a size outside [2, 4096] or a share of walls outside [0, 0.3], beyond which a map
/// seldom hangs together.
[[nodiscard]] inline GridMap random_walls(std::size_t size, double walls, std::uint64_t seed) {
    if (size < 2 || size > 4096) throw_invalid("size of a map", "lie between 2 and 4096", size);
    require_in("share of walls", walls, 0.0, 0.3);
    const std::size_t cells = size * size;
    Random random(seed, RandomStream::environment);
    std::vector<bool> free(cells);
    std::vector<bool> reached(cells);
    std::vector<std::size_t> todo;
    std::size_t count = 0;
    do {
        for (std::size_t i = 0; i + 1 < cells; ++i) free[i] = !random.chance(walls);
        free[cells - 1] = true;
        reached.assign(cells, false);
        reached[cells - 1] = true;
        todo.assign(1, cells - 1);
        count = 0;
        while (!todo.empty()) {
            const std::size_t at = todo.back();
            todo.pop_back();
            ++count;
            const auto reach = [&](bool inside, std::size_t to) {
                if (!inside || !free[to] || reached[to]) return;
                reached[to] = true;
                todo.push_back(to);
            };
            reach(at >= size, at - size);
            reach(at + size < cells, at + size);
            reach(at % size != 0, at - 1);
            reach(at % size + 1 != size, at + 1);
        }
    } while (static_cast<double>(count) < 0.9 * (1.0 - walls) * static_cast<double>(cells));
    std::string text;
    text.reserve(cells + size);
    for (std::size_t i = 0; i < cells; ++i) {
        text += i + 1 == cells ? 'G' : reached[i] ? '.' : '#';
        if (i % size + 1 == size) text += '\n';
    }
    return GridMap::parse(text, "walls" + std::to_string(size));
}

}  // namespace sspql
