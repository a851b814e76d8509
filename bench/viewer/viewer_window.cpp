// SPDX-License-Identifier: MIT
#include "viewer/viewer_window.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <utility>

#include <SFML/Graphics/Image.hpp>
#include <SFML/Graphics/Texture.hpp>
#include <SFML/System/Err.hpp>
#include <SFML/Window/Event.hpp>

#include "viewer/arena_view.hpp"
#include "viewer/curve_view.hpp"

namespace sspql::viewer {

namespace {

using experiment::LiveCommand;
using experiment::LiveKey;

constexpr float margin = 20.0F;
constexpr float arena_side = 728.0F;
constexpr float panel_left = margin + arena_side + 32.0F;
constexpr float panel_width = canvas_width - panel_left - margin;
constexpr float bottom = margin + arena_side;

std::optional<LiveCommand> command_of(const sf::Event& event) {
    if (event.type == sf::Event::Closed) return LiveCommand{LiveKey::quit};
    if (event.type == sf::Event::TextEntered) return experiment::command_of(event.text.unicode);
    if (event.type != sf::Event::KeyPressed) return std::nullopt;
    switch (event.key.code) {  // keys that type nothing
        case sf::Keyboard::Up: return LiveCommand{LiveKey::faster};
        case sf::Keyboard::Down: return LiveCommand{LiveKey::slower};
        case sf::Keyboard::Escape: return LiveCommand{LiveKey::quit};
        default: return std::nullopt;
    }
}

/// As large as the canvas, or what fits on the screen.
sf::VideoMode fitting_mode() {
    const sf::VideoMode desktop = sf::VideoMode::getDesktopMode();
    float scale = 1.0F;
    if (desktop.width > 0 && desktop.height > 0) {
        scale = std::min({scale, 0.95F * static_cast<float>(desktop.width) / canvas_width,
                          0.92F * static_cast<float>(desktop.height) / canvas_height});
    }
    return {static_cast<unsigned>(scale * canvas_width), static_cast<unsigned>(scale * canvas_height)};
}

}  // namespace

ViewerWindow::ViewerWindow(const std::string& font, PanelCaption caption) : caption_(std::move(caption)) {
    sf::err().rdbuf(nullptr);  // its messages are several lines and name no remedy; ours follow from what it returns
    if (!fonts_.plain.loadFromFile(font)) throw std::runtime_error("cannot use " + font + " as a font");
    fonts_.has_bold = fonts_.bold.loadFromFile(font.substr(0, font.rfind('.')) + "-Bold.ttf");
    sf::ContextSettings smooth;
    smooth.antialiasingLevel = 4;
    window_.create(fitting_mode(), "pusher_viewer", sf::Style::Default, smooth);
    if (!window_.isOpen()) throw std::runtime_error("cannot open a window on this display");
    window_.setKeyRepeatEnabled(false);
}

void ViewerWindow::handle_events(experiment::LiveSession& session) {
    sf::Event event{};
    while (window_.pollEvent(event)) {
        if (const auto command = command_of(event)) session.handle(*command);
    }
}

void ViewerWindow::draw(const experiment::LiveSession& session) {
    Canvas canvas(window_, fonts_);
    canvas.clear();
    draw_arena(canvas, {margin, margin}, arena_side, session);
    const float y = draw_panel(canvas, {panel_left, margin}, panel_width, session, caption_);
    draw_curve(canvas, {panel_left, y}, {panel_width, bottom - y}, session);
    draw_help_line(canvas, {margin, canvas_height - 19.0F});
    if (session.is_help_shown()) draw_help(canvas, session);
}

void ViewerWindow::set_title(const std::string& text) {
    if (text == title_) return;
    title_ = text;
    window_.setTitle(sf::String::fromUtf8(text.begin(), text.end()));
}

void ViewerWindow::write_png(const std::string& path) const {
    sf::Texture texture;
    const sf::Vector2u size = window_.getSize();
    const auto fail = [&path] { throw std::runtime_error("cannot write " + path); };
    if (!texture.create(size.x, size.y)) fail();
    texture.update(window_);
    // SFML does not say whether a file was written to its end: it is read again before it takes the name.
    const std::string part = path + ".part.png";
    sf::Image written;
    const bool is_whole = texture.copyToImage().saveToFile(part) && written.loadFromFile(part) &&
                          written.getSize() == size && std::rename(part.c_str(), path.c_str()) == 0;
    if (!is_whole) {
        std::remove(part.c_str());
        fail();
    }
}

}  // namespace sspql::viewer
