// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "report/adaptive_results.hpp"
#include "report/adaptive_tasks.hpp"
#include "report/recorded_run.hpp"

namespace sspql::report {
namespace {

using Json = nlohmann::ordered_json;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// 10 seeds of 40 episodes: `steps` in the first 30, a third more in all, standard error 3; 5 touches a step.
Json learner(const std::string& name, double steps) {
    const auto value = [](double mean) -> Json { return {{"mean", mean}, {"se", 3.0}, {"sd", 9.0}}; };
    return {{"name", name},
            {"seeds", 10},
            {"episodes", 40},
            {"total_steps", value(steps * 4.0 / 3.0)},
            {"first5_steps", value(steps / 6.0)},
            {"first30_steps", value(steps)},
            {"late_steps", value(steps / 30.0)},
            {"late_return", value(1.0)},
            {"mean_return", value(1.0)},
            {"success_rate", 1.0},
            {"late_success_rate", 1.0},
            {"capped_episodes", 0},
            {"model_ops_per_step", 5.0},
            {"curve", {{"mean", std::vector<double>(40, steps / 30.0)}, {"sd", std::vector<double>(40, 1.0)}}},
            {"cumulative_reward", Json::array()},
            {"per_seed", Json::object()}};
}

Json phase(const std::string& name, std::vector<Json> learners, double optimal = 10.0) {
    return {{"name", name}, {"optimal_steps", optimal}, {"optimal_return", 1.0}, {"learners", std::move(learners)}};
}

RecordedRun run_of(std::vector<Json> phases, const Json& settings = Json::object()) {
    const Json json{{"experiment", settings.contains("backend") ? "pusher_experiment" : "grid_experiment"},
                    {"version", "0.1.0"},
                    {"settings", settings},
                    {"phases", std::move(phases)}};
    return parse_recorded_run(json.dump(), "run.json");
}

bool any(const TaskEntry&) { return true; }

TEST(AdaptiveTasks, NamesSayWhatMakesATask) {
    const auto tasks =
        adaptive_tasks({run_of({phase("open64", {learner("q", 1.0)}), phase("soft54", {learner("q", 1.0)})}),
                        run_of({phase("open64", {learner("q", 2.0)})}, {{"slip", 0.3}}),
                        run_of({phase("turn", {learner("q", 3.0)})}, {{"backend", "box2d"}})});
    ASSERT_EQ(tasks.size(), 4u);
    EXPECT_EQ(tasks[0].name, "open64");
    EXPECT_EQ(tasks[1].name, "soft54, after open64");
    EXPECT_EQ(tasks[2].name, "open64, 30 % slip");
    EXPECT_EQ(tasks[3].name, "robot, turn (Box2D)");
    EXPECT_EQ(tasks[0].measured, "steps, 30 episodes");
    EXPECT_EQ(tasks[0].seeds, 10u);
}

TEST(AdaptiveTasks, ARunWithOtherParametersJoinsItsTask) {
    const auto tasks = adaptive_tasks({run_of({phase("open64", {learner("q", 900.0), learner("adaptive", 500.0)})}),
                                       run_of({phase("open64", {learner("q", 400.0), learner("ps", 450.0)})},
                                              {{"set", {"q.alpha=.5", "*.gamma=.95"}}}),
                                       run_of({phase("open64", {learner("q", 1.0)})})});
    ASSERT_EQ(tasks.size(), 1u);
    ASSERT_EQ(tasks[0].entries.size(), 4u);
    EXPECT_EQ(tasks[0].entries[2].changes, "alpha=.5, gamma=.95");
    EXPECT_EQ(tasks[0].entries[3].changes, "gamma=.95");
    EXPECT_EQ(tasks[0].find("q")->value.mean, 900.0);  // not 1: the same task with the same parameters again
    EXPECT_EQ(tasks[0].find("ps"), nullptr);
    EXPECT_EQ(tasks[0].best(any)->value.mean, 400.0);
}

TEST(AdaptiveTasks, MapsOfAKindAreOneTask) {
    Json second = learner("adaptive", 900.0);
    second["capped_episodes"] = 2;
    second["model_ops_per_step"] = 15.0;
    const auto tasks = adaptive_tasks(
        {run_of({phase("walls60", {learner("adaptive", 300.0)}, 20.0)}), run_of({phase("walls60:2", {second}, 40.0)})});
    ASSERT_EQ(tasks.size(), 1u);
    const TaskEntry& entry = tasks[0].entries.at(0);
    EXPECT_EQ(tasks[0].name, "walls60");
    EXPECT_EQ(tasks[0].measured, "steps, 40 episodes");
    EXPECT_EQ(tasks[0].maps, 2u);
    // All 40 episodes: 400 and 1200, so 800 with standard error 400 over the two maps.
    EXPECT_DOUBLE_EQ(entry.value.mean, 800.0);
    EXPECT_NEAR(entry.value.error, 400.0, 1e-9);
    EXPECT_DOUBLE_EQ(entry.touches, (400.0 * 5.0 + 1200.0 * 15.0) / 1600.0);
    EXPECT_DOUBLE_EQ(entry.late_steps, 20.0);
    EXPECT_DOUBLE_EQ(*tasks[0].optimal_steps, 30.0);
    EXPECT_EQ(entry.cut, 2u);
    EXPECT_EQ(entry.episodes, 800u);
}

TEST(AdaptiveTasks, RatiosBelowOneAreBetterWhateverIsMeasured) {
    Json low = learner("low", 600.0);
    Json high = learner("high", 600.0);
    for (Json* one : {&low, &high}) {
        const double reward = one == &low ? 100.0 : 200.0;
        (*one)["cumulative_reward"] = {{{"step", 1000}, {"mean", 1.0}, {"se", 1.0}},
                                       {{"step", 3000}, {"mean", reward}, {"se", 3.0}}};
    }
    const auto rewarded = adaptive_tasks({run_of({phase("blocking-maze", {low, high})})});
    ASSERT_EQ(rewarded.size(), 1u);
    EXPECT_EQ(rewarded[0].best(any)->learner, "high");
    EXPECT_EQ(rewarded[0].better(rewarded[0].entries[1], rewarded[0].entries[0]).ratio, 0.5);
    EXPECT_EQ(rewarded[0].better(rewarded[0].entries[1], rewarded[0].entries[0]).verdict, Verdict::holds);
    EXPECT_TRUE(contains(rewarded[0].measured, "by step 3000"));

    for (Json* one : {&low, &high}) (*one)["cumulative_reward"] = Json::array();
    low["late_return"]["mean"] = -40.0;
    high["late_return"]["mean"] = -20.0;
    const auto paid = adaptive_tasks({run_of({phase("cliff", {low, high})})});
    ASSERT_EQ(paid.size(), 2u);
    EXPECT_EQ(paid[0].measure, TaskMeasure::first_steps);
    EXPECT_EQ(paid[1].measure, TaskMeasure::late_return);
    EXPECT_EQ(paid[1].best(any)->learner, "high");
    EXPECT_EQ(paid[1].better(paid[1].entries[1], paid[1].entries[0]).ratio, 0.5);
}

TEST(AdaptiveResults, ThePage) {
    const RecordedRun grid =
        run_of({phase("open64", {learner("q", 900.0), learner("ps", 600.0), learner("adaptive", 450.0)}),
                phase("soft54", {learner("q", 300.0), learner("ps", 700.0), learner("adaptive", 330.0)})},
               {{"maps", {"open64", "soft54"}}, {"seeds", 10}});
    const RecordedRun tuned = run_of({phase("open64", {learner("ps", 500.0)})}, {{"set", {"ps.cap=5"}}});
    const RecordedRun alone = run_of({phase("chain", {learner("adaptive", 5.0)})});  // nothing to compare with
    const std::string page = adaptive_results({grid, tuned, alone});
    for (const char* part :
         {"better on 1 of 2 measurements, level on 0 (a difference below 2 standard errors) and worse on 1.",
          // 450 / 500, the error from 3 / 450 and 3 / 500; 450 / 30 / 10 late steps.
          "| open64 | steps, 30 episodes | `ps` with cap=5 | 500 \u00b1 3 | 450 \u00b1 3 | 0.90 \u00b1 0.01 | better | "
          "5.0 "
          "| 1.50 |",
          "| soft54, after open64 | steps, 30 episodes | `q` | 300 \u00b1 3 | 330 \u00b1 3 | 1.10 \u00b1 0.01 | worse "
          "|",
          // Among the usual parameters: q 900 / 450 and 1, their geometric mean the square root of 2.
          "| `q` | open64 (steps, 30 episodes) | 2.00 | 1.41 | 2 |",
          "| `adaptive` | soft54, after open64 (steps, 30 episodes) | 1.10 | 1.05 | 2 |",
          "| open64 | 900 \u00b1 3 | 600 \u00b1 3 | **450 \u00b1 3** | `ps` with cap=5: 500 \u00b1 3 |",
          "They count the steps made; there were none", "grid_experiment --maps open64,soft54 --seeds 10\n"}) {
        EXPECT_TRUE(contains(page, part)) << part << "\n" << page;
    }
    EXPECT_FALSE(contains(page, "| chain |"));
    EXPECT_FALSE(contains(page, "nan"));
    EXPECT_EQ(page, adaptive_results({grid, tuned, alone}));
}

TEST(AdaptiveResults, NothingToCompareIsAnError) {
    EXPECT_THROW(static_cast<void>(adaptive_results({})), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(adaptive_results({run_of({phase("open64", {learner("q", 1.0)})})})),
                 std::invalid_argument);
}

}  // namespace
}  // namespace sspql::report
