// SPDX-License-Identifier: MIT
#include "report/grid_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>

#include "report/numbers.hpp"

namespace sspql::report {

namespace {

constexpr double picture_width = 300.0;
constexpr double legend_width = 640.0;
constexpr double margin = 3.0;  // half the border
constexpr double largest_map = picture_width - 2.0 * margin;
constexpr double largest_cell = 44.0;
constexpr double text_size = 16.0;
constexpr double legend_text = 14.0;
constexpr double legend_row = 27.0;
constexpr double symbol_side = 20.0;

bool is_shown(const GridPictureCell& cell) {
    return cell.kind != GridCellKind::wall && cell.kind != GridCellKind::goal;
}

bool has_value(const GridPictureCell& cell) { return is_shown(cell) && cell.value && std::isfinite(*cell.value); }

/// 0.05 at the range's low end, so that the least value still differs from a blank cell, to 1.
double strength(double value, const ValueRange& range) {
    const double span = range.high - range.low;
    const double part = span > 0.0 ? std::clamp((value - range.low) / span, 0.0, 1.0) : 1.0;
    return 0.05 + 0.95 * part;
}

/// Three digits of the range's size: 0.128, 12.8, 128.
std::string value_text(double value, const ValueRange& range) {
    const double size = std::max(std::fabs(range.low), std::fabs(range.high));
    return short_text(value, size >= 100.0 ? 0 : size >= 10.0 ? 1 : size >= 0.1 ? 2 : 4);
}

const char* move_name(GridMove move) {
    constexpr std::array<const char*, 4> names{"up", "down", "left", "right"};
    return names[static_cast<std::size_t>(move)];
}

void draw_move(Svg& svg, Point centre, double side, GridMove move) {
    // Pointing to the right, as parts of the cell's side.
    constexpr std::array<Point, 7> shape{
        {{-0.28, -0.035}, {0.04, -0.035}, {0.04, -0.16}, {0.30, 0.0}, {0.04, 0.16}, {0.04, 0.035}, {-0.28, 0.035}}};
    std::vector<Point> points;
    points.reserve(shape.size());
    for (const Point& p : shape) {
        const double x = side * (move == GridMove::left || move == GridMove::up ? -p.x : p.x);
        const double y = side * p.y;
        const bool lies = move == GridMove::left || move == GridMove::right;
        points.push_back(lies ? Point{centre.x + x, centre.y + y} : Point{centre.x + y, centre.y + x});
    }
    svg.polygon(points, {Ink::text});
}

/// The floor, or what else stands on the cell, filling the square.
void draw_ground(Svg& svg, Point corner, double side, GridCellKind kind) {
    const Point centre{corner.x + 0.5 * side, corner.y + 0.5 * side};
    switch (kind) {
        case GridCellKind::free:
        case GridCellKind::start: return;
        case GridCellKind::wall: svg.rect(corner, side, side, {Ink::wall}); return;
        case GridCellKind::goal:
            svg.rect(corner, side, side, {Ink::goal});
            svg.text({centre.x, centre.y + 0.2 * side}, "G", {Ink::text, 0.56 * side, Anchor::middle, true});
            return;
        case GridCellKind::hazard: {
            svg.rect(corner, side, side, {Ink::series0, Ink::none, 1.0, 0.25});
            const double reach = 0.22 * side;
            const Style cross{Ink::none, Ink::series0, 0.09 * side};
            svg.line({centre.x - reach, centre.y - reach}, {centre.x + reach, centre.y + reach}, cross);
            svg.line({centre.x - reach, centre.y + reach}, {centre.x + reach, centre.y - reach}, cross);
            return;
        }
    }
}

void draw_start(Svg& svg, Point corner, double side) {
    svg.circle({corner.x + 0.5 * side, corner.y + 0.5 * side}, 0.41 * side, {Ink::none, Ink::series0, 0.07 * side});
}

/// The colour scale and the symbols that occur, in rows of a given width.
class Legend {
public:
    Legend(const std::vector<const GridPicture*>& pictures, const ValueRange& range, double width)
        : range_(range), width_(width) {
        for (const GridPicture* picture : pictures) {
            for (const GridPictureCell& cell : picture->cells) note(cell, picture->value_name);
        }
        place();
    }

    [[nodiscard]] double height() const { return height_; }

    void draw(Svg& svg, double top) const {
        for (const Item& item : items_) item.draw(svg, {item.x, top + item.y});
    }

private:
    struct Item {
        double width;
        std::function<void(Svg&, Point)> draw;  ///< from this point, half a row above the middle of which it stands
        double x = 0.0;
        double y = 0.0;
    };

    void note(const GridPictureCell& cell, const std::string& value_name) {
        occurs_[static_cast<std::size_t>(cell.kind)] = true;
        if (has_value(cell)) value_name_ = value_name;
        values_ = values_ || has_value(cell);
        actions_ = actions_ || (is_shown(cell) && cell.action);
    }

    void add_symbol(const std::string& text, std::function<void(Svg&, Point)> symbol) {
        const double width = symbol_side + 7.0 + text_width(text, legend_text);
        items_.push_back(
            {width, [text, symbol = std::move(symbol)](Svg& svg, Point p) {
                 symbol(svg, {p.x, p.y - 0.5 * symbol_side});
                 svg.text({p.x + symbol_side + 7.0, p.y + 0.35 * legend_text}, text, {Ink::text, legend_text});
             }});
    }

    void add_kind(GridCellKind kind, const std::string& text) {
        if (!occurs_[static_cast<std::size_t>(kind)]) return;
        add_symbol(text, [kind](Svg& svg, Point corner) {
            draw_ground(svg, corner, symbol_side, kind);
            if (kind == GridCellKind::start) draw_start(svg, corner, symbol_side);
        });
    }

    void add_scale() {
        const std::string low = value_text(range_.low, range_);
        const std::string high = value_text(range_.high, range_);
        const double before = text_width(value_name_ + "  " + low, legend_text) + 6.0;
        constexpr double bar = 100.0;
        const double width = before + bar + 6.0 + text_width(high, legend_text);
        items_.push_back({width, [=, name = value_name_](Svg& svg, Point p) {
                              constexpr int steps = 20;
                              const double baseline = p.y + 0.35 * legend_text;
                              svg.text({p.x, baseline}, name, {Ink::text, legend_text});
                              svg.text({p.x + before - 6.0, baseline}, low, {Ink::faint, legend_text, Anchor::end});
                              const Point corner{p.x + before, p.y - 7.0};
                              svg.rect(corner, bar, 14.0, {Ink::floor});
                              for (int i = 0; i < steps; ++i) {
                                  const double part = static_cast<double>(i) / (steps - 1.0);
                                  svg.rect({corner.x + bar * i / steps, corner.y}, bar / steps, 14.0,
                                           {Ink::value, Ink::none, 1.0, strength(part, {0.0, 1.0})});
                              }
                              svg.rect(corner, bar, 14.0, {Ink::none, Ink::axis, 0.8});
                              svg.text({p.x + before + bar + 6.0, baseline}, high, {Ink::faint, legend_text});
                          }});
    }

    void place() {
        if (values_) add_scale();
        if (actions_) {
            add_symbol("learnt action", [](Svg& svg, Point corner) {
                draw_move(svg, {corner.x + 0.5 * symbol_side, corner.y + 0.5 * symbol_side}, 1.25 * symbol_side,
                          GridMove::right);
            });
        }
        add_kind(GridCellKind::start, "start");
        add_kind(GridCellKind::goal, "goal");
        add_kind(GridCellKind::hazard, "hazard");
        add_kind(GridCellKind::wall, "wall");
        double x = 0.0;
        for (Item& item : items_) {
            if (x > 0.0 && x + item.width > width_) {
                x = 0.0;
                height_ += legend_row;
            }
            item.x = x + margin;
            item.y = height_ + 0.5 * legend_row;
            x += item.width + 16.0;
        }
        if (!items_.empty()) height_ += legend_row;
    }

    ValueRange range_;
    double width_;
    std::array<bool, 5> occurs_{};
    std::string value_name_;
    bool values_ = false;
    bool actions_ = false;
    std::vector<Item> items_;
    double height_ = 0.0;
};

void check(const GridPicture& picture) {
    const std::size_t cells = picture.cells.size();
    // Divided, not multiplied: a product could wrap around.
    const bool fits = picture.columns > 0 && cells % picture.columns == 0 && cells / picture.columns == picture.rows;
    if (!fits || cells == 0) {
        throw std::invalid_argument("grid_picture: " + std::to_string(picture.rows) + " rows of " +
                                    std::to_string(picture.columns) + " columns are not " + std::to_string(cells) +
                                    " cells");
    }
    if (cells > most_picture_cells) {
        throw std::invalid_argument("grid_picture: at most " + std::to_string(most_picture_cells) + " cells, got " +
                                    std::to_string(cells));
    }
}

/// Draws one map.
class GridPainter {
public:
    explicit GridPainter(const GridPicture& picture)
        : picture_(picture),
          range_(picture.range ? *picture.range : value_range({picture})),
          side_(std::min({largest_cell, largest_map / static_cast<double>(picture.columns),
                          largest_map / static_cast<double>(picture.rows)})),
          top_(margin + (picture.title.empty() ? 0.0 : 1.6 * text_size)),
          legend_({&picture}, range_, picture_width - 2.0 * margin),
          svg_(picture_width, bottom() + margin + (picture.legend ? 6.0 + legend_.height() : 0.0), label_of(picture)) {}

    Svg paint() {
        if (!picture_.title.empty()) {
            const double wide = text_width(picture_.title, text_size);
            const double size = std::min(text_size, text_size * largest_map / wide);
            svg_.text({margin, text_size}, picture_.title, {Ink::text, size, Anchor::start, true});
        }
        const double width = side_ * static_cast<double>(picture_.columns);
        const double height = bottom() - top_;
        svg_.rect({margin, top_}, width, height, {Ink::floor});
        for (std::size_t i = 0; i < picture_.cells.size(); ++i) paint_cell(i);
        paint_lines(width, height);
        svg_.rect({margin, top_}, width, height, {Ink::none, Ink::wall, 3.0}, 1.5);
        if (picture_.legend) legend_.draw(svg_, bottom() + margin + 6.0);
        return std::move(svg_);
    }

private:
    static std::string label_of(const GridPicture& picture) {
        std::string label = picture.title.empty() ? "Grid map" : "Grid map, " + picture.title;
        label += ": " + std::to_string(picture.rows) + " rows, " + std::to_string(picture.columns) + " columns";
        bool values = false;
        bool actions = false;
        for (const GridPictureCell& cell : picture.cells) {
            values = values || has_value(cell);
            actions = actions || (is_shown(cell) && cell.action);
        }
        if (values) label += "; colours: " + picture.value_name;
        if (actions) label += "; arrows: the learnt actions";
        return label;
    }

    [[nodiscard]] double bottom() const { return top_ + side_ * static_cast<double>(picture_.rows); }

    void paint_cell(std::size_t i) {
        const GridPictureCell& cell = picture_.cells[i];
        const std::size_t row = i / picture_.columns;
        const std::size_t column = i % picture_.columns;
        const Point corner{margin + side_ * static_cast<double>(column), top_ + side_ * static_cast<double>(row)};
        const bool tells = has_value(cell) || (is_shown(cell) && cell.action);
        if (tells) svg_.begin_group("", tooltip(cell, row, column));
        draw_ground(svg_, corner, side_, cell.kind);
        if (has_value(cell)) {
            svg_.rect(corner, side_, side_, {Ink::value, Ink::none, 1.0, strength(*cell.value, range_)});
        }
        if (cell.kind == GridCellKind::start) draw_start(svg_, corner, side_);
        if (is_shown(cell) && cell.action) {
            draw_move(svg_, {corner.x + 0.5 * side_, corner.y + 0.5 * side_}, side_, *cell.action);
        }
        if (tells) svg_.end_group();
    }

    [[nodiscard]] std::string tooltip(const GridPictureCell& cell, std::size_t row, std::size_t column) const {
        std::string text = "row " + std::to_string(row) + ", column " + std::to_string(column);
        if (has_value(cell)) text += ": " + picture_.value_name + " " + short_text(*cell.value, 4);
        if (cell.action) text += std::string(has_value(cell) ? ", " : ": ") + move_name(*cell.action);
        if (!cell.why.empty()) text += "\n" + cell.why;
        return text;
    }

    void paint_lines(double width, double height) {
        const Style style{Ink::none, Ink::axis, 0.8, 0.45};
        for (std::size_t column = 1; column < picture_.columns; ++column) {
            const double x = margin + side_ * static_cast<double>(column);
            svg_.line({x, top_}, {x, top_ + height}, style);
        }
        for (std::size_t row = 1; row < picture_.rows; ++row) {
            const double y = top_ + side_ * static_cast<double>(row);
            svg_.line({margin, y}, {margin + width, y}, style);
        }
    }

    const GridPicture& picture_;
    ValueRange range_;
    double side_;
    double top_;
    Legend legend_;
    Svg svg_;
};

}  // namespace

Svg grid_picture(const GridPicture& picture) {
    check(picture);
    return GridPainter(picture).paint();
}

ValueRange value_range(const std::vector<GridPicture>& pictures) {
    ValueRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const GridPicture& picture : pictures) {
        for (const GridPictureCell& cell : picture.cells) {
            if (!has_value(cell)) continue;
            range.low = std::min(range.low, *cell.value);
            range.high = std::max(range.high, *cell.value);
        }
    }
    return range.low <= range.high ? range : ValueRange{};
}

Svg grid_legend(const std::vector<GridPicture>& pictures) {
    std::vector<const GridPicture*> all;
    all.reserve(pictures.size());
    for (const GridPicture& picture : pictures) all.push_back(&picture);
    const bool given = !pictures.empty() && pictures.front().range.has_value();
    const Legend legend(all, given ? *pictures.front().range : value_range(pictures), legend_width);
    Svg svg(legend_width, std::max(legend.height(), 1.0), "Legend of the maps");
    legend.draw(svg, 0.0);
    return svg;
}

}  // namespace sspql::report
