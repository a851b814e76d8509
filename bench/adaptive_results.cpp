// SPDX-License-Identifier: MIT
//
// What does the adaptive planner need, and what do the others? Writes docs/adaptive-results.md from the JSON of
// recorded runs (bench/record_adaptive.sh): adaptive_results --help

#include <iostream>
#include <string>
#include <vector>

#include "experiment/options.hpp"
#include "report/adaptive_results.hpp"
#include "report/output_file.hpp"
#include "report/recorded_run.hpp"

namespace {

using namespace sspql;

int body(int argc, char** argv) {
    std::vector<std::string> files;
    std::string out;
    experiment::Options parser("adaptive_results",
                               "The adaptive planner beside the other learners, task by task: a page of Markdown whose "
                               "every number is computed from recorded runs.");
    parser.files("FILE", files, "JSON written by grid_experiment or pusher_experiment");
    parser.text("--out", out, "Write the page to this file instead of the terminal");
    if (!parser.parse(argc, argv)) return 0;

    std::vector<report::RecordedRun> runs;
    for (const std::string& file : files) runs.push_back(report::load_recorded_run(file));
    const std::string page = report::adaptive_results(runs);
    if (!out.empty()) {
        report::write_file(out, page);
        return 0;
    }
    std::cout << page << std::flush;
    return std::cout.good() ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) { return sspql::experiment::run_program("adaptive_results", body, argc, argv); }
