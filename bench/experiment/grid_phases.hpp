// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <sspql/env/changing_grid_world.hpp>
#include <sspql/env/grid_world.hpp>
#include <sspql/env/tabular_environment.hpp>

#include "experiment/options.hpp"

/// \file
/// The worlds that grid_experiment is asked for, by name or from files.

namespace sspql::experiment {

/// What grid_experiment understands.
struct GridOptions : CommonOptions {
    std::string maps;
    std::string table;
    std::optional<double> slip;
    std::string noise_kind = "other";
    std::int64_t total_steps = 0;
    std::string report_at;
    ShardOptions shards;

    GridOptions() {
        learners = "q-bonus,ps-bonus,sspql-bonus";
        seeds = 20;
        episodes = 50;
        steps_per_episode = 5000;
    }
};

/// One phase of the experiment: its world and what is known about it exactly.
struct GridPhase {
    std::string name;
    std::variant<GridWorld, ChangingGridWorld, TabularEnvironment> world;
    std::optional<TransitionTable> table;  ///< the world's, if it stays the same
    std::vector<std::uint64_t> report_at;
    std::size_t total_steps = 0;

    [[nodiscard]] std::size_t states() const {
        return std::visit([](const auto& w) { return w.size(); }, world);
    }
    [[nodiscard]] std::size_t actions() const {
        const auto* tabular = std::get_if<TabularEnvironment>(&world);
        return tabular != nullptr ? tabular->table().actions() : GridWorld::actions;
    }
};

/// The maps known by name; besides there are walls60, walls60:2 and the like.
[[nodiscard]] std::vector<std::string> map_names();

/// The phases that the options ask for, one after the other. \throws std::exception for names, files and numbers that
/// cannot be.
[[nodiscard]] std::vector<GridPhase> phases_of(const GridOptions& options);

/// Of the world as it is, not of its file: line ends and comments do not count.
[[nodiscard]] std::uint32_t checksum_of(const GridPhase& phase);

}  // namespace sspql::experiment
