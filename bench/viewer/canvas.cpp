// SPDX-License-Identifier: MIT
#include "viewer/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <SFML/Graphics/CircleShape.hpp>
#include <SFML/Graphics/RectangleShape.hpp>
#include <SFML/Graphics/Text.hpp>
#include <SFML/Graphics/VertexArray.hpp>

namespace sspql::viewer {

namespace {

sf::Text made(const Fonts& fonts, const std::string& utf8, const TextStyle& style, float pixels_per_unit) {
    // Letters are rasterized at the size they have on the screen, then scaled back to units: sharp in any window.
    const float pixels = std::max(1.0F, std::round(style.size * pixels_per_unit));
    const sf::Font& font = style.bold && fonts.has_bold ? fonts.bold : fonts.plain;
    sf::Text text(sf::String::fromUtf8(utf8.begin(), utf8.end()), font, static_cast<unsigned>(pixels));
    text.setScale(style.size / pixels, style.size / pixels);
    text.setFillColor(colour(style.ink));
    if (style.bold && !fonts.has_bold) text.setStyle(sf::Text::Bold);
    return text;
}

/// Two triangles for a stretch of line.
void append_quad(sf::VertexArray& triangles, Spot a, Spot b, Spot c, Spot d, sf::Color fill) {
    for (const Spot& spot : {a, b, c, a, c, d}) triangles.append(sf::Vertex(spot, fill));
}

void append_line(sf::VertexArray& triangles, Spot from, Spot to, sf::Color stroke, float width) {
    const Spot along = to - from;
    const float length = std::sqrt(along.x * along.x + along.y * along.y);
    if (length <= 0.0F) return;
    const Spot side(-along.y / length * 0.5F * width, along.x / length * 0.5F * width);
    append_quad(triangles, from + side, to + side, to - side, from - side, stroke);
}

int arc_pieces(double from_rad, double to_rad) {
    return std::max(2, static_cast<int>(std::ceil(std::fabs(to_rad - from_rad) / 0.08)));
}

}  // namespace

sf::Color colour(report::Ink ink, double opacity) {
    const std::string hex(report::dark_colour(ink).substr(1));
    const auto rgb = static_cast<unsigned>(std::strtoul(hex.c_str(), nullptr, 16));
    const auto byte = [rgb](unsigned shift) { return static_cast<sf::Uint8>(rgb >> shift & 0xFFU); };
    return {byte(16), byte(8), byte(0), static_cast<sf::Uint8>(std::lround(255.0 * std::clamp(opacity, 0.0, 1.0)))};
}

Spot polar(Spot centre, double radius, double angle_rad) {
    return {centre.x + static_cast<float>(radius * std::cos(angle_rad)),
            centre.y - static_cast<float>(radius * std::sin(angle_rad))};
}

sf::FloatRect viewport_for(sf::Vector2u window) {
    const float wide = static_cast<float>(window.x) / canvas_width;
    const float high = static_cast<float>(window.y) / canvas_height;
    const float scale = std::min(wide, high);
    const float width = scale / wide;
    const float height = scale / high;
    return {0.5F * (1.0F - width), 0.5F * (1.0F - height), width, height};
}

Canvas::Canvas(sf::RenderTarget& target, const Fonts& fonts) : target_(target), fonts_(fonts) {
    const sf::Vector2u size = target.getSize();
    const sf::Vector2u some(std::max(size.x, 1U), std::max(size.y, 1U));
    sf::View view(sf::FloatRect(0.0F, 0.0F, canvas_width, canvas_height));
    view.setViewport(viewport_for(some));
    target.setView(view);
    pixels_per_unit_ = view.getViewport().width * static_cast<float>(some.x) / canvas_width;
}

void Canvas::clear() { target_.clear(colour(report::Ink::paper)); }

void Canvas::rect(Spot corner, Spot size, sf::Color fill) {
    sf::RectangleShape shape(size);
    shape.setPosition(corner);
    shape.setFillColor(fill);
    target_.draw(shape);
}

void Canvas::frame(Spot corner, Spot size, sf::Color stroke, float width) {
    sf::RectangleShape shape(size);
    shape.setPosition(corner);
    shape.setFillColor(sf::Color::Transparent);
    shape.setOutlineColor(stroke);
    shape.setOutlineThickness(-width);
    target_.draw(shape);
}

void Canvas::circle(Spot centre, float radius, sf::Color fill, sf::Color stroke, float width) {
    sf::CircleShape shape(radius, static_cast<std::size_t>(std::clamp(radius, 12.0F, 90.0F)));
    shape.setOrigin(radius, radius);
    shape.setPosition(centre);
    shape.setFillColor(fill);
    shape.setOutlineColor(stroke);
    shape.setOutlineThickness(width);
    target_.draw(shape);
}

void Canvas::line(Spot from, Spot to, sf::Color stroke, float width) {
    sf::VertexArray triangles(sf::Triangles);
    append_line(triangles, from, to, stroke, width);
    target_.draw(triangles);
}

void Canvas::polyline(const std::vector<Spot>& points, sf::Color stroke, float width) {
    sf::VertexArray triangles(sf::Triangles);
    for (std::size_t i = 1; i < points.size(); ++i) append_line(triangles, points[i - 1], points[i], stroke, width);
    target_.draw(triangles);
}

void Canvas::dashed(Spot from, Spot to, sf::Color stroke, float width, float dash) {
    const Spot along = to - from;
    const float length = std::sqrt(along.x * along.x + along.y * along.y);
    sf::VertexArray triangles(sf::Triangles);
    for (float begin = 0.0F; begin < length; begin += 2.0F * dash) {
        const float end = std::min(begin + dash, length);
        append_line(triangles, from + along * (begin / length), from + along * (end / length), stroke, width);
    }
    target_.draw(triangles);
}

void Canvas::polygon(const std::vector<Spot>& corners, sf::Color fill) {
    sf::VertexArray fan(sf::TriangleFan);
    for (const Spot& spot : corners) fan.append(sf::Vertex(spot, fill));
    target_.draw(fan);
}

void Canvas::arrow(Spot from, Spot tip, sf::Color stroke, float width, float head) {
    const Spot along = tip - from;
    const float length = std::sqrt(along.x * along.x + along.y * along.y);
    if (length <= 0.0F) return;
    const Spot unit = along / length;
    const Spot side(-unit.y, unit.x);
    const Spot neck = tip - unit * head;
    line(from, neck, stroke, width);
    polygon({tip, neck + side * (0.55F * head), neck - side * (0.55F * head)}, stroke);
}

void Canvas::arc(Spot centre, float radius, double from_rad, double to_rad, sf::Color stroke, float width, float head) {
    const int pieces = arc_pieces(from_rad, to_rad);
    sf::VertexArray triangles(sf::Triangles);
    for (int i = 0; i < pieces; ++i) {
        const double a = from_rad + (to_rad - from_rad) * i / pieces;
        const double b = from_rad + (to_rad - from_rad) * (i + 1) / pieces;
        const double half = 0.5 * static_cast<double>(width);
        append_quad(triangles, polar(centre, radius + half, a), polar(centre, radius + half, b),
                    polar(centre, radius - half, b), polar(centre, radius - half, a), stroke);
    }
    target_.draw(triangles);
    if (head > 0.0F) {
        const double forth = (to_rad < from_rad ? -1.0 : 1.0) * static_cast<double>(head / radius);
        const double wing = 0.6 * static_cast<double>(head);
        polygon({polar(centre, radius, to_rad + forth), polar(centre, radius + wing, to_rad),
                 polar(centre, radius - wing, to_rad)},
                stroke);
    }
}

void Canvas::ring_sector(Spot centre, float inner, float outer, double from_rad, double to_rad, sf::Color fill) {
    const int pieces = arc_pieces(from_rad, to_rad);
    sf::VertexArray strip(sf::TriangleStrip);
    for (int i = 0; i <= pieces; ++i) {
        const double angle = from_rad + (to_rad - from_rad) * i / pieces;
        strip.append(sf::Vertex(polar(centre, outer, angle), fill));
        strip.append(sf::Vertex(polar(centre, inner, angle), fill));
    }
    target_.draw(strip);
}

void Canvas::text(Spot baseline, const std::string& utf8, const TextStyle& style) {
    sf::Text text = made(fonts_, utf8, style, pixels_per_unit_);
    const float width = style.align == Align::left ? 0.0F : text_width(utf8, style);
    const float left = baseline.x - (style.align == Align::centre ? 0.5F * width : width);
    // SFML puts the line's top at the position, and its baseline one character size below.
    text.setPosition(left, baseline.y - style.size);
    target_.draw(text);
}

float Canvas::text_width(const std::string& utf8, const TextStyle& style) const {
    const sf::Text text = made(fonts_, utf8, style, pixels_per_unit_);
    return text.findCharacterPos(text.getString().getSize()).x - text.findCharacterPos(0).x;
}

std::string Canvas::fitted(const std::string& utf8, float width, const TextStyle& style) const {
    if (text_width(utf8, style) <= width) return utf8;
    std::string shorter = utf8;
    while (!shorter.empty()) {
        // A whole character of UTF-8 goes: what continues one has the bits 10 in front.
        while (shorter.size() > 1 && (static_cast<unsigned char>(shorter.back()) & 0xC0U) == 0x80U) shorter.pop_back();
        shorter.pop_back();
        if (text_width(shorter + "…", style) <= width) break;
    }
    return shorter + "…";
}

}  // namespace sspql::viewer
