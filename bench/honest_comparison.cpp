// SPDX-License-Identifier: MIT
//
// Which of the paper's statements hold, and against what? Writes docs/honest-comparison.md from the JSON of recorded
// runs: honest_comparison --help

#include "report/honest_comparison.hpp"
#include "experiment/page_program.hpp"

int main(int argc, char** argv) {
    return sspql::experiment::page_program("honest_comparison",
                                           "Which statements of Kwon, Suh and Lee (2011) hold, and against what: a "
                                           "page of Markdown whose every verdict is computed from recorded runs.",
                                           sspql::report::honest_comparison, argc, argv);
}
