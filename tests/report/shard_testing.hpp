// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

#include "report/fabricated_results.hpp"
#include "report/findings.hpp"

/// \file
/// Findings to be cut into shards: no two of their numbers are the same, and some are the numbers that text loses
/// first.

namespace sspql::shards {

/// Equal to the bit: -0.0 is not 0.0, and NaN is NaN.
inline bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

inline constexpr double awkward[] = {0.1,
                                     -0.0,
                                     1.0 / 3.0,
                                     5e-324,
                                     1.7976931348623157e308,
                                     123456789012345680.0,
                                     std::numeric_limits<double>::infinity(),
                                     -std::numeric_limits<double>::infinity(),
                                     std::numeric_limits<double>::quiet_NaN()};

/// A run of one seed, different for every seed.
inline report::SeedRun awkward_run(std::uint64_t seed) {
    report::SeedRun run;
    run.seed = seed;
    std::uint32_t steps = std::numeric_limits<std::uint32_t>::max() - static_cast<std::uint32_t>(seed);
    for (const double value : awkward) {
        run.episodes.push_back({steps, value, steps % 2 == 0, steps % 3 == 0});
        --steps;
    }
    run.reward_at = {awkward[seed % 6], 2.0 / static_cast<double>(seed)};
    run.steps = std::numeric_limits<std::uint64_t>::max() - seed;
    run.model_operations = (std::uint64_t{1} << 53) + seed;
    run.learning_ns = 1e9 / (static_cast<double>(seed) + 2.0);
    return run;
}

/// Two learners, five seeds, one phase.
inline report::ExperimentResults awkward_results() {
    report::ExperimentResults results;
    results.experiment = "pusher_experiment";
    results.settings = {{"task", "a \"quoted\" \\ word"}, {"noise", "0.5", false}, {"set", "[\"*.gamma=.9\"]", false}};
    results.manifest = {"pusher_experiment --seeds 5", "0", "g++ 12.2.0"};
    report::PhaseRuns phase{"approach", 1.0 / 7.0, std::nullopt, {10, 20}, {}};
    for (const std::uint64_t learner : {0, 100}) {
        phase.learners.push_back({"learner" + std::to_string(learner), {}});
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            phase.learners.back().runs.push_back(awkward_run(learner + seed));
        }
    }
    results.phases.push_back(phase);
    return results;
}

inline report::PusherFindings pusher_findings() {
    report::PusherFindings findings{awkward_results(), {}};
    findings.typical_paths = {{{"learner0, episode 7", {{0.1, -0.0, 1.0 / 3.0}, {5e-324, 2.5, -1.0}}}},
                              {{"learner100, episode 8", {{0.7, 0.8, 0.9}}}, {"another", {}}}};
    return findings;
}

inline report::GridFindings grid_findings() {
    report::GridFindings findings{awkward_results(), {}, {7u, 4000000000u}};
    findings.results.experiment = "grid_experiment";
    findings.results.phases.push_back(findings.results.phases.front());
    findings.results.phases.back().name = "second";
    findings.results.phases.back().optimal_return = -0.0;
    using report::GridCellKind;
    using report::GridMove;
    report::GridPicture picture;
    picture.rows = 2;
    picture.columns = 3;
    picture.value_name = "Q";
    picture.cells = {{GridCellKind::free, 0.1, GridMove::up},    {GridCellKind::wall, std::nullopt, std::nullopt},
                     {GridCellKind::goal, -0.0, GridMove::down}, {GridCellKind::hazard, 1.0 / 3.0, GridMove::left},
                     {GridCellKind::start, 2.0, std::nullopt},   {GridCellKind::free, std::nullopt, GridMove::right}};
    picture.cells[3].why = "left: 1, \"tried\" 3x\nup: never tried";
    for (report::GridPictureCell& cell : picture.cells)
        cell.why = "why " + std::to_string(&cell - picture.cells.data());
    report::GridPicture none;
    findings.pictures = {{{picture, none}, "Seed 1"}, {{}, "nothing is drawn"}};
    return findings;
}

}  // namespace sspql::shards
