// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <istream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/core/line_reader.hpp>
#include <sspql/model/transition_table.hpp>
#include <sspql/model/transition_table_builder.hpp>

namespace sspql {

namespace detail {

/// Reads the CSV of a TransitionTable; see read_table_csv.
class TableCsvReader {
public:
    TableCsvReader(std::istream& in, const std::string& name) : lines_(in, name) {}

    TransitionTable read() {
        while (lines_.next()) {
            const std::string_view line = lines_.line();
            if (trimmed({line, 1}).text.empty()) continue;
            if (line.front() == '#') {
                read_comment(line);
            } else if (!header_read_) {
                read_header(line);
            } else {
                read_row(line);
            }
        }
        if (!header_read_) throw_at(lines_.name(), 1, 1, "table is empty; it must begin with " + std::string(header));
        if (rows_.empty()) lines_.fail(1, "table has no rows after its header");
        return table();
    }

private:
    static constexpr std::string_view header = "s,a,next,p,reward,terminal";
    static constexpr std::array<const char*, 6> names{"s", "a", "next", "p", "reward", "terminal"};
    static constexpr std::size_t most_states = 10'000'000;
    static constexpr std::size_t most_actions = 256;
    static constexpr std::size_t most_pairs = 50'000'000;

    /// A piece of the current line and the column where it begins.
    struct Field {
        std::string_view text;
        std::size_t column;
    };

    struct Row {
        std::size_t s, a, next;
        double probability, reward;
        bool terminal;
        std::size_t line, next_column, probability_column;
    };

    struct Start {
        std::size_t s, line, column;
    };

    static Field trimmed(Field field) {
        const std::size_t begin = std::min(field.text.find_first_not_of(" \t"), field.text.size());
        field.text.remove_prefix(begin);
        field.text = field.text.substr(0, field.text.find_last_not_of(" \t") + 1);
        return {field.text, field.column + begin};
    }

    static std::vector<Field> split(Field line) {
        std::vector<Field> fields;
        for (std::size_t begin = 0;;) {
            const std::size_t comma = line.text.find(',', begin);
            fields.push_back(trimmed({line.text.substr(begin, comma - begin), line.column + begin}));
            if (comma == std::string_view::npos) return fields;
            begin = comma + 1;
        }
    }

    void read_comment(std::string_view line) {
        constexpr std::string_view key = "start:";
        const Field rest = trimmed({line.substr(1), 2});
        if (rest.text.substr(0, key.size()) != key) return;
        if (header_read_) lines_.fail(1, "start states must be given before the header");
        if (!starts_.empty()) lines_.fail(1, "start states are given twice");
        for (const Field& field : split({rest.text.substr(key.size()), rest.column + key.size()})) {
            starts_.push_back({id(field, "start state", most_states), lines_.number(), field.column});
        }
        std::vector<Start> sorted = starts_;
        std::stable_sort(sorted.begin(), sorted.end(), [](const Start& x, const Start& y) { return x.s < y.s; });
        const auto twice = std::adjacent_find(sorted.begin(), sorted.end(),
                                              [](const Start& x, const Start& y) { return x.s == y.s; });
        if (twice == sorted.end()) return;
        lines_.fail(std::next(twice)->column, "start state " + std::to_string(twice->s) + " is given twice");
    }

    void read_header(std::string_view line) {
        const std::vector<Field> fields = split({line, 1});
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (i < fields.size() && fields[i].text == names[i]) continue;
            lines_.fail(i < fields.size() ? fields[i].column : line.size() + 1,
                        "header must be " + std::string(header));
        }
        if (fields.size() > names.size()) {
            lines_.fail(fields[names.size()].column, "header must be " + std::string(header));
        }
        header_read_ = true;
    }

    void read_row(std::string_view line) {
        const std::vector<Field> fields = split({line, 1});
        if (fields.size() != names.size()) {
            lines_.fail(fields.size() < names.size() ? line.size() + 1 : fields[names.size()].column,
                        "row has " + std::to_string(fields.size()) + " fields, not 6: " + std::string(header));
        }
        Row row{};
        row.s = id(fields[0], "s", most_states);
        row.a = id(fields[1], "a", most_actions);
        row.next = id(fields[2], "next", most_states);
        row.probability = number(fields[3], "p");
        if (!(row.probability > 0.0 && row.probability <= 1.0)) {
            lines_.fail(fields[3].column, "p must lie in (0, 1], got " + std::string(fields[3].text));
        }
        row.reward = number(fields[4], "reward");
        row.terminal = flag(fields[5]);
        row.line = lines_.number();
        row.next_column = fields[2].column;
        row.probability_column = fields[3].column;
        states_ = std::max({states_, row.s + 1, row.next + 1});
        actions_ = std::max(actions_, row.a + 1);
        if (states_ * actions_ > most_pairs) {
            lines_.fail(1, "table would have " + std::to_string(states_) + " x " + std::to_string(actions_) +
                               " states and actions, more than " + std::to_string(most_pairs));
        }
        rows_.push_back(row);
    }

    std::size_t id(const Field& field, const char* name, std::size_t most) const {
        std::uint64_t value = 0;
        const char* end = field.text.data() + field.text.size();
        const auto [stop, error] = std::from_chars(field.text.data(), end, value);
        if (error == std::errc::invalid_argument || stop != end) {
            lines_.fail(field.column,
                        std::string(name) + " must be a whole number from 0 on, got " + quoted(field.text));
        }
        if (error != std::errc{} || value >= most) {
            lines_.fail(field.column,
                        std::string(name) + " must be below " + std::to_string(most) + ", got " + quoted(field.text));
        }
        return static_cast<std::size_t>(value);
    }

    double number(const Field& field, const char* name) const {
        double value = 0.0;
        const char* end = field.text.data() + field.text.size();
        const auto [stop, error] = std::from_chars(field.text.data(), end, value);
        if (error != std::errc{} || stop != end || !std::isfinite(value)) {
            lines_.fail(field.column, std::string(name) + " must be a finite number, got " + quoted(field.text));
        }
        return value;
    }

    bool flag(const Field& field) const {
        if (field.text == "1" || field.text == "true" || field.text == "True") return true;
        if (field.text == "0" || field.text == "false" || field.text == "False") return false;
        lines_.fail(field.column, "terminal must be 0 or 1, got " + quoted(field.text));
    }

    TransitionTable table() const {
        TransitionTableBuilder builder(states_, actions_);
        std::vector<char> has_actions(states_, 0);
        for (const Row& row : rows_) {
            has_actions[row.s] = 1;
            builder.add(state_id(row.s), action_id(row.a), state_id(row.next), row.probability, row.reward,
                        row.terminal);
        }
        std::vector<StateId> starts;
        for (const Start& start : starts_) {
            if (start.s >= states_ || has_actions[start.s] == 0) {
                throw_at(lines_.name(), start.line, start.column,
                         "start state " + std::to_string(start.s) + " has no actions");
            }
            starts.push_back(state_id(start.s));
        }
        builder.start_in(starts);
        try {
            return builder.build();
        } catch (const TransitionTableError& error) {
            const Row& row = rows_[error.row()];
            const bool at_next = error.field() == TransitionTableError::Field::next;
            throw_at(lines_.name(), row.line, at_next ? row.next_column : row.probability_column, error.what());
        }
    }

    LineReader lines_;
    bool header_read_ = false;
    std::size_t states_ = 0;
    std::size_t actions_ = 0;
    std::vector<Row> rows_;
    std::vector<Start> starts_;
};

}  // namespace detail

/// Reads a TransitionTable from CSV, whatever the locale:
///
///     # start: 0,3,7                  optional: where episodes start; all states that have actions otherwise
///     s,a,next,p,reward,terminal
///     0,0,1,0.9,0,0
///     0,0,0,0.1,-1,0
///
/// s, a and next are whole numbers from 0 on, the greatest of which give the number of states (at most 10 million) and
/// actions (at most 256; together at most 50 million pairs); `terminal` is 0 or 1 (or false, true). A state that no row
/// begins in has no actions and can be entered by terminal rows only. Rows may come in any order; several with the same
/// s, a and next add up, as where a slip and a wall lead to the same place. Lines that begin with # are comments, empty
/// lines are ignored, and so are blanks around fields.
/// \throws std::runtime_error "NAME:LINE:COLUMN: ..." for anything else, for probabilities of an (s,a) that do not sum
/// to 1 within 1e-9 (at the first of its rows), and for what LineReader refuses.
[[nodiscard]] inline TransitionTable read_table_csv(std::istream& in, const std::string& name) {
    return detail::TableCsvReader(in, name).read();
}

/// The same from a file. \throws std::runtime_error also "PATH: cannot be opened".
[[nodiscard]] inline TransitionTable load_table_csv(const std::string& path) {
    std::ifstream file = open_text(path);
    return read_table_csv(file, path);
}

}  // namespace sspql
