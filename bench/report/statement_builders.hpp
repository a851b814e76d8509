// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/honest_comparison.hpp"
#include "report/recorded_place.hpp"

/// \file
/// What the statements of all parts are made of.

namespace sspql::report {

/// "1033 \u00b1 9"; one value has no error.
[[nodiscard]] std::string with_error(const Summary& summary, int digits);

/// "`dyna-q:20` 1033 \u00b1 9"
[[nodiscard]] std::string named(const std::string& name, const Summary& summary, int digits);

/// Every learner of a family (dyna-q with whatever k).
[[nodiscard]] std::vector<const LearnerStatistics*> members(const RecordedPhase& phase, std::string_view family);

[[nodiscard]] Finding missing(const Place& place, const std::string& what);

/// In the first 30 episodes, a against b.
[[nodiscard]] Finding fewer_steps(const Place& place, const LearnerStatistics& a, const LearnerStatistics& b);

/// At every place: a needs fewer steps than each member of b's family.
[[nodiscard]] Statement fewer_steps(const std::string& claim, const std::vector<Place>& places, const std::string& a,
                                    const std::string& b);

/// Against whoever of the rivals needed the fewest steps.
[[nodiscard]] Statement fewest_steps(const std::string& claim, const std::vector<Place>& places, const std::string& a,
                                     bool (*is_rival)(const std::string&));

}  // namespace sspql::report
