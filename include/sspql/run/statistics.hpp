// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace sspql {

/// Mean, sample standard deviation (n - 1) and standard error of a sample. `deviation` and `error` are 0 for fewer than
/// two values; `count` says so.
struct Summary {
    std::size_t count = 0;   ///< how many values
    double mean = 0.0;       ///< 0 for none
    double deviation = 0.0;  ///< sample standard deviation, with n - 1
    double error = 0.0;      ///< standard error of the mean
};

/// Two passes in the order of the values: the same numbers on every machine, no cancellation. O(n).
[[nodiscard]] inline Summary summarize(const std::vector<double>& values) {
    Summary summary;
    summary.count = values.size();
    if (values.empty()) return summary;
    if (std::all_of(values.begin(), values.end(), [&](double value) { return value == values.front(); })) {
        summary.mean = values.front();  // sum / n could differ in the last digit, and so seem to vary
        return summary;
    }
    const auto n = static_cast<double>(values.size());
    double sum = 0.0;
    for (const double value : values) sum += value;
    summary.mean = sum / n;
    double squares = 0.0;
    for (const double value : values) squares += (value - summary.mean) * (value - summary.mean);
    summary.deviation = std::sqrt(squares / (n - 1.0));
    summary.error = summary.deviation / std::sqrt(n);
    return summary;
}

/// How many standard errors the mean of `a` lies above the mean of `b`; the samples count as independent. 0 when
/// neither sample varies.
[[nodiscard]] inline double z_score(const Summary& a, const Summary& b) {
    const double error = std::sqrt(a.error * a.error + b.error * b.error);
    return error > 0.0 ? (a.mean - b.mean) / error : 0.0;
}

}  // namespace sspql
