// SPDX-License-Identifier: MIT
//
// What does the adaptive planner need, and what do the others? Writes docs/adaptive-results.md from the JSON of
// recorded runs (bench/record_adaptive.sh): adaptive_results --help

#include "report/adaptive_results.hpp"
#include "experiment/page_program.hpp"

int main(int argc, char** argv) {
    return sspql::experiment::page_program("adaptive_results",
                                           "The adaptive planner beside the other learners, task by task: a page of "
                                           "Markdown whose every number is computed from recorded runs.",
                                           sspql::report::adaptive_results, argc, argv);
}
