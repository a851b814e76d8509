// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "report/mission_map.hpp"
#include "report/mission_page.hpp"
#include "report/mission_player.hpp"
#include "report/mission_results.hpp"

namespace sspql::report {
namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

MissionRecord delivered(int pushes) {
    MissionRecord record;
    record.in_goal = record.believed = true;
    record.first_push = pushes == 1;
    record.end = "success";
    for (TaskTally& task : record.tasks) task = {pushes, pushes, 10 * pushes};
    record.tasks[3].successes = 1;
    for (int i = 1; i < pushes; ++i) record.failed_ends.push_back("push: no progress");
    return record;
}

MissionRecord given_up() {
    MissionRecord record;
    record.end = "search: box or goal not found in time";
    record.tasks[0] = {9, 0, 720};
    record.failed_ends.assign(9, record.end);
    return record;
}

/// Two at the first push, one at the second, one never, one only believed.
MissionResults five_missions() {
    MissionResults results;
    results.learner = "q<1>";
    results.manifest = {"pusher_mission --missions 5", "1.2.3", "a compiler"};
    results.settings = {{"learner", "q<1>"}, {"missions", "5", false}};
    results.missions = {delivered(1), delivered(1), delivered(2), given_up(), delivered(1)};
    results.missions[4].in_goal = results.missions[4].first_push = false;
    return results;
}

ReplayMoment moment_of(int task) {
    ReplayMoment moment;
    moment.task = task;
    moment.robot = {-1.0, 0.5, 0.25};
    moment.box = {0.25, 0.0, 0.0};
    moment.box_belief = ReplayBelief{0.26, 0.01, 0.02};
    moment.box_seen = true;
    moment.sonars_m.fill(1.234);
    moment.seconds = 0.85;
    moment.command = 0;
    moment.amount = 0.3;
    return moment;
}

MissionReplay replay() {
    MissionReplay replay;
    replay.number = 7;
    replay.outcome = "given up: </script><b>";
    replay.goal = {1.5, -0.5, 0.0};
    replay.moments = {moment_of(0), moment_of(1), moment_of(3)};
    replay.moments[1].state = 42;
    replay.moments[1].action = 1;
    replay.moments[1].to_go = 3.25;
    replay.moments[1].terms = {{0.5, 0.25, 0.1, 3.0, 17, 2.5}, {0.75, 0.0, 0.05, 12.0}};
    return replay;
}

TEST(MissionRates, ValueAndErrorByHand) {
    const Rate rate = rate_of(3, 4);
    EXPECT_EQ(rate.value, 0.75);
    EXPECT_NEAR(rate.error, std::sqrt(4.0 / 6.0 * 2.0 / 6.0 / 6.0), 1e-12);
    EXPECT_GT(rate_of(300, 300).error, 0.003);  // never certain
    EXPECT_LT(rate_of(300, 300).error, 0.004);
    EXPECT_TRUE(std::isnan(rate_of(0, 0).value));
    EXPECT_EQ(rate_text(rate_of(0, 0)), "n/a");
    EXPECT_EQ(rate_text(rate_of(0, 98)), "0.0 \u00B1 1.0 %");
}

TEST(MissionStatistics, CountsMissionsAttemptsAndReasons) {
    const MissionStatistics statistics = statistics_of(five_missions().missions);
    EXPECT_EQ(statistics.in_goal.count, 3u);
    EXPECT_EQ(statistics.first_push.count, 2u);
    EXPECT_EQ(statistics.mistaken, 1u);
    EXPECT_EQ(statistics.tasks[3].success.count, 4u);
    EXPECT_EQ(statistics.tasks[3].success.of, 5u);
    EXPECT_EQ(statistics.tasks[0].success.of, 14u);
    EXPECT_EQ(statistics.pushes.mean, 1.0);
    ASSERT_EQ(statistics.failed_ends.size(), 2u);
    EXPECT_EQ(statistics.failed_ends[0].count, 9u);
    ASSERT_EQ(statistics.failures.size(), 2u);
    EXPECT_EQ(statistics_of(std::vector<MissionRecord>{}).missions, 0u);
}

TEST(MissionJson, HasTheContractsKeys) {
    const auto json = nlohmann::json::parse(mission_json(five_missions()));
    EXPECT_EQ(json["experiment"], "pusher_mission");
    EXPECT_EQ(json["version"], "1.2.3");
    EXPECT_EQ(json["missions"], 5);
    EXPECT_EQ(json["settings"]["missions"], 5);
    EXPECT_DOUBLE_EQ(json["in_goal_rate"].get<double>(), 0.6);
    EXPECT_DOUBLE_EQ(json["first_push_rate"].get<double>(), 0.4);
    for (const char* task : mission_task_names) {
        EXPECT_TRUE(json["subtasks"][task]["actions"].contains("mean")) << task;
        EXPECT_TRUE(json["subtasks"][task].contains("success_rate")) << task;
    }
    EXPECT_EQ(json["failures"]["search: box or goal not found in time"], 1);
    EXPECT_EQ(json["failures"].size(), 2u);
    EXPECT_FALSE(contains(json.dump(), "--missions"));  // the command stays out
}

TEST(MissionText, FitsATerminal) {
    const std::string text = mission_text(five_missions());
    EXPECT_TRUE(contains(text, "box in the goal        60.0 +- "));
    EXPECT_TRUE(contains(text, "     9  search: box or goal not found in time"));
    std::size_t begin = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
        EXPECT_LE(end - begin, 80u) << text.substr(begin, end - begin);
        begin = end + 1;
    }
}

TEST(ReplayJson, IsCompactWholeNumbersAndCannotEndTheScript) {
    const std::string text = replay_json(ReplayStage{}, {replay(), replay()});
    EXPECT_FALSE(contains(text, "<"));
    const auto json = nlohmann::json::parse(text);
    ASSERT_EQ(json["missions"].size(), 2u);
    EXPECT_EQ(json["missions"][0]["outcome"], "given up: </script><b>");
    EXPECT_EQ(json["missions"][0]["n"], 7);
    EXPECT_EQ(json["missions"][0]["unit"], "steps");
    const auto& first = json["missions"][0]["moments"][0];
    ASSERT_EQ(first.size(), 40u);
    EXPECT_EQ(first[2], -1000);
    EXPECT_EQ(first[4], 250);
    EXPECT_EQ(first[11], 260);
    EXPECT_EQ(first[16], -1);  // nothing is believed of the goal
    EXPECT_EQ(first[17], 1);
    EXPECT_EQ(first[18], 850);
    EXPECT_EQ(first[20], 300);
    EXPECT_EQ(first[21], -1);
    EXPECT_EQ(first[23], -1000);  // no way to a goal is known
    EXPECT_EQ(first[39], 123);
    const auto& choice = json["missions"][0]["moments"][1];
    ASSERT_EQ(choice.size(), 40u + 12u);
    EXPECT_EQ(choice[21], 42);
    EXPECT_EQ(choice[23], 3250);
    EXPECT_EQ(choice[41], 250);
    EXPECT_EQ(choice[44], 17);
    EXPECT_EQ(choice[45], 2500);
    EXPECT_EQ(choice[49], 12);
    EXPECT_EQ(choice[50], -1);  // never seen to lead anywhere
}

TEST(MissionMap, DrawsAWedgeForEveryKnownState) {
    LearntMap map;
    map.best.assign(432, LearntMap::unknown);
    map.actions = {"forward 0.3 m", "backward 0.2 m", "turn 30 deg", "turn -25 deg"};
    const auto wedges = [&] {
        const std::string text = mission_map(map).element();
        std::size_t count = 0;
        for (std::size_t at = text.find("<path"); at != std::string::npos; at = text.find("<path", at + 1)) ++count;
        return count;
    };
    const std::size_t empty = wedges();
    for (std::size_t s = 0; s < 24; ++s) map.best[s] = static_cast<int>(s % 4);  // sectors 0 and 1 of the inner ring
    EXPECT_EQ(wedges(), empty + 24);
    map.best[6 * 12] = 0;  // in A nothing is to be done
    EXPECT_EQ(wedges(), empty + 24);
    map.best.resize(10);
    EXPECT_THROW(static_cast<void>(mission_map(map)), std::invalid_argument);
}

TEST(MissionPage, IsOneFileWithThePlayerInIt) {
    MissionResults results = five_missions();
    results.replays = {replay()};
    results.map.best.assign(432, 2);
    results.map.actions = {"a", "b", "c", "d"};
    const std::string page = mission_page(results, ReplayStage{});
    for (const char* part : {"<canvas id=\"arena\"", "id=\"scrub\"", "id=\"play\"", "mission-data", "Watch 1 mission<",
                             "What failed, and why", "36 positions", "60.0", "q&lt;1&gt;"}) {
        EXPECT_TRUE(contains(page, part)) << part;
    }
    EXPECT_FALSE(contains(page, "q<1>"));
    EXPECT_FALSE(contains(page, "https://"));
    EXPECT_FALSE(contains(page, " src="));  // nothing to fetch
    std::size_t scripts = 0;
    for (std::size_t at = page.find("</script"); at != std::string::npos; at = page.find("</script", at + 1)) ++scripts;
    EXPECT_EQ(scripts, 2u);
    // Without replays there is no player, without data no empty section.
    const std::string bare = mission_page(five_missions(), ReplayStage{});
    EXPECT_FALSE(contains(bare, "<canvas"));
    EXPECT_FALSE(contains(bare, "36 positions"));
    EXPECT_FALSE(contains(bare, "Fig. 13"));
}

}  // namespace
}  // namespace sspql::report
