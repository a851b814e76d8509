// SPDX-License-Identifier: MIT
#include "report/markdown.hpp"

#include <cstddef>

namespace sspql::report {

namespace {

std::string row_text(const std::vector<std::string>& cells, std::size_t columns) {
    std::string text = "|";
    for (std::size_t i = 0; i < columns; ++i) {
        text += ' ';
        for (const char c : i < cells.size() ? cells[i] : std::string()) {
            if (c == '|') text += '\\';
            text += c == '\n' || c == '\r' ? ' ' : c;
        }
        text += " |";
    }
    return text + "\n";
}

}  // namespace

std::string markdown_table(const std::vector<std::string>& headings, const std::vector<std::vector<std::string>>& rows,
                           std::size_t numeric_from) {
    std::string text = row_text(headings, headings.size()) + "|";
    for (std::size_t i = 0; i < headings.size(); ++i) text += i < numeric_from ? "---|" : "---:|";
    text += "\n";
    for (const auto& row : rows) text += row_text(row, headings.size());
    return text + "\n";
}

}  // namespace sspql::report
