// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <SFML/Graphics/RenderWindow.hpp>

#include "experiment/live_session.hpp"
#include "viewer/canvas.hpp"
#include "viewer/panel_view.hpp"

namespace sspql::viewer {

/// The window: hands keys to the session and draws it. A font NAME.ttf is joined by NAME-Bold.ttf, if there is one.
/// \throws std::runtime_error (constructor) if the font cannot be used or no window can be opened; hold a
/// DisplayConnection.
class ViewerWindow {
public:
    ViewerWindow(const std::string& font, PanelCaption caption);

    /// At most so many frames a second; 0: as many as can be drawn.
    void limit_frames(unsigned per_second) { window_.setFramerateLimit(per_second); }

    /// Hands what was typed since the last call to the session; closing the window is quitting.
    void handle_events(experiment::LiveSession& session);

    /// Draws a frame, unseen until `show`.
    void draw(const experiment::LiveSession& session);
    void show() { window_.display(); }

    void set_title(const std::string& text);

    /// Writes what was drawn last as a PNG, whole or not at all. \throws std::runtime_error if that fails.
    void write_png(const std::string& path) const;

private:
    Fonts fonts_;
    PanelCaption caption_;
    sf::RenderWindow window_;
    std::string title_;
};

}  // namespace sspql::viewer
