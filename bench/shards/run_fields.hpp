// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "report/arena_picture.hpp"
#include "report/results.hpp"
#include "shards/fields.hpp"
#include "shards/shard.hpp"

/// \file
/// What the shards of all programs have in them: settings, runs, ways through the arena.

namespace sspql::shards {

/// A run, column by column: a quarter of the text and of the memory that a structure per episode takes.
struct RunColumns {
    std::uint64_t seed = 0;
    std::vector<std::uint32_t> steps{};  ///< by episode, as are the next three
    std::vector<double> returns{};
    std::string success{};  ///< '0' or '1'
    std::string capped{};
    std::vector<double> reward_at{};
    std::uint64_t total_steps = 0;
    std::uint64_t model_operations = 0;
    double learning_ns = 0.0;
};

template <class Io>
void fields(Io& io, Like<Io, RunColumns>& run) {
    auto& [seed, steps, returns, success, capped, reward_at, total_steps, model_operations, learning_ns] = run;
    io("seed", seed);
    io("steps", steps);
    io("returns", returns);
    io("success", success);
    io("capped", capped);
    io("reward_at", reward_at);
    io("total_steps", total_steps);
    io("model_operations", model_operations);
    io("learning_ns", learning_ns);
}

template <class Io>
void fields(Io& io, Like<Io, report::ArenaPose>& pose) {
    auto& [x, y, heading] = pose;
    io("x_m", x);
    io("y_m", y);
    io("heading_rad", heading);
}

template <class Io>
void fields(Io& io, Like<Io, report::ArenaPath>& path) {
    auto& [name, poses] = path;
    io("name", name);
    io("poses", poses);
}

[[nodiscard]] RunColumns columns_of(const report::SeedRun& run);

/// \throws FieldError if the columns are not equally long or a flag is neither '0' nor '1'.
[[nodiscard]] report::SeedRun run_of(const RunColumns& columns);

/// The runs of a shard's units, in order.
[[nodiscard]] Json written_runs(const std::vector<report::SeedRun>& runs, const Shard& shard);

/// Puts a shard's runs where they belong. \throws FieldError if there are too few or too many.
void read_runs(const Json& json, const Shard& shard, std::vector<report::SeedRun>& runs);

/// {"backend": "box2d", "seeds": "20"} as "settings", and the keys whose values are JSON already as "unquoted".
void write_settings(const std::vector<report::Setting>& settings, Json& head);
[[nodiscard]] std::vector<report::Setting> read_settings(const Json& head);

}  // namespace sspql::shards
