// SPDX-License-Identifier: MIT
#include <sspql/model/table_of_counts.hpp>

std::size_t outcomes(const sspql::TransitionCounts<sspql::FadingCell>& counts) {
    return sspql::table_of(counts).size();
}
