// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "fabricated_results.hpp"
#include "report/json_report.hpp"

namespace sspql::report {
namespace {

using Json = nlohmann::ordered_json;
using Keys = std::vector<std::string>;

Keys keys_of(const Json& object) {
    Keys keys;
    for (auto item = object.begin(); item != object.end(); ++item) keys.push_back(item.key());
    return keys;
}

TEST(JsonReport, HasExactlyTheKeysOfTheContractInOrder) {
    const std::string text = json_report(four_learners());
    EXPECT_EQ(text.back(), '\n');
    const Json json = Json::parse(text);
    EXPECT_EQ(keys_of(json), (Keys{"experiment", "version", "settings", "phases", "timing"}));
    EXPECT_EQ(json["experiment"], "pusher_experiment");
    EXPECT_EQ(json["version"], "0.1.0");
    EXPECT_EQ(json["settings"], (Json{{"task", "approach"}, {"seeds", 2}, {"noise", 0.5}}));
    const Json& phase = json["phases"][0];
    EXPECT_EQ(keys_of(phase), (Keys{"name", "optimal_steps", "optimal_return", "learners"}));
    EXPECT_TRUE(phase["optimal_steps"].is_null());
    const Json& learner = phase["learners"][3];
    EXPECT_EQ(keys_of(learner),
              (Keys{"name", "seeds", "episodes", "total_steps", "first5_steps", "first30_steps", "late_steps",
                    "late_return", "mean_return", "success_rate", "late_success_rate", "capped_episodes",
                    "model_ops_per_step", "curve", "cumulative_reward", "per_seed"}));
    for (const char* key : {"total_steps", "first5_steps", "first30_steps"}) {
        EXPECT_EQ(keys_of(learner[key]), (Keys{"mean", "se", "sd"})) << key;
    }
    for (const char* key : {"late_steps", "late_return", "mean_return"}) {
        EXPECT_EQ(keys_of(learner[key]), (Keys{"mean", "se"})) << key;
    }
    EXPECT_EQ(keys_of(learner["curve"]), (Keys{"mean", "sd"}));
    EXPECT_EQ(keys_of(learner["per_seed"]), (Keys{"total_steps", "first5_steps", "first30_steps", "late_steps"}));
    EXPECT_EQ(keys_of(json["timing"]), (Keys{"q", "ssp", "sspql", "sspql-bonus"}));
    EXPECT_EQ(json["timing"]["q"], (Json{{"learn_ns_per_step", 100.0}}));
}

TEST(JsonReport, NumbersComeThrough) {
    ExperimentResults results = four_learners();
    results.phases[0].optimal_steps = 12.5;
    const Json json = Json::parse(json_report(results));
    EXPECT_EQ(json["phases"][0]["optimal_steps"], 12.5);
    const Json& q = json["phases"][0]["learners"][0];
    EXPECT_EQ(q["seeds"], 2);
    EXPECT_EQ(q["episodes"], 30);
    EXPECT_EQ(q["total_steps"]["mean"], 6015.0);  // 6000 and 6030
    EXPECT_EQ(q["total_steps"]["se"], 15.0);
    EXPECT_EQ(q["late_steps"]["mean"], 200.5);
    EXPECT_EQ(q["late_steps"]["se"], 0.5);
    EXPECT_EQ(q["per_seed"]["total_steps"], (Json::array({6000, 6030})));
    EXPECT_TRUE(q["per_seed"]["total_steps"][0].is_number_integer());
    EXPECT_EQ(q["curve"]["mean"].size(), 30u);
    EXPECT_EQ(q["success_rate"], 1.0);
    EXPECT_EQ(q["cumulative_reward"], Json::array());
}

TEST(JsonReport, OneSeedHasNoStandardError) {
    const Json json = Json::parse(json_report(results_of({{"q", {run_of(1, {3, 4})}}})));
    const Json& learner = json["phases"][0]["learners"][0];
    for (const char* key :
         {"total_steps", "first5_steps", "first30_steps", "late_steps", "late_return", "mean_return"}) {
        EXPECT_TRUE(learner[key]["se"].is_null()) << key;
        EXPECT_TRUE(learner[key]["mean"].is_number()) << key;
    }
}

TEST(JsonReport, CumulativeRewardByStep) {
    ExperimentResults results = results_of({{"q", {run_of(1, {3})}}});
    results.phases[0].report_at = {1000};
    results.phases[0].learners[0].runs[0].reward_at = {2.0};
    const Json json = Json::parse(json_report(results));
    EXPECT_EQ(json["phases"][0]["learners"][0]["cumulative_reward"],
              (Json::array({{{"step", 1000}, {"mean", 2.0}, {"se", nullptr}}})));
}

TEST(JsonReport, NotANumberIsNull) {
    ExperimentResults results = results_of({{"q", {run_of(1, {})}}});
    results.phases[0].optimal_return = std::numeric_limits<double>::infinity();
    const Json json = Json::parse(json_report(results));
    const Json& learner = json["phases"][0]["learners"][0];
    EXPECT_TRUE(learner["success_rate"].is_null());
    EXPECT_TRUE(learner["late_steps"]["mean"].is_null());
    EXPECT_TRUE(json["phases"][0]["optimal_return"].is_null());
    EXPECT_TRUE(json["timing"]["q"]["learn_ns_per_step"].is_null());
}

TEST(JsonReport, OnlyTimingDiffersBetweenRuns) {
    ExperimentResults again = four_learners();
    again.phases[0].learners[0].runs[0].learning_ns *= 3.0;
    again.manifest.command = "pusher_experiment --threads 2 --json elsewhere.json";
    const std::string first = json_report(four_learners());
    const std::string second = json_report(again);
    const std::size_t timing = first.find("\"timing\"");
    ASSERT_NE(timing, std::string::npos);
    EXPECT_EQ(first.substr(0, timing), second.substr(0, timing));
    EXPECT_NE(first, second);
}

TEST(JsonReport, TimingIsOverAllPhases) {
    ExperimentResults results = results_of({{"q", {run_of(1, {10})}}});
    results.phases.push_back(results.phases[0]);
    results.phases[1].learners[0].runs[0].learning_ns = 3000.0;  // 300 ns a step after 100 ns a step
    EXPECT_EQ(Json::parse(json_report(results))["timing"]["q"]["learn_ns_per_step"], 200.0);
}

TEST(JsonReport, SettingsKeepTheirKind) {
    ExperimentResults results = four_learners();
    results.settings = {{"maps", "a \"b\" \xff", true}, {"report_at", "[1000,3000]", false}, {"belief", "true", false}};
    const Json json = Json::parse(json_report(results));
    EXPECT_EQ(json["settings"]["maps"], "a \"b\" \xEF\xBF\xBD");
    EXPECT_EQ(json["settings"]["report_at"], (Json::array({1000, 3000})));
    EXPECT_EQ(json["settings"]["belief"], true);
    results.settings = {{"noise", "half", false}};
    EXPECT_THROW(static_cast<void>(json_report(results)), std::invalid_argument);
}

}  // namespace
}  // namespace sspql::report
