// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// \file
/// Numbers as text, the same in every locale (no printf, no streams).

namespace sspql::report {

/// `value` with exactly `digits` digits after the point: 12.30. "-0" never appears. NaN and infinities are "n/a".
[[nodiscard]] std::string fixed_text(double value, int digits);

/// `value` with at most `most_digits` digits after the point, trailing zeros dropped: 12.3. Like fixed_text otherwise.
[[nodiscard]] std::string short_text(double value, int most_digits);

/// The shortest text that reads back as the same double: 0.1, 1e-07. Empty for NaN and infinities.
[[nodiscard]] std::string exact_text(double value);

}  // namespace sspql::report
