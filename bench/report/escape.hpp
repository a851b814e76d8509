// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace sspql::report {

/// `text` so that HTML and SVG show it as it is, in element content and in quoted attributes: & < > " ' become
/// entities, control characters other than tab and newline (which XML forbids) become U+FFFD.
[[nodiscard]] std::string escaped(std::string_view text);

}  // namespace sspql::report
