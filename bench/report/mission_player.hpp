// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/mission_replay.hpp"

/// \file
/// The part of a page that plays missions: plain HTML, CSS and JavaScript, nothing fetched.

namespace sspql::report {

/// The player with its data, ready to stand in a page of HtmlPage's; one a page. With "#selftest" in the page's address
/// it checks itself and writes what it found into the element "selftest".
[[nodiscard]] std::string mission_player(const ReplayStage& stage, const std::vector<MissionReplay>& replays);

/// The script's two halves: what is drawn, and what reacts. In this order they make one function body.
[[nodiscard]] const char* mission_drawing_script();
[[nodiscard]] const char* mission_control_script();

}  // namespace sspql::report
