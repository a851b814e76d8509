// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <istream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <sspql/core/assert.hpp>
#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/line_reader.hpp>
#include <sspql/spaces/state_policy.hpp>

namespace sspql {

/// What stands on a cell of a grid map, and the character that says so.
enum class GridCell : std::uint8_t { free = '.', wall = '#', goal = 'G', start = 'S', hazard = 'H' };

/// A map of cells, row by row from the top. A cell's state is row * columns + column, walls included: a cell keeps its
/// id on all maps of the same size. Immutable. Made from text, one row a line:
///
///     `.` free   `#` wall   `G` goal   `S` start (none: any free cell)   `H` hazard
///
/// Every map has a goal and a cell to start from, and at most 2^24 cells.
class GridMap {
public:
    /// The most cells that a map has.
    static constexpr std::size_t most_cells = std::size_t{1} << 24;

    /// Reads a map to the end of the input. Empty lines at the end are ignored.
    /// \throws std::runtime_error "NAME:LINE:COLUMN: ..." for an unknown character, rows of different lengths, no rows,
    /// no goal, no free or start cell, more than most_cells cells, and what LineReader refuses.
    [[nodiscard]] static GridMap read(std::istream& in, const std::string& name) {
        GridMap map;
        LineReader lines(in, name);
        std::size_t blank = 0;  // the first empty line
        while (lines.next()) {
            if (lines.line().empty()) {
                if (blank == 0) blank = lines.number();
                continue;
            }
            if (blank != 0) throw_at(name, blank, 1, "empty line before the end of the map");
            map.append_row(lines);
        }
        if (map.rows_ == 0) throw_at(name, 1, 1, "map is empty");
        if (map.goals_.empty()) throw_at(name, 1, 1, "map has no goal 'G'");
        if (map.starts_.empty()) map.starts_ = map.cells_of(GridCell::free);
        if (map.starts_.empty()) throw_at(name, 1, 1, "map has no cell to start from, '.' or 'S'");
        return map;
    }

    /// The map in a text, as `read` does.
    [[nodiscard]] static GridMap parse(std::string_view text, const std::string& name = "map") {
        std::istringstream in{std::string(text)};
        return read(in, name);
    }

    /// The map in a file. \throws std::runtime_error also "PATH: cannot be opened".
    [[nodiscard]] static GridMap load(const std::string& path) {
        std::ifstream file = open_text(path);
        return read(file, path);
    }

    /// Number of rows.
    [[nodiscard]] std::size_t rows() const noexcept { return rows_; }
    /// Number of columns.
    [[nodiscard]] std::size_t columns() const noexcept { return columns_; }

    /// Number of cells, walls included: the number of states.
    [[nodiscard]] std::size_t size() const noexcept { return cells_.size(); }

    /// The state of the cell at this place. \throws std::invalid_argument for a place outside.
    [[nodiscard]] StateId state(std::size_t row, std::size_t column) const {
        if (row >= rows_) throw_invalid("row", "be below " + std::to_string(rows_), row);
        if (column >= columns_) throw_invalid("column", "be below " + std::to_string(columns_), column);
        return state_id(row * columns_ + column);
    }

    /// The row of a cell, from 0 at the top. Precondition (unchecked): s is a cell of the map.
    [[nodiscard]] std::size_t row(StateId s) const noexcept { return index(s) / columns_; }
    /// The column of a cell, from 0 at the left. Precondition (unchecked): s is a cell of the map.
    [[nodiscard]] std::size_t column(StateId s) const noexcept { return index(s) % columns_; }

    /// Precondition (asserted): s is a cell of the map.
    [[nodiscard]] GridCell cell(StateId s) const noexcept {
        SSPQL_ASSERT(index(s) < cells_.size(), "ids within range");
        return cells_[index(s)];
    }

    /// Where episodes may start: the cells `S`, or all free cells if there are none. Ascending.
    [[nodiscard]] const std::vector<StateId>& starts() const noexcept { return starts_; }

    /// The cells `G`, ascending.
    [[nodiscard]] const std::vector<StateId>& goals() const noexcept { return goals_; }

    /// "row 2, column 0 (goal)"; both count from 0.
    /// \throws std::invalid_argument for a state outside.
    [[nodiscard]] std::string describe(StateId s) const {
        detail::require_state_of(s, size());
        return "row " + std::to_string(row(s)) + ", column " + std::to_string(column(s)) + suffix(cell(s));
    }

    /// The text it was made from: parse(text()) is the same map.
    [[nodiscard]] std::string text() const {
        std::string out;
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            out += static_cast<char>(cells_[i]);
            if ((i + 1) % columns_ == 0) out += '\n';
        }
        return out;
    }

    /// The same cells.
    friend bool operator==(const GridMap& a, const GridMap& b) noexcept {
        return a.columns_ == b.columns_ && a.cells_ == b.cells_;
    }
    /// Other cells, or another size.
    friend bool operator!=(const GridMap& a, const GridMap& b) noexcept { return !(a == b); }

private:
    GridMap() = default;

    static const char* suffix(GridCell cell) noexcept {
        switch (cell) {
            case GridCell::free: return "";
            case GridCell::wall: return " (wall)";
            case GridCell::goal: return " (goal)";
            case GridCell::start: return " (start)";
            case GridCell::hazard: return " (hazard)";
        }
        return "";
    }

    void append_row(const LineReader& lines) {
        const std::string_view row = lines.line();
        for (std::size_t i = 0; i < row.size(); ++i) append_cell(row[i], i + 1, lines);
        if (rows_ == 0) columns_ = row.size();
        if (row.size() != columns_) {
            lines.fail(
                row.size() < columns_ ? row.size() + 1 : columns_ + 1,
                "row has " + std::to_string(row.size()) + " cells, the first row has " + std::to_string(columns_));
        }
        ++rows_;
    }

    void append_cell(char c, std::size_t column, const LineReader& lines) {
        if (std::string_view(".#GSH").find(c) == std::string_view::npos) {
            lines.fail(column, "unknown cell " + detail::quoted(c) + "; a map consists of . # G S H");
        }
        if (cells_.size() == most_cells) {
            lines.fail(column, "map has more than " + std::to_string(most_cells) + " cells");
        }
        const auto cell = static_cast<GridCell>(c);
        if (cell == GridCell::goal) goals_.push_back(state_id(cells_.size()));
        if (cell == GridCell::start) starts_.push_back(state_id(cells_.size()));
        cells_.push_back(cell);
    }

    [[nodiscard]] std::vector<StateId> cells_of(GridCell wanted) const {
        std::vector<StateId> states;
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            if (cells_[i] == wanted) states.push_back(state_id(i));
        }
        return states;
    }

    std::size_t rows_ = 0;
    std::size_t columns_ = 0;
    std::vector<GridCell> cells_;
    std::vector<StateId> starts_;
    std::vector<StateId> goals_;
};

}  // namespace sspql
