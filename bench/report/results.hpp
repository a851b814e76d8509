// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// \file
/// What an experiment program measured, raw: every episode of every seed. The writers (JSON, CSV, HTML, the table on
/// the terminal) all derive their numbers from this one structure, so that they cannot disagree.

namespace sspql::report {

/// One episode: how it went.
struct EpisodeRecord {
    std::uint32_t steps = 0;    ///< a capped episode counts its steps
    double total_reward = 0.0;  ///< undiscounted return
    bool success = false;       ///< the terminal reward says so
    bool capped = false;        ///< cut by the step limit
};

/// One seed's run of one learner: its episodes in order.
struct SeedRun {
    std::uint64_t seed = 0;
    std::vector<EpisodeRecord> episodes;
    /// Reward collected up to each report step (tasks counted in steps; else empty), in the order of `report_at`.
    std::vector<double> reward_at;
    std::uint64_t steps = 0;             ///< all steps of the run
    std::uint64_t model_operations = 0;  ///< edges and records the learner touched
    double learning_ns = 0.0;            ///< time spent in the learner; the only number that may differ between runs
};

struct LearnerRuns {
    std::string name;
    std::vector<SeedRun> runs;  ///< by seed
};

struct PhaseRuns {
    std::string name;
    std::optional<double> optimal_steps;
    std::optional<double> optimal_return;
    std::vector<std::uint64_t> report_at;  ///< steps at which `reward_at` was read
    std::vector<LearnerRuns> learners;
};

/// A setting as it appears in the JSON's "settings": text, number or boolean by its own spelling.
struct Setting {
    std::string key;
    std::string value;
    bool quoted = true;  ///< false: `value` is already JSON (a number, true, a list)
};

struct Manifest {
    std::string command;   ///< as typed
    std::string version;   ///< SSPQL_VERSION
    std::string compiler;  ///< name and version
};

struct ExperimentResults {
    std::string experiment;  ///< "pusher_experiment", "grid_experiment"
    std::vector<Setting> settings;
    Manifest manifest;
    std::vector<PhaseRuns> phases;
};

}  // namespace sspql::report
