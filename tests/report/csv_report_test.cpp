// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <limits>

#include "fabricated_results.hpp"
#include "report/csv_report.hpp"

namespace sspql::report {
namespace {

TEST(CsvReport, OneRowPerEpisode) {
    ExperimentResults results = results_of({{"q", {run_of(7, {3, 2000})}}, {"dyna-q:20", {run_of(8, {5})}}});
    results.phases[0].learners[0].runs[0].episodes[1] = {2000, -0.1, false, true};
    EXPECT_EQ(csv_report(results),
              "phase,learner,seed,episode,steps,return,success,capped\n"
              "approach,q,7,1,3,1,1,0\n"
              "approach,q,7,2,2000,-0.1,0,1\n"
              "approach,dyna-q:20,8,1,5,1,1,0\n");
}

TEST(CsvReport, QuotesFieldsAndLeavesOutWhatIsNoNumber) {
    ExperimentResults results = results_of({{"q", {run_of(1, {3})}}});
    results.phases[0].name = "maps/\"a\",b";
    results.phases[0].learners[0].runs[0].episodes[0].total_reward = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(csv_report(results),
              "phase,learner,seed,episode,steps,return,success,capped\n"
              "\"maps/\"\"a\"\",b\",q,1,1,3,,1,0\n");
}

}  // namespace
}  // namespace sspql::report
