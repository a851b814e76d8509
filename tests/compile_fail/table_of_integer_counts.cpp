// expect: sspql: these counts keep no rewards; use TransitionCounts<FadingCell> or table_of(counts, reward)
// SPDX-License-Identifier: MIT
#include <sspql/model/table_of_counts.hpp>

std::size_t outcomes(const sspql::TransitionCounts<sspql::CountCell>& counts) { return sspql::table_of(counts).size(); }
