// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// \file
/// The colours of all pictures and pages, by role. Every role has a light and a dark colour: a picture carries the
/// light one as an attribute (so that any viewer shows it) and a class by which a style sheet overrides it in the dark.

namespace sspql::report {

/// What a colour is for. The series are Okabe and Ito's colours (2008), which colour-blind readers tell apart, ordered
/// so that neighbours differ most; their yellow, unreadable on white, is replaced by olive.
enum class Ink {
    none,
    paper,
    text,
    faint,  ///< second-rank text
    axis,
    grid,
    series0,  ///< vermillion
    series1,  ///< reddish purple
    series2,  ///< blue
    series3,  ///< bluish green
    series4,  ///< orange
    series5,  ///< sky blue
    series6,  ///< black
    series7,  ///< olive
    floor,
    wall,
    goal,
    goal_edge,
    region,
    region_text,
    box,
    box_edge,
    robot,
    value,  ///< of a cell: the stronger, the greater
};

inline constexpr std::size_t series_inks = 8;

/// The colour of the i-th series; they repeat after eight.
[[nodiscard]] Ink series_ink(std::size_t i) noexcept;

/// "series0": a class is "f-series0" for a fill and "s-series0" for a stroke. "none" for Ink::none.
[[nodiscard]] std::string_view ink_name(Ink ink) noexcept;

/// "#D55E00"; "none" for Ink::none.
[[nodiscard]] std::string_view light_colour(Ink ink) noexcept;
[[nodiscard]] std::string_view dark_colour(Ink ink) noexcept;

/// The rules that give every class its dark colour, within a media query: on a screen whose user prefers dark. Paper
/// stays light.
[[nodiscard]] std::string dark_picture_css();

}  // namespace sspql::report
