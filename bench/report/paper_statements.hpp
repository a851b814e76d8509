// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/honest_comparison.hpp"
#include "report/recorded_place.hpp"

/// \file
/// The statements, one function for each part of the paper or of the field it is compared with.

namespace sspql::report {

[[nodiscard]] ComparisonSection scratch_section(const std::vector<Place>& grids);
[[nodiscard]] ComparisonSection change_section(const std::vector<Place>& grids);
[[nodiscard]] ComparisonSection constant_section(const std::vector<Place>& grids);
[[nodiscard]] ComparisonSection table1_section(const std::vector<Place>& approaches);
[[nodiscard]] ComparisonSection robot_section(const std::vector<Place>& tasks);
[[nodiscard]] ComparisonSection cost_section(const std::vector<RecordedRun>& runs);
[[nodiscard]] ComparisonSection chain_section(const std::vector<Place>& chains);
[[nodiscard]] ComparisonSection maze_section(const std::vector<Place>& mazes);
[[nodiscard]] ComparisonSection adaptive_section(const std::vector<Place>& grids);

/// k of a learner that plans: its suffix (":20"), or --set, or the default.
[[nodiscard]] std::string planning_steps(const RecordedRun& run, const std::string& learner);

/// Over all phases and seeds.
[[nodiscard]] double steps_per_episode(const RecordedRun& run, const std::string& learner);

}  // namespace sspql::report
