// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace sspql::report {

/// A table of GitHub's Markdown, an empty line after it. Columns from `numeric_from` on are aligned to the right; `|`
/// and line ends in cells are made harmless.
[[nodiscard]] std::string markdown_table(const std::vector<std::string>& headings,
                                         const std::vector<std::vector<std::string>>& rows, std::size_t numeric_from);

}  // namespace sspql::report
