// SPDX-License-Identifier: MIT
//
// Which of the paper's statements hold, and against what? Writes docs/honest-comparison.md from the JSON of recorded
// runs: honest_comparison --help

#include <iostream>
#include <string>
#include <vector>

#include "experiment/options.hpp"
#include "report/honest_comparison.hpp"
#include "report/output_file.hpp"
#include "report/recorded_run.hpp"

namespace {

using namespace sspql;

int body(int argc, char** argv) {
    std::vector<std::string> files;
    std::string out;
    experiment::Options parser("honest_comparison",
                               "Which statements of Kwon, Suh and Lee (2011) hold, and against what: a page of "
                               "Markdown whose every verdict is computed from recorded runs.");
    parser.files("FILE", files, "JSON written by grid_experiment or pusher_experiment");
    parser.text("--out", out, "Write the page to this file instead of the terminal");
    if (!parser.parse(argc, argv)) return 0;

    std::vector<report::RecordedRun> runs;
    for (const std::string& file : files) runs.push_back(report::load_recorded_run(file));
    const std::string page = report::honest_comparison(runs);
    if (!out.empty()) {
        report::write_file(out, page);
        return 0;
    }
    std::cout << page << std::flush;
    return std::cout.good() ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) { return sspql::experiment::run_program("honest_comparison", body, argc, argv); }
