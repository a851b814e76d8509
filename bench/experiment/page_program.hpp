// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "report/recorded_run.hpp"

namespace sspql::experiment {

/// Main of a program that turns recorded runs into a page of Markdown: `PROGRAM FILE... [--out PAGE]`, the page on the
/// terminal unless it goes to a file. \returns the exit status: 2, after one line on stderr, for anything wrong.
int page_program(const std::string& program, const std::string& description,
                 const std::function<std::string(const std::vector<report::RecordedRun>&)>& page, int argc,
                 char** argv);

}  // namespace sspql::experiment
