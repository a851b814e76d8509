// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

/// \file
/// Report files that are either written whole or not at all.

namespace sspql::report {

/// Checks that `write_file(path, ...)` can be expected to work: call it before a run of minutes. It creates and removes
/// a file in the target's directory; it neither leaves a file behind nor touches an existing one.
///
/// \throws std::runtime_error "cannot write PATH: REASON".
void require_writable(const std::string& path);

/// Where an experiment's reports go; an empty path: nowhere.
struct OutputFiles {
    std::string json{};
    std::string html{};
    std::string csv{};
    std::string arena_svg{};
    std::string curves_svg{};

    /// Whether something is drawn.
    [[nodiscard]] bool drawn() const noexcept { return !html.empty() || !arena_svg.empty() || !curves_svg.empty(); }

    /// Those that are not empty, each after its option: "--json", "report.json".
    [[nodiscard]] std::vector<std::pair<std::string, std::string>> given() const;
};

/// The same for all of them.
void require_writable(const OutputFiles& files);

/// Makes `text` the content of `path`, whole or not at all: see AtomicFile.
///
/// \throws std::runtime_error "cannot write PATH: REASON"; the old content is then untouched and no new file is left.
void write_file(const std::string& path, const std::string& text);

}  // namespace sspql::report
