// SPDX-License-Identifier: MIT
#include "report/svg.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "report/escape.hpp"
#include "report/numbers.hpp"

namespace sspql::report {

namespace {

constexpr double pi = 3.14159265358979323846;

std::string coordinate(double value) { return std::isfinite(value) ? short_text(value, 2) : "0"; }

std::string attribute(std::string_view name, std::string_view value) {
    std::string out = " ";
    out.append(name).append("=\"").append(escaped(value)).append("\"");
    return out;
}

std::string attribute(std::string_view name, double value) { return attribute(name, coordinate(value)); }

/// x="1" y="2" under the given names.
std::string place_attributes(std::string_view x, std::string_view y, Point place) {
    return attribute(x, place.x) + attribute(y, place.y);
}

std::string points_attribute(const std::vector<Point>& points) {
    std::string list;
    for (const Point& point : points) {
        if (!list.empty()) list += ' ';
        list += coordinate(point.x) + ',' + coordinate(point.y);
    }
    return attribute("points", list);
}

/// The class by which the dark style sheet finds it, and the light colour for everybody else.
std::string paint_attributes(Ink fill, Ink stroke) {
    std::string classes;
    if (fill != Ink::none) classes += "f-" + std::string(ink_name(fill));
    if (stroke != Ink::none) classes += (classes.empty() ? "s-" : " s-") + std::string(ink_name(stroke));
    std::string out = classes.empty() ? "" : attribute("class", classes);
    out += attribute("fill", light_colour(fill));
    if (stroke != Ink::none) out += attribute("stroke", light_colour(stroke));
    return out;
}

Point on_circle(Point centre, double radius, double angle_rad) {
    return {centre.x + radius * std::cos(angle_rad), centre.y - radius * std::sin(angle_rad)};
}

std::string pair(Point point) { return coordinate(point.x) + " " + coordinate(point.y); }

std::string arc_command(Point centre, double radius, double from_rad, double to_rad) {
    const std::string large = std::fabs(to_rad - from_rad) > pi ? "1" : "0";
    const std::string r = coordinate(radius);
    return "A" + r + " " + r + " 0 " + large + " 0 " + pair(on_circle(centre, radius, to_rad));
}

}  // namespace

double text_width(std::string_view text, double size) {
    double width = 0.0;
    for (const char c : text) {
        if ((static_cast<unsigned char>(c) & 0xC0u) == 0x80u) continue;  // a code point counts once, in UTF-8
        const bool narrow = std::string_view("iljtfr.,:;'|!()[] -").find(c) != std::string_view::npos;
        const bool wide = (c >= 'A' && c <= 'Z') || c == 'm' || c == 'w' || c == '%';
        width += narrow ? 0.36 : wide ? 0.75 : 0.58;
    }
    return width * size;
}

Svg::Svg(double width, double height, std::string label) : width_(width), height_(height), label_(std::move(label)) {}

void Svg::shape(std::string_view name, const std::string& geometry, const Style& style, std::string_view tooltip) {
    body_.append("<").append(name).append(geometry).append(paint_attributes(style.fill, style.stroke));
    if (style.stroke != Ink::none && style.width != 1.0) body_ += attribute("stroke-width", style.width);
    if (style.opacity != 1.0) body_ += attribute("opacity", style.opacity);
    if (!style.dash.empty()) body_ += attribute("stroke-dasharray", style.dash);
    if (tooltip.empty()) {
        body_ += "/>\n";
    } else {
        body_.append("><title>").append(escaped(tooltip)).append("</title></").append(name).append(">\n");
    }
}

void Svg::line(Point from, Point to, const Style& style) {
    shape("line", place_attributes("x1", "y1", from) + place_attributes("x2", "y2", to), style);
}

void Svg::polyline(const std::vector<Point>& points, const Style& style) {
    shape("polyline",
          points_attribute(points) + attribute("stroke-linejoin", "round") +
              attribute("stroke-linecap", style.dash.empty() ? "round" : "butt"),
          style);
}

void Svg::polygon(const std::vector<Point>& points, const Style& style) {
    shape("polygon", points_attribute(points), style);
}

void Svg::circle(Point centre, double radius, const Style& style, std::string_view tooltip) {
    shape("circle", place_attributes("cx", "cy", centre) + attribute("r", radius), style, tooltip);
}

void Svg::rect(Point corner, double width, double height, const Style& style, double corner_radius) {
    std::string geometry = place_attributes("x", "y", corner) + attribute("width", width) + attribute("height", height);
    if (corner_radius > 0.0) geometry += attribute("rx", corner_radius);
    shape("rect", geometry, style);
}

void Svg::sector(Point centre, double radius, double from_rad, double to_rad, const Style& style) {
    shape("path",
          attribute("d", "M" + pair(centre) + "L" + pair(on_circle(centre, radius, from_rad)) +
                             arc_command(centre, radius, from_rad, to_rad) + "Z"),
          style);
}

void Svg::arc(Point centre, double radius, double from_rad, double to_rad, const Style& style) {
    shape(
        "path",
        attribute("d", "M" + pair(on_circle(centre, radius, from_rad)) + arc_command(centre, radius, from_rad, to_rad)),
        style);
}

void Svg::text(Point place, std::string_view content, const TextStyle& style) {
    body_ += "<text" + place_attributes("x", "y", place) + paint_attributes(style.ink, style.halo);
    body_ += attribute("font-size", style.size);
    if (style.anchor == Anchor::middle) body_ += attribute("text-anchor", "middle");
    if (style.anchor == Anchor::end) body_ += attribute("text-anchor", "end");
    if (style.bold) body_ += attribute("font-weight", "600");
    if (style.halo != Ink::none) {
        body_ +=
            attribute("stroke-width", 5.0) + attribute("stroke-linejoin", "round") + attribute("paint-order", "stroke");
    }
    if (style.turn_deg != 0.0) {
        body_ += attribute("transform", "rotate(" + coordinate(style.turn_deg) + " " + pair(place) + ")");
    }
    body_ += ">" + escaped(content) + "</text>\n";
}

void Svg::begin_group(std::string_view class_name, std::string_view tooltip) {
    body_ += "<g" + (class_name.empty() ? std::string() : attribute("class", class_name)) + ">\n";
    if (!tooltip.empty()) body_ += "<title>" + escaped(tooltip) + "</title>\n";
    ++open_groups_;
}

void Svg::end_group() {
    if (open_groups_ == 0) throw std::logic_error("Svg::end_group without begin_group");
    --open_groups_;
    body_ += "</g>\n";
}

std::string Svg::root(std::string_view inside) const {
    if (open_groups_ != 0) throw std::logic_error("Svg: a group is still open");
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\"";
    out += attribute("viewBox", "0 0 " + coordinate(width_) + " " + coordinate(height_));
    out += attribute("width", width_) + attribute("height", height_) + attribute("role", "img");
    out += attribute("aria-label", label_);
    out += attribute("font-family", "system-ui,-apple-system,'Segoe UI',Roboto,'Helvetica Neue',Arial,sans-serif");
    return out.append(">\n").append(inside).append(body_).append("</svg>\n");
}

std::string Svg::element() const { return root({}); }

std::string Svg::document() const {
    const std::string paper = "<rect width=\"100%\" height=\"100%\"" + paint_attributes(Ink::paper, Ink::none) + "/>\n";
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" +
           root("<style>\n" + dark_picture_css() + "</style>\n" + paper);
}

}  // namespace sspql::report
