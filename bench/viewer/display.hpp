// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace sspql::viewer {

/// Checks that a window with OpenGL can be opened: SFML ends the program where it cannot, with nothing said that helps.
/// \throws std::runtime_error that says what is missing.
void require_display();

/// The file of a font for all texts: `wanted`, or where systems keep DejaVu Sans if that is empty.
/// \throws std::runtime_error naming what can be done, if there is none.
[[nodiscard]] std::string font_file(const std::string& wanted);

}  // namespace sspql::viewer
