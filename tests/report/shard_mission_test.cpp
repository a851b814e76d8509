// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/shard_testing.hpp"
#include "shards/merge.hpp"

namespace sspql::shards {
namespace {

/// Numbers no two of which are the same.
class Numbers {
public:
    double real() { return ++count_ / 3.0; }
    int whole() { return static_cast<int>(++count_); }
    std::string word() { return "word " + std::to_string(whole()); }
    bool flag() { return whole() % 3 == 0; }
    report::ArenaPose pose() {
        const double x = real();
        const double y = real();
        return {x, y, real()};
    }

private:
    double count_ = 0.0;
};

report::ReplayMoment moment_of(Numbers& next) {
    report::ReplayMoment moment;
    moment.task = next.whole();
    moment.attempt = next.whole();
    moment.robot = next.pose();
    moment.box = next.pose();
    moment.odometry = next.pose();
    if (next.flag()) moment.box_belief = {next.real(), 2.0, next.real()};
    if (next.flag()) moment.goal_belief = {1.0, next.real(), 3.0};
    moment.box_seen = next.flag();
    moment.goal_seen = next.flag();
    for (double& sonar : moment.sonars_m) sonar = next.real();
    moment.seconds = next.real();
    moment.command = next.whole();
    moment.amount = next.real();
    moment.state = next.whole();
    moment.action = next.whole();
    moment.to_go = next.real();
    for (int a = next.whole() % 4; a > 0; --a)
        moment.terms.push_back({next.real(), 5e-324, -0.0, next.real(), next.whole(), next.real()});
    return moment;
}

/// Seven missions by three robots, five of them recorded, two curves of two seeds.
report::MissionFindings mission_findings() {
    Numbers next;
    report::MissionFindings findings;
    report::MissionResults& results = findings.results;
    results.settings = {{"learner", "q"}, {"missions", "7", false}};
    results.manifest = {"", "", "g++ 12.2.0"};
    results.learner = "q";
    for (int k = 0; k < 7; ++k) {
        report::MissionRecord record;
        record.in_goal = next.flag();
        record.first_push = next.flag();
        record.believed = next.flag();
        record.cornered = next.flag();
        record.end = next.word();
        for (int i = 0; i < k; ++i) record.failed_ends.push_back(next.word());
        for (report::TaskTally& tally : record.tasks) tally = {next.whole(), -next.whole(), next.whole()};
        record.driven_s = next.real();
        results.missions.push_back(record);
    }
    for (std::uint64_t r = 0; r < 3; ++r) {
        results.approach_training.push_back(awkward_run(10 + r));
        results.turn_training.push_back(awkward_run(20 + r));
    }
    results.curves = {{"one", {awkward_run(30), awkward_run(31)}}, {"other", {awkward_run(40), awkward_run(41)}}};
    results.map = {{-1, 3, 2}, {"ahead", "back"}};
    for (std::size_t k = 0; k < 5; ++k) {
        report::MissionReplay replay{k + 1, next.word(), next.flag(), next.flag(), next.flag(), next.pose(), {}};
        for (std::size_t i = 0; i <= 3 * k; ++i) replay.moments.push_back(moment_of(next));
        results.replays.push_back(replay);
    }
    findings.stage.half_width_m = next.real();
    findings.stage.robot_length_m = next.real();
    findings.stage.robot_width_m = next.real();
    findings.stage.box_side_m = next.real();
    findings.stage.goal_radius_m = next.real();
    findings.stage.camera_field_rad = next.real();
    findings.stage.sonar_offsets_m = {next.real(), next.real()};
    findings.stage.approach_actions = {next.word()};
    findings.stage.turn_actions = {next.word(), next.word()};
    return findings;
}

report::MissionFindings merged(const report::MissionFindings& findings, std::size_t count) {
    Merge<report::MissionFindings> merge;
    for (std::size_t i = count; i-- > 0;) {
        const ShardContent content = content_of("pusher_mission", findings, {i, count}, "the command");
        merge.add(parse_shard_text(shard_text(content), "s"), "s" + std::to_string(i));
    }
    return merge.take();
}

using Text = std::vector<std::string>;

template <class T>
void add(Text& text, const T& value) {
    text.push_back(std::to_string(value));
}
void add(Text& text, const std::string& value) { text.push_back(value); }
void add(Text& text, double value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    text.emplace_back(bytes, sizeof value);
}
void add(Text& text, const report::ArenaPose& pose) {
    for (const double value : {pose.x_m, pose.y_m, pose.heading_rad}) add(text, value);
}
void add(Text& text, const std::optional<report::ReplayBelief>& belief) {
    add(text, belief.has_value());
    if (!belief) return;
    for (const double value : {belief->x_m, belief->y_m, belief->deviation_m}) add(text, value);
}

/// Everything, in one list.
Text all_of(const report::MissionFindings& findings) {
    Text text;
    const report::MissionResults& r = findings.results;
    for (const report::Setting& s : r.settings) text.insert(text.end(), {s.key, s.value, s.quoted ? "text" : "JSON"});
    text.push_back(r.learner);
    for (const report::MissionRecord& m : r.missions) {
        for (const bool flag : {m.in_goal, m.first_push, m.believed, m.cornered}) add(text, flag);
        add(text, m.end);
        for (const std::string& end : m.failed_ends) add(text, end);
        for (const report::TaskTally& t : m.tasks) {
            for (const int number : {t.attempts, t.successes, t.actions}) add(text, number);
        }
        add(text, m.driven_s);
    }
    for (const int action : r.map.best) add(text, action);
    for (const std::string& name : r.map.actions) add(text, name);
    for (const report::MissionReplay& replay : r.replays) {
        add(text, replay.number);
        add(text, replay.outcome);
        add(text, replay.in_goal);
        add(text, replay.first_push);
        add(text, replay.to_go_in_steps);
        add(text, replay.goal);
        for (const report::ReplayMoment& m : replay.moments) {
            for (const int number : {m.task, m.attempt, m.command, m.state, m.action}) add(text, number);
            for (const report::ArenaPose& pose : {m.robot, m.box, m.odometry}) add(text, pose);
            add(text, m.box_belief);
            add(text, m.goal_belief);
            add(text, m.box_seen);
            add(text, m.goal_seen);
            for (const double sonar : m.sonars_m) add(text, sonar);
            add(text, m.seconds);
            add(text, m.amount);
            add(text, m.to_go);
            for (const report::ReplayTerms& t : m.terms) {
                for (const double term : {t.q, t.ssp, t.exploration, t.tries, t.to_go}) add(text, term);
                add(text, t.next);
            }
        }
    }
    const report::ReplayStage& s = findings.stage;
    for (const double length : {s.half_width_m, s.robot_length_m, s.robot_width_m, s.box_side_m, s.goal_radius_m,
                                s.camera_field_rad, s.sonar_offsets_m.at(0), s.sonar_offsets_m.at(1)}) {
        add(text, length);
    }
    for (const Text& names : {s.approach_actions, s.turn_actions}) text.insert(text.end(), names.begin(), names.end());
    return text;
}

TEST(ShardMerge, OfMissionsKeepsEveryField) {
    const report::MissionFindings original = mission_findings();
    for (std::size_t count = 1; count <= 5; ++count) {
        const report::MissionFindings again = merged(original, count);
        EXPECT_TRUE(all_of(again) == all_of(original)) << count << " shards";
        const auto seeds_of = [](const report::MissionResults& results) {
            std::vector<std::pair<std::string, std::uint64_t>> seeds;
            for (const report::SeedRun& run : results.approach_training) seeds.push_back({"approach", run.seed});
            for (const report::SeedRun& run : results.turn_training) seeds.push_back({"turn", run.seed});
            for (const report::LearnerRuns& curve : results.curves) {
                for (const report::SeedRun& run : curve.runs) seeds.push_back({curve.name, run.seed});
            }
            return seeds;
        };
        EXPECT_EQ(seeds_of(again.results), seeds_of(original.results)) << count << " shards";
    }
}

}  // namespace
}  // namespace sspql::shards
