// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <SFML/Graphics/Color.hpp>
#include <SFML/Graphics/Font.hpp>
#include <SFML/Graphics/RenderTarget.hpp>
#include <SFML/System/Vector2.hpp>

#include "report/palette.hpp"

/// \file
/// Drawing on a window in units that do not depend on its size: y downwards, lengths in units, the dark palette.

namespace sspql::viewer {

using Spot = sf::Vector2f;

/// The size of everything in units; a window of another shape leaves margins.
inline constexpr float canvas_width = 1200.0F;
inline constexpr float canvas_height = 800.0F;

/// The palette's dark colour with an opacity from 0 to 1. Precondition: not Ink::none.
[[nodiscard]] sf::Color colour(report::Ink ink, double opacity = 1.0);

enum class Align { left, centre, right };

struct TextStyle {
    report::Ink ink = report::Ink::text;
    float size = 15.0F;
    Align align = Align::left;
    bool bold = false;
};

/// The letters. Without a bold font the plain one is thickened.
struct Fonts {
    sf::Font plain;
    sf::Font bold;
    bool has_bold = false;
};

/// Draws on a target that outlives it, with fonts that do too.
class Canvas {
public:
    Canvas(sf::RenderTarget& target, const Fonts& fonts);

    void clear();
    void rect(Spot corner, Spot size, sf::Color fill);
    void frame(Spot corner, Spot size, sf::Color stroke, float width = 1.0F);
    void circle(Spot centre, float radius, sf::Color fill, sf::Color stroke = sf::Color::Transparent,
                float width = 0.0F);
    void line(Spot from, Spot to, sf::Color stroke, float width = 1.0F);
    void polyline(const std::vector<Spot>& points, sf::Color stroke, float width);
    void dashed(Spot from, Spot to, sf::Color stroke, float width, float dash);

    /// Filled as a fan about its first corner, which must see all others.
    void polygon(const std::vector<Spot>& corners, sf::Color fill);

    /// From the point `from` to `tip`, its head `head` units long.
    void arrow(Spot from, Spot tip, sf::Color stroke, float width, float head);

    /// An arc about `centre`, angles in radians counter-clockwise on the screen; with a head at its end if `head` > 0.
    void arc(Spot centre, float radius, double from_rad, double to_rad, sf::Color stroke, float width,
             float head = 0.0F);

    /// The part of a ring between two radii and two angles (inner 0: a slice).
    void ring_sector(Spot centre, float inner, float outer, double from_rad, double to_rad, sf::Color fill);

    /// The spot is the text's anchor on its baseline.
    void text(Spot baseline, const std::string& utf8, const TextStyle& style = {});
    [[nodiscard]] float text_width(const std::string& utf8, const TextStyle& style) const;

    /// The text, shortened with an ellipsis to this width.
    [[nodiscard]] std::string fitted(const std::string& utf8, float width, const TextStyle& style) const;

private:
    sf::RenderTarget& target_;
    const Fonts& fonts_;
    float pixels_per_unit_;
};

/// A spot at a distance and an angle (radians, counter-clockwise on the screen) from another one.
[[nodiscard]] Spot polar(Spot centre, double radius, double angle_rad);

/// The part of a window of this size in pixels that shows the canvas undistorted: left, top, width, height, each as a
/// share of the window.
[[nodiscard]] sf::FloatRect viewport_for(sf::Vector2u window);

}  // namespace sspql::viewer
