// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "report/palette.hpp"

namespace sspql::report {

/// A place in a picture, in its units: x to the right, y down.
struct Point {
    double x = 0.0;
    double y = 0.0;
};

/// How a shape is painted.
struct Style {
    Ink fill = Ink::none;
    Ink stroke = Ink::none;
    double width = 1.0;     ///< of the stroke
    double opacity = 1.0;   ///< of fill and stroke
    std::string dash = {};  ///< "4 3": lengths of strokes and gaps
};

enum class Anchor { start, middle, end };

struct TextStyle {
    Ink ink = Ink::text;
    double size = 13.0;
    Anchor anchor = Anchor::start;
    bool bold = false;
    double turn_deg = 0.0;  ///< clockwise about the text's place
    Ink halo = Ink::none;   ///< drawn around the letters, so that they can stand on lines
};

/// How wide a text will be, about: fonts differ, so the estimate is generous. Unit: that of `size`.
[[nodiscard]] double text_width(std::string_view text, double size);

/// Builds one SVG picture from shapes, in drawing order. Numbers have at most two digits after a point, in every
/// locale; all texts are escaped; non-finite coordinates are drawn as 0. The picture scales (viewBox).
class Svg {
public:
    /// `label` says what is to be seen, to those who cannot see it.
    Svg(double width, double height, std::string label);

    void line(Point from, Point to, const Style& style);
    void polyline(const std::vector<Point>& points, const Style& style);
    void polygon(const std::vector<Point>& points, const Style& style);
    void circle(Point centre, double radius, const Style& style, std::string_view tooltip = {});
    void rect(Point corner, double width, double height, const Style& style, double corner_radius = 0.0);

    /// A pie slice, and its outer edge alone: from one angle counter-clockwise to another; angles count
    /// counter-clockwise from the right, in rad, and may differ by less than a full turn.
    void sector(Point centre, double radius, double from_rad, double to_rad, const Style& style);
    void arc(Point centre, double radius, double from_rad, double to_rad, const Style& style);

    /// `place` is on the baseline.
    void text(Point place, std::string_view content, const TextStyle& style);

    /// What follows up to `end_group` belongs together: `class_name` for style sheets, `tooltip` shown under the mouse;
    /// either may be empty. \throws std::logic_error from `end_group` without `begin_group`.
    void begin_group(std::string_view class_name, std::string_view tooltip = {});
    void end_group();

    [[nodiscard]] double width() const noexcept { return width_; }
    [[nodiscard]] double height() const noexcept { return height_; }
    [[nodiscard]] const std::string& label() const noexcept { return label_; }

    /// The picture for an HTML page that holds `dark_picture_css()`. \throws std::logic_error if a group is open.
    [[nodiscard]] std::string element() const;

    /// The picture as a file of its own: paper behind it, light or dark by itself. Throws as `element` does.
    [[nodiscard]] std::string document() const;

private:
    void shape(std::string_view name, const std::string& geometry, const Style& style, std::string_view tooltip = {});
    [[nodiscard]] std::string root(std::string_view inside) const;

    double width_;
    double height_;
    std::string label_;
    std::string body_;
    std::size_t open_groups_ = 0;
};

}  // namespace sspql::report
