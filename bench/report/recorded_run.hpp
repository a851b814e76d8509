// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/learner_statistics.hpp"

/// \file
/// Results read back from the JSON that grid_experiment and pusher_experiment write.

namespace sspql::report {

/// A phase as recorded. What the JSON leaves out stays empty: `all_episodes`, the error of returns' rates and the like.
struct RecordedPhase {
    std::string name;
    std::optional<double> optimal_steps;
    std::vector<LearnerStatistics> learners;  ///< `learn_ns_per_step` is the whole run's; NaN if not recorded

    /// The learner of that name, or nullptr.
    [[nodiscard]] const LearnerStatistics* find(std::string_view learner) const noexcept;
};

struct RecordedRun {
    std::string file;  ///< its name, without folders
    std::string experiment;
    std::string version;
    std::vector<std::pair<std::string, std::string>> settings;  ///< each value as JSON text, in the file's order
    std::vector<RecordedPhase> phases;

    /// A setting: a text without its quotes, a number or list as JSON; empty if there is none or it is null.
    [[nodiscard]] std::string setting(std::string_view key) const;

    /// The command that records this run again, from its settings. Files are named without their folders.
    [[nodiscard]] std::string command() const;
};

/// Reads a report. \throws std::runtime_error "PATH: ..." for text that is none.
[[nodiscard]] RecordedRun parse_recorded_run(const std::string& text, const std::string& path);

/// The same from a file. \throws std::runtime_error also "PATH: cannot be opened".
[[nodiscard]] RecordedRun load_recorded_run(const std::string& path);

/// "dyna-q" of "dyna-q:20".
[[nodiscard]] std::string_view family_of(std::string_view learner) noexcept;

}  // namespace sspql::report
