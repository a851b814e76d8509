// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <sspql/run/statistics.hpp>

/// \file
/// Whether the numbers bear a statement out: the one rule behind every verdict of docs/honest-comparison.md.

namespace sspql::report {

enum class Verdict {
    holds,
    fails,
    open,    ///< chance can explain the difference, or there is one seed only
    missing  ///< not in the recorded run
};

/// "holds", "does not hold", "not decided", "not in the recorded run".
[[nodiscard]] std::string verdict_text(Verdict verdict);

/// Means further apart than this many standard errors of their difference differ.
inline constexpr double decisive_z = 2.0;

/// Two means compared.
struct Contest {
    Verdict verdict = Verdict::missing;
    double ratio = 0.0;        ///< of the first mean to the second
    double ratio_error = 0.0;  ///< its standard error, to first order
    double z = 0.0;  ///< standard errors by which the statement is true (negative: false), the samples as independent
};

/// Whether a's mean is below (above) b's, by `decisive_z` standard errors. One value each decides nothing; samples that
/// do not vary are compared as they are, equal ones stay open.
[[nodiscard]] Contest is_less(const Summary& a, const Summary& b);
[[nodiscard]] Contest is_greater(const Summary& a, const Summary& b);

/// Whether a's mean is at least `factor` (> 0) times b's.
[[nodiscard]] Contest is_multiple(const Summary& a, const Summary& b, double factor);

/// How many of some verdicts are which.
struct Tally {
    std::size_t holds = 0;
    std::size_t fails = 0;
    std::size_t open = 0;
    std::size_t missing = 0;

    void add(Verdict verdict);

    /// "holds in 3 of 4, does not hold in 1" of those that are not missing; the verdict alone if there is one.
    [[nodiscard]] std::string text() const;
};

}  // namespace sspql::report
