// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/results.hpp"
#include "report/svg.hpp"

/// \file
/// One self-contained HTML page: style and pictures inside, nothing fetched, light and dark, printable.

namespace sspql::report {

struct HtmlColumn {
    std::string heading{};
    std::string unit{};   ///< below the heading; may be empty
    std::string group{};  ///< neighbouring columns of the same group share a heading above theirs; may be empty
    bool numeric = true;  ///< right-aligned, digits of equal width
};

struct HtmlCell {
    std::string text{};
    bool best = false;  ///< highlighted
};

struct HtmlTable {
    std::string caption;
    std::vector<HtmlColumn> columns;
    std::vector<std::vector<HtmlCell>> rows;
};

struct HtmlFigure {
    Svg picture;
    std::string caption;
};

/// Collects the page's parts in order. Every text is escaped, but for `markup`.
class HtmlPage {
public:
    explicit HtmlPage(std::string title);

    void lead(const std::string& text);  ///< the paragraph that says what was found
    void section(const std::string& heading);
    void paragraph(const std::string& text);
    void note(const std::string& text);  ///< small print
    void table(const HtmlTable& table);
    void figure(const HtmlFigure& figure);
    void figure_row(const std::vector<HtmlFigure>& figures);  ///< beside each other where there is room
    void picture_row(const std::vector<Svg>& pictures);       ///< many small ones, without captions
    void markup(const std::string& html);  ///< as it is: only what the program itself wrote, every text in it escaped

    /// The page, with a footer from which it can be made again.
    [[nodiscard]] std::string text(const Manifest& manifest, const std::vector<Setting>& settings) const;

private:
    std::string title_;
    std::string body_;
};

}  // namespace sspql::report
