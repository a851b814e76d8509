// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/svg.hpp"

namespace sspql::report {

/// What a learner needs with one value of a parameter, on one task, as a multiple of what it needs with the default.
struct Sensitivity {
    double ratio = 1.0;  ///< > 0
    double error = 0.0;  ///< its standard error; 0 for none
};

/// A small chart: one parameter, everything else at its default.
struct SensitivityPanel {
    std::string title;
    std::vector<std::string> values;              ///< as they stand below the axis, left to right
    std::size_t standard = 0;                     ///< which of them is the default
    std::vector<std::vector<Sensitivity>> tasks;  ///< by task, then by value
};

/// Panels in rows of four, a line per task, all on one logarithmic scale from a half to `most`. A point beyond the
/// scale stands at its end with its number beside it. \throws std::invalid_argument if a panel has other than one ratio
/// for each task and value.
[[nodiscard]] Svg sensitivity_picture(const std::vector<SensitivityPanel>& panels,
                                      const std::vector<std::string>& tasks, double most, const std::string& label);

}  // namespace sspql::report
