// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <sspql/core/errors.hpp>
#include <sspql/env/changing_grid_world.hpp>
#include <sspql/env/grid_map.hpp>
#include <sspql/env/grid_world.hpp>
#include <sspql/env/random_walls.hpp>

/// \file
/// Grid worlds by name:
///
///     open64  soft54  soft47  nest54  nest47     8 x 8, goal in a corner, random start, slip 0.1; 64, 54 or 47 free
///                                                cells. Chains of maps in which walls are only added, as in Fig. 5 of
///                                                Kwon, Suh and Lee (2011), whose own maps are not printed:
///                                                open64, soft54, soft47 and open64, nest54, nest47
///     dyna-maze  blocking-maze  shortcut-maze    Sutton and Barto (2018), Fig. 8.2 and examples 8.2 and 8.3
///     cliff                                      the same, example 6.6: -1 a step, -100 and back to the start below
///     walls60  walls60:2 ...                     60 x 60 (or 4 to 300) cells, a fifth of them walls at random, goal in a
///                                                corner, random start, slip 0.1; the number behind the colon chooses
///                                                another map (default 1)

namespace sspql {

/// A grid world by name: its map, how it changes within a run, and the settings it is known with.
struct GridTask {
    std::string name;                ///< what it is called
    GridMap map;                     ///< the map at the beginning
    std::vector<MapChange> changes;  ///< the maps that follow it in a run, and when
    std::size_t total_steps = 0;     ///< length of a run that is counted in steps; 0: counted in episodes
    GridWorldParams params{};        ///< slip and rewards

    /// The world at the beginning of a run.
    [[nodiscard]] GridWorld world() const { return GridWorld(map, params); }

    /// The world that changes during a run.
    [[nodiscard]] ChangingGridWorld changing_world() const { return ChangingGridWorld(world(), changes); }
};

namespace detail {

struct GridMapText {
    std::string_view name;
    std::string_view text;
    std::string_view changed;  // the map after the change, if there is one
    std::size_t from_step;
    std::size_t total_steps;
};

inline constexpr std::array<GridMapText, 9> grid_map_texts{{
    {"open64",
     "........\n"
     "........\n"
     "........\n"
     "........\n"
     "........\n"
     "........\n"
     "........\n"
     ".......G\n",
     "", 0, 0},
    {"soft54",
     "........\n"
     "..#.....\n"
     "..#..#..\n"
     ".....#..\n"
     "..#..#..\n"
     "..#.....\n"
     "....###.\n"
     ".......G\n",
     "", 0, 0},
    {"soft47",
     "..#..#..\n"
     "..#..#..\n"
     "..#..#..\n"
     "..#..#..\n"
     "..#..#.#\n"
     "..#.....\n"
     "..#####.\n"
     ".......G\n",
     "", 0, 0},
    {"nest54",
     "........\n"
     "........\n"
     "..######\n"
     "........\n"
     "........\n"
     "####....\n"
     "........\n"
     ".......G\n",
     "", 0, 0},
    {"nest47",
     "........\n"
     "........\n"
     ".#######\n"
     "...#....\n"
     ".....#..\n"
     "#######.\n"
     "......#.\n"
     ".......G\n",
     "", 0, 0},
    {"dyna-maze",
     ".......#G\n"
     "..#....#.\n"
     "S.#....#.\n"
     "..#......\n"
     ".....#...\n"
     ".........\n",
     "", 0, 0},
    {"blocking-maze",
     "........G\n"
     ".........\n"
     ".........\n"
     "########.\n"
     ".........\n"
     "...S.....\n",
     "........G\n"
     ".........\n"
     ".........\n"
     ".########\n"
     ".........\n"
     "...S.....\n",
     1000, 3000},
    {"shortcut-maze",
     "........G\n"
     ".........\n"
     ".........\n"
     ".########\n"
     ".........\n"
     "...S.....\n",
     "........G\n"
     ".........\n"
     ".........\n"
     ".#######.\n"
     ".........\n"
     "...S.....\n",
     3000, 6000},
    {"cliff",
     "............\n"
     "............\n"
     "............\n"
     "SHHHHHHHHHHG\n",
     "", 0, 0},
}};

/// The size and the number in "walls60:2", if it is such a name.
inline std::optional<std::pair<std::size_t, std::uint64_t>> walls_name(std::string_view name) {
    constexpr std::string_view prefix = "walls";
    if (name.substr(0, prefix.size()) != prefix) return std::nullopt;
    const char* at = name.data() + prefix.size();
    const char* end = name.data() + name.size();
    std::size_t size = 0;
    std::uint64_t number = 1;
    auto read = std::from_chars(at, end, size);
    if (read.ec != std::errc{} || size < 4 || size > 300) return std::nullopt;
    if (read.ptr != end) {
        if (*read.ptr != ':') return std::nullopt;
        read = std::from_chars(read.ptr + 1, end, number);
        if (read.ec != std::errc{} || read.ptr != end) return std::nullopt;
    }
    return std::make_pair(size, number);
}

/// The settings a map is known with: slip 0.1 for ours, none for the book's; costs for the cliff.
inline GridWorldParams known_params(std::string_view name, bool has_start) {
    GridWorldParams params;
    if (!has_start) params.slip = 0.1;
    if (name == "cliff") params.rewards = GridRewards{-1.0, -1.0, -100.0, false};
    return params;
}

}  // namespace detail

/// The names of the built-in grid worlds.
[[nodiscard]] inline std::vector<std::string> grid_task_names() {
    std::vector<std::string> names;
    for (const detail::GridMapText& entry : detail::grid_map_texts) names.emplace_back(entry.name);
    return names;
}

/// The built-in grid world of this name, if there is one.
[[nodiscard]] inline std::optional<GridTask> find_grid_task(std::string_view name) {
    for (const detail::GridMapText& entry : detail::grid_map_texts) {
        if (entry.name != name) continue;
        const std::string text_name(name);
        const bool has_start = entry.text.find('S') != std::string_view::npos;
        GridTask task{text_name, GridMap::parse(entry.text, text_name), {}, entry.total_steps,
                      detail::known_params(name, has_start)};
        if (!entry.changed.empty()) {
            task.changes.push_back({entry.from_step, GridMap::parse(entry.changed, text_name)});
        }
        return task;
    }
    if (const auto walls = detail::walls_name(name)) {
        return GridTask{std::string(name), random_walls(walls->first, 0.2, walls->second), {}, 0,
                        detail::known_params(name, false)};
    }
    return std::nullopt;
}

/// The built-in grid world of this name. \throws std::invalid_argument, with the names there are, for another one.
[[nodiscard]] inline GridTask grid_task(std::string_view name) {
    std::optional<GridTask> task = find_grid_task(name);
    if (task) return *std::move(task);
    std::string known;
    for (const std::string& other : grid_task_names()) known += (known.empty() ? "" : ", ") + other;
    throw_invalid("map", "be one of " + known + ", or walls60 and the like", std::string(name));
}

}  // namespace sspql
