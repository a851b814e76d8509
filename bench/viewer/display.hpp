// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace sspql::viewer {

/// A connection to the display, made before SFML's: SFML ends the program where there is none, with nothing said that
/// helps. To be held while the window is open: a server like Xvfb starts over, and is gone for a moment, when its last
/// connection is closed. Where there is no X11 it does nothing.
class DisplayConnection {
public:
    /// \throws std::runtime_error that says what is missing for a window with OpenGL.
    DisplayConnection();
    DisplayConnection(const DisplayConnection&) = delete;
    DisplayConnection& operator=(const DisplayConnection&) = delete;
    ~DisplayConnection();

private:
    [[maybe_unused]] void* display_ = nullptr;
};

/// The file of a font for all texts: `wanted`, or where systems keep DejaVu Sans if that is empty.
/// \throws std::runtime_error naming what can be done, if there is none.
[[nodiscard]] std::string font_file(const std::string& wanted);

}  // namespace sspql::viewer
