// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/recorded_run.hpp"
#include "report/verdict.hpp"

/// \file
/// docs/honest-comparison.md: what recorded runs say about the statements of Kwon, Suh and Lee (2011). No verdict is
/// written down here; all are computed.

namespace sspql::report {

/// What one place (a map, a task) of a recorded run says about a statement.
struct Finding {
    std::string where{};
    std::string numbers{};
    Contest contest{};
};

/// A statement with all findings about it.
struct Statement {
    std::string claim{};
    std::vector<Finding> findings{};

    [[nodiscard]] Tally tally() const;
};

/// The statements about one part of the paper.
struct ComparisonSection {
    std::string heading{};
    std::string intro{};
    std::vector<Statement> statements{};
    bool side_by_side = false;  ///< the statements have the same findings, but for the verdicts: one table row for each
};

/// All statements against these runs, in the paper's order. A statement that no run bears on has no finding, or only
/// missing ones.
[[nodiscard]] std::vector<ComparisonSection> compare_runs(const std::vector<RecordedRun>& runs);

/// The page, as Markdown: verdicts, findings, all numbers, and the commands they come from.
[[nodiscard]] std::string honest_comparison(const std::vector<RecordedRun>& runs);

}  // namespace sspql::report
