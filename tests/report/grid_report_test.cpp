// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "fabricated_results.hpp"
#include "report/grid_report.hpp"
#include "report/grid_study.hpp"

namespace sspql::report {
namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Two seeds, 40 episodes of constant length; the second seed needs one step more in each.
LearnerRuns learner(const std::string& name, std::uint32_t steps) {
    return {name,
            {run_of(1, std::vector<std::uint32_t>(40, steps)), run_of(2, std::vector<std::uint32_t>(40, steps + 1))}};
}

PhaseRuns phase(const std::string& name, std::vector<LearnerRuns> learners) {
    PhaseRuns runs;
    runs.name = name;
    runs.optimal_steps = 8.0;
    runs.learners = std::move(learners);
    return runs;
}

ExperimentResults grid_results(std::vector<PhaseRuns> phases) {
    ExperimentResults results;
    results.experiment = "grid_experiment";
    results.settings = {{"slip", "0.1", false}, {"noise_kind", "other"}, {"steps_per_episode", "5000", false}};
    results.manifest = {"grid_experiment --seeds 2", "0.1.0", "g++ 12.2.0"};
    results.phases = std::move(phases);
    return results;
}

LearnerRuns with_rewards(LearnerRuns runs, const std::vector<double>& reward_at) {
    for (SeedRun& run : runs.runs) run.reward_at = reward_at;
    runs.runs.back().reward_at.back() += 2.0;
    return runs;
}

GridPicture picture() {
    GridPicture map;
    map.rows = 1;
    map.columns = 2;
    map.cells = {{GridCellKind::free, 0.5, GridMove::right}, {GridCellKind::goal}};
    return map;
}

TEST(GridReport, LeadNamesTheWinnersAndWhoIsLevel) {
    // Totals over 30 episodes: q 3015, ps 615 and then 1515, sspql 615 + 15 and then 915; se 15 each.
    const auto phases =
        grid_phases(grid_results({phase("open64", {learner("q", 100), learner("ps", 20), learner("sspql", 21)}),
                                  phase("soft54", {learner("q", 100), learner("ps", 50), learner("sspql", 30)}),
                                  phase("soft47", {learner("q", 100), learner("ps", 30), learner("sspql", 90)})}));
    EXPECT_EQ(phases[0].winner().name, "ps");
    EXPECT_EQ(grid_lead(phases),
              "ps needed the fewest steps in the first 30 episodes on open64: 615, 0.20 of q's, level with sspql; "
              "soft47: 915, 0.30 of q's. sspql needed the fewest steps in the first 30 episodes on soft54: 915, 0.30 "
              "of q's. Means of 2 seeds.");
}

TEST(GridReport, LeadFallsBackToQBonusAndToNothing) {
    EXPECT_TRUE(
        contains(grid_lead(grid_phases(grid_results({phase("a", {learner("q-bonus", 60), learner("ps", 30)})}))),
                 "0.50 of q-bonus's"));
    EXPECT_EQ(grid_lead(grid_phases(grid_results({phase("a", {learner("sspql", 30)})}))),
              "Steps of sspql in the first 30 episodes on a: 915. Means of 2 seeds.");
    ExperimentResults one = grid_results({phase("a", {{"q", {run_of(1, {9})}}, {"ps", {run_of(1, {7})}}})});
    EXPECT_EQ(grid_lead(grid_phases(one)),
              "ps needed the fewest steps in the first episode on a: 7, 0.78 of q's. One seed: chance cannot be told "
              "from skill.");
}

TEST(GridReport, TablesCurvesAndMaps) {
    const ExperimentResults results = grid_results({phase("open64", {learner("q", 100), learner("sspql", 30)}),
                                                    phase("soft54", {learner("q", 100), learner("sspql", 12)})});
    const std::string html =
        grid_report(results, {{{picture(), picture()}, "Seed 1."}, {{picture(), picture()}, "Seed 1."}});
    for (const char* part : {"Phase 1: open64", "Phase 2: soft54", "first 5", "first 30", ">3015<", ">15.0<", ">0.30<",
                             ">100.5<", ">12.56<", "J* = 8", "Seed 1.", "class=\"pictures\"", "With probability 0.1",
                             "cut after 5000 steps", ">2.0<", ">100<"}) {
        EXPECT_TRUE(contains(html, part)) << part;
    }
    // The maps are named after their learners, and the legend stands once for each phase.
    EXPECT_TRUE(contains(html, "Grid map, sspql"));
    std::size_t legends = 0;
    for (std::size_t at = html.find("Legend of the maps"); at != std::string::npos;
         at = html.find("Legend of the maps", at + 1)) {
        ++legends;
    }
    EXPECT_GE(legends, 2u);
}

TEST(GridReport, TasksCountedInSteps) {
    PhaseRuns maze = phase("blocking-maze", {with_rewards(learner("q", 10), {10.0, 20.0}),
                                             with_rewards(learner("adaptive", 10), {50.0, 60.0})});
    maze.report_at = {1000, 3000};
    const std::string html = grid_report(grid_results({maze}), {});
    for (const char* part : {"adaptive got the most reward in 3000 steps on blocking-maze: 61.0 against q&#39;s 21.0",
                             "by step 1000", "by step 3000", "61.0 \u00b1 1.0", "reward collected"}) {
        EXPECT_TRUE(contains(html, part)) << part;
    }
    EXPECT_FALSE(contains(html, "first 30"));
}

TEST(GridReport, TablesAreJudgedByReturns) {
    ExperimentResults results = grid_results({phase("bets.csv", {learner("q", 10), learner("sspql", 30)})});
    results.settings.push_back({"table", "bets.csv"});
    for (SeedRun& run : results.phases[0].learners[1].runs) {
        for (EpisodeRecord& episode : run.episodes) episode.total_reward = 7.5;
    }
    results.phases[0].optimal_return = 9.0;
    const std::string html = grid_report(results, {});
    for (const char* part :
         {"A table: bets.csv", "sspql got the highest mean return on bets.csv: 7.5 against q&#39;s 1.0",
          "Return per episode", "best = 9"}) {
        EXPECT_TRUE(contains(html, part)) << part;
    }
    EXPECT_FALSE(contains(html, "class=\"pictures\""));
}

TEST(GridReport, AnyNumberOfLearnersAndPhases) {
    std::vector<LearnerRuns> twelve;
    for (std::uint32_t i = 0; i < 12; ++i) twelve.push_back(learner("learner" + std::to_string(i), 5 + 40 * i));
    const std::string html = grid_report(grid_results({phase("1", twelve), phase("2", twelve), phase("3", twelve),
                                                       phase("4", twelve), phase("5", twelve)}),
                                         {});
    EXPECT_TRUE(contains(html, "Phase 5: 5"));
    EXPECT_TRUE(contains(html, "logarithmic scale"));
    EXPECT_FALSE(contains(html, "nan"));
    const std::string one = grid_report(grid_results({phase("1", {{"q", {run_of(1, {3})}}})}), {});
    EXPECT_FALSE(contains(one, "Phase 1"));
    EXPECT_TRUE(contains(one, "one seed"));
    EXPECT_NO_THROW(static_cast<void>(grid_report(grid_results({phase("1", {{"q", {run_of(1, {})}}})}), {})));
}

TEST(GridReport, SettingsNotGivenAreNotShown) {
    ExperimentResults results = grid_results({phase("open64", {learner("q", 10)})});
    results.settings[0].value = "null";
    EXPECT_FALSE(contains(grid_setting(results, grid_phases(results)), "probability"));
}

TEST(GridReport, LargeMapsAreLeftOut) {
    GridPicture large;
    large.rows = 100;
    large.columns = 100;
    large.cells.resize(10000);
    const ExperimentResults results = grid_results({phase("big", {learner("q", 10)})});
    EXPECT_TRUE(contains(grid_report(results, {{{large}, ""}}), "cells are not drawn"));
    EXPECT_TRUE(contains(grid_report(results, {{{GridPicture{}}, ""}}), "cells are not drawn"));
}

TEST(GridReport, RefusesWhatDoesNotFit) {
    const ExperimentResults results = grid_results({phase("a", {learner("q", 10)})});
    EXPECT_THROW(static_cast<void>(grid_report(grid_results({}), {})), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(grid_report(grid_results({phase("a", {})}), {})), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(grid_report(results, {{}, {}})), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(grid_report(results, {{{picture(), picture()}, ""}})), std::invalid_argument);
}

}  // namespace
}  // namespace sspql::report
