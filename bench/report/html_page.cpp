// SPDX-License-Identifier: MIT
#include "report/html_page.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "report/escape.hpp"
#include "report/palette.hpp"

namespace sspql::report {

namespace {

constexpr const char* page_css = R"css(
:root{color-scheme:light dark;--paper:#fff;--text:#1b1f24;--faint:#59636e;--rule:#d8dee4;--band:#f5f7f9;--best:#dff3ea}
@media screen and (prefers-color-scheme:dark){
:root{--paper:#15181c;--text:#e8eaed;--faint:#a3adb8;--rule:#333a42;--band:#1c2126;--best:#14392d}}
*{box-sizing:border-box}
body{margin:0;background:var(--paper);color:var(--text);
font:16px/1.55 system-ui,-apple-system,'Segoe UI',Roboto,'Helvetica Neue',Arial,sans-serif}
main,footer{max-width:62rem;margin:0 auto;padding:0 1.25rem}
h1{font-size:1.75rem;line-height:1.25;margin:2.2rem 0 .6rem;letter-spacing:-.01em}
h2{font-size:1.2rem;line-height:1.3;margin:2.4rem 0 .7rem;padding-top:1.1rem;border-top:1px solid var(--rule)}
p{margin:.7rem 0;max-width:46rem;text-wrap:pretty}
.lead{font-size:1.15rem;line-height:1.5}
.note{font-size:.875rem;color:var(--faint)}
.scroll{overflow-x:auto;margin:1rem 0}
table{border-collapse:collapse;font-size:.9375rem;min-width:100%}
.legend{font-size:.875rem;color:var(--faint);line-height:1.45;margin-top:-.3rem}
th,td{padding:.38rem .55rem;text-align:left;vertical-align:top}
th:first-child,td:first-child{min-width:8.5rem;padding-left:.2rem}
th{font-weight:600;vertical-align:bottom;line-height:1.25}
thead tr:last-child th{border-bottom:2px solid var(--text)}
thead .group{border-bottom:1px solid var(--rule);text-align:center}
.unit{display:block;font-weight:400;font-size:.8125rem;color:var(--faint)}
.number{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}
tbody tr+tr td{border-top:1px solid var(--rule)}
.best{background:var(--best);font-weight:600}
.edge{border-left:1px solid var(--rule)}
figure{margin:1.2rem 0;min-width:0}
figure .scroll{margin:0}
svg{display:block;width:100%;height:auto}
figcaption{font-size:.875rem;color:var(--faint);line-height:1.45;margin-top:.5rem;max-width:46rem}
.wide svg{min-width:26rem;max-width:44rem}
.row{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(24rem,100%),1fr));gap:.6rem 1.6rem}
.row figure{margin:.5rem 0}
.pictures{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(12.5rem,45%),1fr));gap:1rem 1.1rem;margin:1rem 0}
footer{margin-top:2.6rem;padding-bottom:2.5rem;font-size:.875rem}
footer div{border-top:1px solid var(--rule);padding-top:.9rem}
dl{display:grid;grid-template-columns:max-content 1fr;gap:.15rem 1rem;margin:0}
dt{color:var(--faint)}
dd{margin:0;overflow-wrap:anywhere;min-width:0}
code{font-family:ui-monospace,'SF Mono',Menlo,Consolas,'DejaVu Sans Mono',monospace;font-size:.92em}
@media print{
@page{margin:16mm}
body{font-size:10.5pt}
main,footer{max-width:none;padding:0}
figure,tr,.pictures div{break-inside:avoid}
h2{break-after:avoid}
.scroll{overflow:visible}
.wide svg{min-width:0}
.best{-webkit-print-color-adjust:exact;print-color-adjust:exact}}
)css";

/// Whether a column starts another group than its left neighbour's: a thin line stands there.
bool is_edge(const std::vector<HtmlColumn>& columns, std::size_t i) {
    return i > 0 && columns[i].group != columns[i - 1].group;
}

std::string class_attribute(std::string classes) {
    classes.erase(0, classes.find_first_not_of(' '));
    return classes.empty() ? std::string() : " class=\"" + classes + "\"";
}

std::string group_row(const std::vector<HtmlColumn>& columns) {
    const bool any = std::any_of(columns.begin(), columns.end(), [](const HtmlColumn& c) { return !c.group.empty(); });
    if (!any) return {};
    std::string out = "<tr>";
    for (std::size_t i = 0; i < columns.size();) {
        std::size_t end = i;
        while (end < columns.size() && columns[end].group == columns[i].group) ++end;
        const std::string classes =
            std::string(columns[i].group.empty() ? "" : " group") + (is_edge(columns, i) ? " edge" : "");
        out += "<th" + class_attribute(classes) + " colspan=\"" + std::to_string(end - i) + "\">" +
               escaped(columns[i].group) + "</th>";
        i = end;
    }
    return out + "</tr>\n";
}

std::string head_row(const std::vector<HtmlColumn>& columns) {
    std::string out = "<tr>";
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const HtmlColumn& column = columns[i];
        const std::string classes = std::string(column.numeric ? " number" : "") + (is_edge(columns, i) ? " edge" : "");
        out += "<th scope=\"col\"" + class_attribute(classes) + ">" + escaped(column.heading);
        if (!column.unit.empty()) out += "<span class=\"unit\">" + escaped(column.unit) + "</span>";
        out += "</th>";
    }
    return out + "</tr>\n";
}

std::string body_row(const std::vector<HtmlColumn>& columns, const std::vector<HtmlCell>& cells) {
    std::string out = "<tr>";
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const HtmlCell cell = i < cells.size() ? cells[i] : HtmlCell{};
        const std::string classes = std::string(columns[i].numeric ? " number" : "") +
                                    (is_edge(columns, i) ? " edge" : "") + (cell.best ? " best" : "");
        out += "<td" + class_attribute(classes) + ">" + escaped(cell.text) + "</td>";
    }
    return out + "</tr>\n";
}

std::string figure_element(const HtmlFigure& figure, const char* classes) {
    return "<figure" + class_attribute(classes) + "><div class=\"scroll\">\n" + figure.picture.element() +
           "</div><figcaption>" + escaped(figure.caption) + "</figcaption></figure>\n";
}

std::string term(const std::string& name, const std::string& value) {
    return "<dt>" + escaped(name) + "</dt><dd><code>" + escaped(value) + "</code></dd>\n";
}

}  // namespace

HtmlPage::HtmlPage(std::string title) : title_(std::move(title)) {}

void HtmlPage::lead(const std::string& text) { body_ += "<p class=\"lead\">" + escaped(text) + "</p>\n"; }
void HtmlPage::section(const std::string& heading) { body_ += "<h2>" + escaped(heading) + "</h2>\n"; }
void HtmlPage::paragraph(const std::string& text) { body_ += "<p>" + escaped(text) + "</p>\n"; }
void HtmlPage::note(const std::string& text) { body_ += "<p class=\"note\">" + escaped(text) + "</p>\n"; }

void HtmlPage::table(const HtmlTable& table) {
    body_ += "<div class=\"scroll\"><table>\n";
    body_ += "<thead>\n" + group_row(table.columns) + head_row(table.columns) + "</thead>\n<tbody>\n";
    for (const auto& row : table.rows) body_ += body_row(table.columns, row);
    body_ += "</tbody></table></div>\n";
    // Not a <caption>: that would be as wide as a table that has to be scrolled.
    if (!table.caption.empty()) body_ += "<p class=\"legend\">" + escaped(table.caption) + "</p>\n";
}

void HtmlPage::figure(const HtmlFigure& figure) { body_ += figure_element(figure, "wide"); }

void HtmlPage::figure_row(const std::vector<HtmlFigure>& figures) {
    body_ += "<div class=\"row\">\n";
    for (const HtmlFigure& figure : figures) body_ += figure_element(figure, "");
    body_ += "</div>\n";
}

void HtmlPage::picture_row(const std::vector<Svg>& pictures) {
    body_ += "<div class=\"pictures\">\n";
    for (const Svg& picture : pictures) body_ += "<div>" + picture.element() + "</div>\n";
    body_ += "</div>\n";
}

void HtmlPage::markup(const std::string& html) { body_ += html; }

std::string HtmlPage::text(const Manifest& manifest, const std::vector<Setting>& settings) const {
    std::string out = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
    out += "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n";
    out += "<title>" + escaped(title_) + "</title>\n<style>" + page_css + dark_picture_css() + "</style>\n</head>\n";
    out += "<body>\n<main>\n<h1>" + escaped(title_) + "</h1>\n" + body_ + "</main>\n<footer><div><dl>\n";
    out += term("command", manifest.command) + term("sspql", manifest.version) + term("compiler", manifest.compiler);
    for (const Setting& setting : settings) out += term(setting.key, setting.value);
    return out + "</dl></div></footer>\n</body>\n</html>\n";
}

}  // namespace sspql::report
