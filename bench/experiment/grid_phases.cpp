// SPDX-License-Identifier: MIT
#include "experiment/grid_phases.hpp"

#include <stdexcept>
#include <utility>

#include <sspql/env/chain.hpp>
#include <sspql/env/grid_maps.hpp>
#include <sspql/env/table_csv.hpp>
#include <sspql/env/windy.hpp>
#include <sspql/io/crc32.hpp>

namespace sspql::experiment {

namespace {

SlipKind slip_kind(const std::string& name) {
    if (name == "perpendicular") return SlipKind::perpendicular;
    return name == "lost" ? SlipKind::lost : SlipKind::other;
}

/// Sutton and Barto's windy grid worlds: example 6.5, exercises 6.9 and 6.10.
std::optional<WindyParams> windy_params(const std::string& name) {
    if (name != "windy" && name != "windy-king" && name != "windy-gusts") return std::nullopt;
    WindyParams params;
    if (name != "windy") params.moves = WindyMoves::king;
    if (name == "windy-gusts") params.gusts = 1.0 / 3.0;
    return params;
}

GridPhase map_phase(const std::string& name, const GridOptions& options) {
    if (name == "chain") {
        const double slip = options.slip.value_or(0.1);
        if (slip >= 1.0) throw std::invalid_argument("--slip must be below 1 for the chain, whose goal is out of reach else");
        ChainParams params;
        params.probability = 1.0 - slip;
        TransitionTable table = chain_table(params);
        return {name, TabularEnvironment(table), table, {}, 0};
    }
    if (const std::optional<WindyParams> params = windy_params(name)) {
        if (options.slip) throw std::invalid_argument("--slip does not go with " + name + ": its chance is the wind's");
        TransitionTable table = windy_table(*params);
        return {name, TabularEnvironment(table), table, {}, 0};
    }
    std::optional<GridTask> task = find_grid_task(name);
    if (!task && name.find('/') == std::string::npos && name.find('.') == std::string::npos) {
        std::string names;
        for (const std::string& known : map_names()) names += known + ", ";
        throw std::invalid_argument("map must be one of " + names + "or walls60 and the like, got " + name);
    }
    if (!task) {
        task.emplace(GridTask{name, GridMap::load(name), {}, 0, {}});
        task->params.slip = 0.1;
        task->name = name.substr(name.find_last_of('/') + 1);
    }
    if (options.slip) task->params.slip = *options.slip;
    task->params.slip_kind = slip_kind(options.noise_kind);
    if (!task->changes.empty()) return {task->name, task->changing_world(), std::nullopt, {}, task->total_steps};
    GridWorld world = task->world();
    TransitionTable table = world.table();
    return {task->name, std::move(world), std::move(table), {}, 0};
}

std::vector<std::uint64_t> report_steps(const GridPhase& phase, const GridOptions& options) {
    std::vector<std::uint64_t> steps;
    for (const std::string& word : split(options.report_at, ',')) {
        std::uint64_t step = 0;
        for (const char c : word) {
            if (c < '0' || c > '9' || step > 1000000000) step = 0;
            if (c < '0' || c > '9') break;
            step = step * 10 + static_cast<std::uint64_t>(c - '0');
        }
        if (step == 0 || step > phase.total_steps || (!steps.empty() && step <= steps.back())) {
            throw std::invalid_argument("--report-at must be increasing steps from 1 to " +
                                        std::to_string(phase.total_steps) + ", got '" + options.report_at + "'");
        }
        steps.push_back(step);
    }
    if (!steps.empty() || phase.total_steps == 0) return steps;
    if (const auto* changing = std::get_if<ChangingGridWorld>(&phase.world)) {
        for (const MapChange& change : changing->changes()) steps.push_back(change.from_step);
    }
    if (steps.empty() || steps.back() < phase.total_steps) steps.push_back(phase.total_steps);
    return steps;
}

}  // namespace

std::vector<std::string> map_names() {
    std::vector<std::string> names{"chain", "windy", "windy-king", "windy-gusts"};
    for (const std::string& name : grid_task_names()) names.push_back(name);
    return names;
}

std::vector<GridPhase> phases_of(const GridOptions& options) {
    if (options.maps.empty() == options.table.empty()) {
        throw std::invalid_argument(options.maps.empty() ? "give --maps or --table (--help lists the options)"
                                                         : "give --maps or --table, not both");
    }
    std::vector<GridPhase> phases;
    if (!options.table.empty()) {
        TransitionTable table = load_table_csv(options.table);
        phases.push_back({options.table.substr(options.table.find_last_of('/') + 1), TabularEnvironment(table), table, {}, 0});
    }
    for (const std::string& name : split(options.maps, ',')) phases.push_back(map_phase(name, options));
    for (GridPhase& phase : phases) {
        if (phase.states() != phases.front().states() || phase.actions() != phases.front().actions()) {
            const auto size = [](const GridPhase& p) {
                return p.name + " has " + std::to_string(p.states()) + " cells and " + std::to_string(p.actions()) + " actions";
            };
            throw std::invalid_argument("the maps of a chain must be equally large: " + size(phases.front()) + ", " +
                                        size(phase));
        }
        if (options.total_steps > 0) phase.total_steps = static_cast<std::size_t>(options.total_steps);
        if (phase.total_steps == 0 && !options.report_at.empty()) {
            throw std::invalid_argument("--report-at needs --total-steps, or a map that changes while it runs");
        }
        phase.report_at = report_steps(phase, options);
    }
    return phases;
}

std::uint32_t checksum_of(const GridPhase& phase) {
    detail::Crc32 crc;
    const auto add = [&](const auto& value) { crc.add(&value, sizeof value); };
    const auto add_table = [&](const TransitionTable& table) {
        for (std::size_t i = 0; i < table.states() * table.actions(); ++i) {
            const StateId s = state_id(i / table.actions());
            for (const Outcome& outcome : table.outcomes(s, action_id(i % table.actions()))) {
                add(i);
                add(index(outcome.next));
                add(outcome.probability);
                add(outcome.reward);
                add(outcome.terminal);
            }
        }
        for (const StateId s : table.starts()) add(index(s));
    };
    add(phase.states());
    if (phase.table) add_table(*phase.table);
    return crc.value();
}

}  // namespace sspql::experiment
