// SPDX-License-Identifier: MIT
#include "viewer/display.hpp"

#include <cstdlib>
#include <fstream>
#include <stdexcept>

#ifdef SSPQL_HAS_X11
#include <X11/Xlib.h>
#endif

namespace sspql::viewer {

#ifdef SSPQL_HAS_X11

DisplayConnection::DisplayConnection() {
    const char* name = std::getenv("DISPLAY");
    if (name == nullptr || *name == '\0') {
        throw std::runtime_error(
            "no display to open a window on: DISPLAY is not set (without a screen: xvfb-run -a ...)");
    }
    Display* display = XOpenDisplay(nullptr);
    if (display == nullptr) throw std::runtime_error("cannot open the display '" + std::string(name) + "'");
    int opcode = 0;
    int event = 0;
    int error = 0;
    if (XQueryExtension(display, "GLX", &opcode, &event, &error) == 0) {
        XCloseDisplay(display);
        throw std::runtime_error("the display '" + std::string(name) + "' has no OpenGL (GLX)");
    }
    display_ = display;
}

DisplayConnection::~DisplayConnection() { XCloseDisplay(static_cast<Display*>(display_)); }

#else

DisplayConnection::DisplayConnection() = default;
DisplayConnection::~DisplayConnection() = default;

#endif

std::string font_file(const std::string& wanted) {
    const auto exists = [](const std::string& path) { return std::ifstream(path).good(); };
    if (!wanted.empty()) {
        if (!exists(wanted)) throw std::runtime_error("cannot read the font " + wanted);
        return wanted;
    }
    for (const char* path : {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",  // Debian
                             "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans.ttf",
                             "/usr/share/fonts/dejavu/DejaVuSans.ttf"}) {
        if (exists(path)) return path;
    }
    throw std::runtime_error("DejaVuSans.ttf not found: install fonts-dejavu-core, or name a font with --font FILE");
}

}  // namespace sspql::viewer
