// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/learner_statistics.hpp"

/// \file
/// What Kwon, Suh and Lee (2011) report on the 'approach' task, and how a run compares with it.

namespace sspql::report {

/// A row of the paper's Table 1 and the figure with its learning curve.
struct PaperRow {
    std::string_view learner;  ///< our name
    std::string_view method;   ///< the paper's
    double steps;              ///< sum of episodes 1 to 30
    std::string_view figure;
};

/// The paper's row of a learner, or nullptr: it has four.
[[nodiscard]] const PaperRow* paper_row(std::string_view learner) noexcept;

/// The paper's name of a learner, or `learner` itself.
[[nodiscard]] std::string method_name(std::string_view learner);

/// The learner of that name, or nullptr.
[[nodiscard]] const LearnerStatistics* find_learner(const std::vector<LearnerStatistics>& learners,
                                                    std::string_view name) noexcept;

/// A statement of the paper next to what this run measured.
struct Claim {
    std::string statement;
    std::string measured;
    bool agrees = false;
};

/// Numbers agree when they lie within this part of the paper's.
inline constexpr double claim_tolerance = 0.1;

/// The paper's statements that these learners' data bear on, checked against nothing but these data. Empty without two
/// of the four learners, or with fewer than 30 episodes.
[[nodiscard]] std::vector<Claim> compare_with_paper(const std::vector<LearnerStatistics>& learners);

}  // namespace sspql::report
