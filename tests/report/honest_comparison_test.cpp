// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "report/honest_comparison.hpp"
#include "report/markdown.hpp"
#include "report/paper_statements.hpp"
#include "report/recorded_run.hpp"
#include "report/verdict.hpp"

namespace sspql::report {
namespace {

using Json = nlohmann::ordered_json;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Json value(double mean, double error) { return {{"mean", mean}, {"se", error}, {"sd", 10.0 * error}}; }

/// 100 seeds of 40 episodes; `steps` are those of the first 30 episodes, with standard error 3.
Json learner(const std::string& name, double steps, double operations = 5.0) {
    return {{"name", name},
            {"seeds", 100},
            {"episodes", 40},
            {"total_steps", value(steps * 4.0 / 3.0, 4.0)},
            {"first5_steps", value(steps / 6.0, 1.0)},
            {"first30_steps", value(steps, 3.0)},
            {"late_steps", {{"mean", steps / 30.0}, {"se", 0.1}}},
            {"late_return", {{"mean", 1.0}, {"se", 0.0}}},
            {"mean_return", {{"mean", 1.0}, {"se", 0.0}}},
            {"success_rate", 1.0},
            {"late_success_rate", 1.0},
            {"capped_episodes", 0},
            {"model_ops_per_step", operations},
            {"curve", {{"mean", std::vector<double>(40, steps / 30.0)}, {"sd", std::vector<double>(40, 1.0)}}},
            {"cumulative_reward", Json::array()},
            {"per_seed", Json::object()}};
}

Json phase(const std::string& name, std::vector<Json> learners) {
    return {{"name", name}, {"optimal_steps", 8.0}, {"optimal_return", 1.0}, {"learners", std::move(learners)}};
}

Json grid_json(std::vector<Json> phases, Json settings = Json::object()) {
    return {{"experiment", "grid_experiment"},
            {"version", "0.1.0"},
            {"settings", std::move(settings)},
            {"phases", std::move(phases)},
            {"timing", {{"sspql", {{"learn_ns_per_step", 50.0}}}, {"dyna-q:20", {{"learn_ns_per_step", 400.0}}}}}};
}

RecordedRun run_of(const Json& json, const std::string& path = "results/run.json") {
    return parse_recorded_run(json.dump(), path);
}

const Statement& statement(const std::vector<ComparisonSection>& sections, const std::string& heading,
                           const std::string& claim) {
    for (const ComparisonSection& section : sections) {
        if (!contains(section.heading, heading)) continue;
        for (const Statement& one : section.statements) {
            if (contains(one.claim, claim)) return one;
        }
    }
    throw std::logic_error("no statement " + heading + ": " + claim);
}

Verdict verdict(const std::vector<ComparisonSection>& sections, const std::string& heading, const std::string& claim) {
    return statement(sections, heading, claim).findings.at(0).contest.verdict;
}

// ---- verdicts -----------------------------------------------------------------------------------------------------

TEST(Verdict, TwoStandardErrorsDecide) {
    // Errors 3 and 4: 5 for the difference.
    const Summary low{10, 90.0, 0.0, 3.0};
    const Summary high{10, 100.0, 0.0, 4.0};
    const Contest contest = is_less(low, high);
    EXPECT_EQ(contest.verdict, Verdict::holds);
    EXPECT_DOUBLE_EQ(contest.z, 2.0);
    EXPECT_DOUBLE_EQ(contest.ratio, 0.9);
    EXPECT_NEAR(contest.ratio_error, 0.9 * std::hypot(3.0 / 90.0, 4.0 / 100.0), 1e-12);
    EXPECT_EQ(is_less(high, low).verdict, Verdict::fails);
    EXPECT_EQ(is_greater(high, low).verdict, Verdict::holds);
    EXPECT_EQ(is_less({10, 91.0, 0.0, 3.0}, high).verdict, Verdict::open);  // z = 1.8
}

TEST(Verdict, OneSeedDecidesNothing) {
    EXPECT_EQ(is_less({1, 1.0, 0.0, 0.0}, {10, 100.0, 0.0, 4.0}).verdict, Verdict::open);
    EXPECT_EQ(is_less({}, {}).verdict, Verdict::open);
    EXPECT_EQ(Contest{}.verdict, Verdict::missing);
}

TEST(Verdict, WhatDoesNotVaryIsCompared) {
    EXPECT_EQ(is_less({5, 7.0, 0.0, 0.0}, {5, 8.0, 0.0, 0.0}).verdict, Verdict::holds);
    EXPECT_EQ(is_less({5, 8.0, 0.0, 0.0}, {5, 8.0, 0.0, 0.0}).verdict, Verdict::open);
    EXPECT_TRUE(std::isinf(is_less({5, 7.0, 0.0, 0.0}, {5, 8.0, 0.0, 0.0}).z));
}

TEST(Verdict, Multiples) {
    // 3 * 100 with error 3 * 4 against 320 with error 5: 20 / 13.
    EXPECT_NEAR(is_multiple({9, 320.0, 0.0, 5.0}, {9, 100.0, 0.0, 4.0}, 3.0).z, 20.0 / 13.0, 1e-12);
    EXPECT_EQ(is_multiple({9, 330.0, 0.0, 5.0}, {9, 100.0, 0.0, 4.0}, 3.0).verdict, Verdict::holds);
    EXPECT_EQ(is_multiple({9, 200.0, 0.0, 5.0}, {9, 100.0, 0.0, 4.0}, 3.0).verdict, Verdict::fails);
}

TEST(Verdict, TalliesReadAsText) {
    Tally tally;
    EXPECT_EQ(tally.text(), "not in the recorded run");
    tally.add(Verdict::missing);
    tally.add(Verdict::holds);
    EXPECT_EQ(tally.text(), "holds");
    tally.add(Verdict::fails);
    tally.add(Verdict::holds);
    tally.add(Verdict::open);
    EXPECT_EQ(tally.text(), "holds in 2 of 4, does not hold in 1 of 4, not decided in 1 of 4");
}

// ---- reading ------------------------------------------------------------------------------------------------------

TEST(RecordedRun, ReadsNumbersAndSettings) {
    Json json = grid_json({phase("open64", {learner("sspql", 600.0), learner("q", 900.0)})},
                          {{"maps", {"open64"}},
                           {"table", ""},
                           {"slip", nullptr},
                           {"noise_kind", "other"},
                           {"set", {"*.gamma=.95", "q.epsilon=.1"}},
                           {"seeds", 100},
                           {"total_steps", 0}});
    json["phases"][0]["learners"][1]["first30_steps"]["se"] = nullptr;
    const RecordedRun run = run_of(json);
    EXPECT_EQ(run.file, "run.json");
    EXPECT_EQ(run.version, "0.1.0");
    EXPECT_EQ(run.setting("noise_kind"), "other");
    EXPECT_EQ(run.setting("slip"), "");
    EXPECT_EQ(run.command(),
              "grid_experiment --maps open64 --noise-kind other --set '*.gamma=.95' --set q.epsilon=.1 --seeds 100");
    const RecordedPhase& open = run.phases.at(0);
    EXPECT_EQ(open.optimal_steps, 8.0);
    const LearnerStatistics* sspql = open.find("sspql");
    ASSERT_NE(sspql, nullptr);
    EXPECT_EQ(sspql->first30_steps.count, 100u);
    EXPECT_EQ(sspql->first30_steps.error, 3.0);
    EXPECT_EQ(sspql->learn_ns_per_step, 50.0);
    EXPECT_EQ(open.find("q")->first30_steps.count, 1u);
    EXPECT_TRUE(std::isnan(open.find("q")->learn_ns_per_step));
    EXPECT_EQ(open.find("ps"), nullptr);
}

TEST(RecordedRun, RefusesWhatIsNone) {
    const auto message = [](const std::string& text) -> std::string {
        try {
            static_cast<void>(parse_recorded_run(text, "x/a.json"));
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_EQ(message("{}"),
              "x/a.json: not a report of grid_experiment or pusher_experiment: key 'experiment' not found");
    EXPECT_TRUE(contains(message("nonsense"), "x/a.json: not a report"));
    EXPECT_EQ(message(R"({"experiment": "pusher_mission"})"),
              "x/a.json: a report of pusher_mission, not of grid_experiment or pusher_experiment");
    Json json = grid_json({phase("open64", {learner("q", 1.0)})});
    json["phases"][0]["learners"][0]["curve"]["mean"] = {1.0};
    EXPECT_EQ(message(json.dump()), "x/a.json: the curve of q does not have its 40 episodes");
    EXPECT_THROW(static_cast<void>(load_recorded_run("/nonexistent/a.json")), std::runtime_error);
}

// ---- statements ---------------------------------------------------------------------------------------------------

TEST(HonestComparison, Figure5) {
    const std::vector<Json> scratch{learner("q", 900.0),        learner("ps", 602.0),
                                    learner("sspql", 600.0),    learner("q-bonus", 500.0),
                                    learner("ps-bonus", 400.0), learner("sspql-bonus", 450.0)};
    const std::vector<Json> changed{learner("q", 700.0),
                                    learner("ps", 5000.0),
                                    learner("sspql", 800.0),
                                    learner("q-bonus", 500.0),
                                    learner("ps-bonus", 600.0),
                                    learner("sspql-bonus", 450.0),
                                    learner("q-optimistic", 430.0),
                                    learner("sspql-constant", 9000.0)};
    const auto sections = compare_runs({run_of(grid_json({phase("open64", scratch), phase("soft54", changed)}))});

    const std::string a = "Fig. 5a";
    EXPECT_EQ(verdict(sections, a, "than Q-learning, neither"), Verdict::holds);
    EXPECT_EQ(verdict(sections, a, "than Q-learning, both"), Verdict::holds);
    EXPECT_EQ(verdict(sections, a, "than prioritized sweeping, neither"), Verdict::open);  // 2 of 4.2
    EXPECT_EQ(verdict(sections, a, "than prioritized sweeping, both"), Verdict::fails);
    EXPECT_EQ(statement(sections, a, "than prioritized sweeping, both").findings.size(), 1u);  // phase 1 only
    EXPECT_EQ(statement(sections, a, "than prioritized sweeping, both").findings[0].numbers,
              "`sspql-bonus` 450 \u00b1 3, `ps-bonus` 400 \u00b1 3");

    const std::string bc = "Fig. 5b, c";
    EXPECT_EQ(verdict(sections, bc, "slower than Q-learning, neither"), Verdict::holds);
    EXPECT_EQ(verdict(sections, bc, "slower than Q-learning, both"), Verdict::holds);
    EXPECT_EQ(verdict(sections, bc, "fewer steps than Q-learning, neither"), Verdict::fails);
    EXPECT_EQ(verdict(sections, bc, "fewer steps than Q-learning, both"), Verdict::holds);
    EXPECT_EQ(verdict(sections, bc, "fewer steps than Dyna-Q"), Verdict::missing);
    EXPECT_EQ(verdict(sections, bc, "than optimistic Q-learning"), Verdict::fails);
    EXPECT_EQ(verdict(sections, bc, "is best"), Verdict::fails);
    EXPECT_TRUE(contains(statement(sections, bc, "is best").findings[0].numbers, "`q-optimistic` 430"));
    EXPECT_EQ(verdict(sections, "constant weight", "`q-bonus`"), Verdict::holds);
    EXPECT_EQ(verdict(sections, "library's answer", "SSPQL with the bonus"), Verdict::missing);
}

TEST(HonestComparison, TheSamePhaseOfTwoRunsCountsOnce) {
    const Json open = phase("open64", {learner("q", 900.0), learner("sspql", 600.0)});
    const auto sections = compare_runs({run_of(grid_json({open})), run_of(grid_json({open}))});
    EXPECT_EQ(statement(sections, "Fig. 5a", "than Q-learning, neither").findings.size(), 1u);
}

TEST(HonestComparison, Table1) {
    Json json = grid_json({phase("approach", {learner("q", 2849.0), learner("ssp", 920.0), learner("sspql", 940.0),
                                              learner("sspql-bonus", 638.0), learner("ps-bonus", 500.0)})},
                          {{"task", "approach"}});
    json["experiment"] = "pusher_experiment";
    const auto sections = compare_runs({run_of(json)});
    EXPECT_EQ(verdict(sections, "Table 1", "SSP needs fewer steps than Q-learning"), Verdict::holds);
    EXPECT_EQ(verdict(sections, "Table 1", "SSPQL needs fewer steps than SSP"), Verdict::fails);
    EXPECT_EQ(verdict(sections, "Table 1", "relative to Q-learning"), Verdict::fails);  // 0.33 against 0.29
    EXPECT_EQ(verdict(sections, "robot", "sweeping, both with the bonus"), Verdict::fails);
    EXPECT_TRUE(statement(sections, "Fig. 5a", "than Q-learning, neither").findings.empty());
    json["settings"]["task"] = "turn";
    EXPECT_TRUE(statement(compare_runs({run_of(json)}), "Table 1", "than Q-learning").findings.empty());
}

TEST(HonestComparison, DynaQsCostStandsWithKAndEpisodeLength) {
    // 600 steps in 30 episodes and 800 in all 40: 20 an episode.
    const RecordedRun run =
        run_of(grid_json({phase("open64", {learner("sspql", 600.0, 8.0), learner("dyna-q", 300.0, 11.0),
                                           learner("dyna-q:20", 300.0, 21.0)})},
                         {{"set", {"dyna-q.k=5"}}}));
    const auto sections = compare_runs({run});
    const Statement& operations = statement(sections, "Section 3.1", "records and edges per step");
    ASSERT_EQ(operations.findings.size(), 2u);
    EXPECT_EQ(operations.findings[1].numbers,
              "`sspql`: 20.0 steps per episode, 8.0 operations and 50 ns per step; `dyna-q:20` (k = 20): 10.0 steps "
              "per episode, 21.0 operations and 400 ns per step; operations per run: 6400 and 8400");
    EXPECT_TRUE(contains(operations.findings[0].numbers, "`dyna-q` (k = 5)"));
    EXPECT_EQ(operations.findings[0].contest.verdict, Verdict::holds);
    const Statement& time = statement(sections, "Section 3.1", "less time");
    EXPECT_EQ(time.findings[0].contest.verdict, Verdict::missing);  // not timed
    EXPECT_EQ(time.findings[1].contest.verdict, Verdict::holds);
    // 800 * 8 = 6400 against 400 * 11 = 4400 and 400 * 21 = 8400.
    const Statement& altogether = statement(sections, "Section 3.1", "whole run");
    EXPECT_EQ(altogether.findings[0].contest.verdict, Verdict::fails);
    EXPECT_EQ(altogether.findings[1].contest.verdict, Verdict::holds);
    EXPECT_EQ(planning_steps(run, "ps-bonus"), "10");
    EXPECT_DOUBLE_EQ(steps_per_episode(run, "sspql"), 20.0);
}

TEST(HonestComparison, Chain) {
    // Fewest possible: 30 * 8 = 240 without, 30 * 30 = 900 with cycles. Dyna-Q: 1.25 and 2.0; ps: 1.25 and 1.25.
    Json noisy = phase("chain", {learner("sspql", 1100.0), learner("dyna-q:5", 1800.0), learner("ps", 1125.0)});
    noisy["optimal_steps"] = 30.0;
    const Json sure = phase("chain", {learner("sspql", 300.0), learner("dyna-q:5", 300.0), learner("ps", 300.0)});
    const RecordedRun with = run_of(grid_json({noisy}, {{"slip", 0.7}}));
    const RecordedRun without = run_of(grid_json({sure}, {{"slip", 0.0}}));
    const auto sections = compare_runs({with, without});
    EXPECT_EQ(verdict(sections, "Fig. 3", "than Dyna-Q on the chain"), Verdict::holds);
    EXPECT_EQ(statement(sections, "Fig. 3", "than Dyna-Q on the chain").findings.size(), 1u);
    EXPECT_EQ(statement(sections, "Fig. 3", "than Dyna-Q on the chain").findings[0].where, "chain, p = 0.3 (run 1)");
    EXPECT_EQ(verdict(sections, "Fig. 3", "slow Dyna-Q"), Verdict::holds);
    EXPECT_EQ(verdict(sections, "Fig. 3", "slow prioritized"), Verdict::open);
    EXPECT_EQ(verdict(compare_runs({with}), "Fig. 3", "slow Dyna-Q"), Verdict::missing);
}

TEST(HonestComparison, Mazes) {
    const auto rewarded = [](const std::string& name, double first, double last) {
        Json json = learner(name, 100.0);
        json["cumulative_reward"] = {{{"step", 1000}, {"mean", first}, {"se", 1.0}},
                                     {{"step", 3000}, {"mean", last}, {"se", 2.0}}};
        return json;
    };
    // Per 1000 steps: sspql 54 and then 0; dyna-q-plus 56 and then 37 (half of 56 is 28).
    const RecordedRun run = run_of(grid_json(
        {phase("blocking-maze", {rewarded("sspql", 54.0, 54.0), rewarded("ps", 54.0, 55.0),
                                 rewarded("sspql-bonus", 56.0, 130.0), rewarded("dyna-q-plus", 56.0, 130.0)})},
        {{"maps", {"blocking-maze"}}}));
    const auto sections = compare_runs({run});
    EXPECT_EQ(verdict(sections, "mazes", "`sspql` does better than `dyna-q-plus`"), Verdict::fails);
    EXPECT_EQ(verdict(sections, "mazes", "`sspql` does better than `ps`"), Verdict::open);
    EXPECT_EQ(verdict(sections, "mazes", "`sspql-bonus` does better than `ps`"), Verdict::holds);
    EXPECT_EQ(verdict(sections, "mazes", "`sspql` does better than `dyna-q`"), Verdict::missing);
    EXPECT_EQ(verdict(sections, "mazes", "moved, `sspql` "), Verdict::fails);
    EXPECT_EQ(verdict(sections, "mazes", "moved, `sspql-bonus` "), Verdict::holds);
    EXPECT_TRUE(contains(statement(sections, "mazes", "moved, `sspql` ").findings[0].numbers,
                         "54.0 \u00b1 1.0 before, 0.0 \u00b1 1.1 after"));
    EXPECT_EQ(run.command(), "grid_experiment --maps blocking-maze --report-at 1000,3000");
    EXPECT_TRUE(contains(honest_comparison({run}), "| 54.0 \u00b1 1.0 | 54.0 \u00b1 2.0 | 2.5 |"));
}

TEST(HonestComparison, ThePage) {
    const RecordedRun run = run_of(grid_json({phase("open64", {learner("q", 900.0), learner("sspql", 600.0)})},
                                             {{"maps", {"open64"}}, {"seeds", 100}}));
    const std::string page = honest_comparison({run});
    for (const char* part :
         {"# What holds of the paper, and what does not", "Of 1 statement that", "1 hold wherever they were tried",
          "| From scratch (Fig. 5a) | SSPQL needs fewer steps than Q-learning, neither with a bonus | holds |",
          "| SSPQL needs fewer steps than Q-learning, neither with a bonus | open64 | `sspql` 600 \u00b1 3, `q` 900 "
          "\u00b1 3 | 0.67 \u00b1 0.00 | 70.7 | holds |",
          "prioritized sweeping, both with the bonus: not in the recorded run (`sspql-bonus` is not in the recorded "
          "run)",
          "grid_experiment --maps open64 --seeds 100\n", "`run.json`, sspql 0.1.0",
          "honest_comparison run.json --out"}) {
        EXPECT_TRUE(contains(page, part)) << part << "\n" << page.substr(0, 3000);
    }
    EXPECT_EQ(page, honest_comparison({run}));
    EXPECT_TRUE(contains(honest_comparison({}), "Of 0 statements"));
}

TEST(Markdown, CellsAreHarmless) {
    EXPECT_EQ(markdown_table({"a", "b"}, {{"x|y", "1\n2"}, {"z"}}, 1),
              "| a | b |\n|---|---:|\n| x\\|y | 1 2 |\n| z |  |\n\n");
}

}  // namespace
}  // namespace sspql::report
