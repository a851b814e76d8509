// SPDX-License-Identifier: MIT
#include "report/palette.hpp"

#include <array>

namespace sspql::report {

namespace {

struct Entry {
    std::string_view name;
    std::string_view light;
    std::string_view dark;
};

/// In the order of Ink.
constexpr std::array<Entry, 24> entries{{
    {"none", "none", "none"},           {"paper", "#FFFFFF", "#15181C"},       {"text", "#1B1F24", "#E8EAED"},
    {"faint", "#59636E", "#A3ADB8"},    {"axis", "#8A949E", "#6F7A86"},        {"grid", "#E4E8EC", "#2B3138"},
    {"series0", "#D55E00", "#FF8A45"},  {"series1", "#B65F92", "#E39AC4"},     {"series2", "#0072B2", "#4BA3EC"},
    {"series3", "#009E73", "#2FC79B"},  {"series4", "#E69F00", "#F2B83B"},     {"series5", "#56B4E9", "#9BD7FA"},
    {"series6", "#000000", "#FFFFFF"},  {"series7", "#857A00", "#C9BE3A"},     {"floor", "#F8F7F3", "#1B1F24"},
    {"wall", "#3C444D", "#8C97A3"},     {"goal", "#F6CF65", "#8A6A14"},        {"goal-edge", "#9A6F00", "#F2C14E"},
    {"region", "#8FD9C0", "#1E6B55"},   {"region-text", "#00664A", "#8FE8CB"}, {"box", "#D9AE78", "#9A7040"},
    {"box-edge", "#6E4A1C", "#EBCB9E"}, {"robot", "#DFE6EE", "#3B4550"},       {"value", "#3D9BD8", "#2A74B4"},
}};

const Entry& entry(Ink ink) noexcept { return entries[static_cast<std::size_t>(ink)]; }

}  // namespace

Ink series_ink(std::size_t i) noexcept {
    return static_cast<Ink>(static_cast<std::size_t>(Ink::series0) + i % series_inks);
}

std::string_view ink_name(Ink ink) noexcept { return entry(ink).name; }
std::string_view light_colour(Ink ink) noexcept { return entry(ink).light; }
std::string_view dark_colour(Ink ink) noexcept { return entry(ink).dark; }

std::string dark_picture_css() {
    std::string css = "@media screen and (prefers-color-scheme:dark){\n";
    for (const Entry& e : entries) {
        if (e.name == "none") continue;
        css.append(".f-").append(e.name).append("{fill:").append(e.dark);
        css.append("}.s-").append(e.name).append("{stroke:").append(e.dark).append("}\n");
    }
    return css + "}\n";
}

}  // namespace sspql::report
