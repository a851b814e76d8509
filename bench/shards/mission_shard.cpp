// SPDX-License-Identifier: MIT
#include "shards/mission_shard.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "shards/mission_fields.hpp"

namespace sspql::shards {

namespace {

/// The first `count` missions that the shard's robots do, in order.
std::vector<std::size_t> missions_of(const report::MissionResults& results, const Shard& shard, std::size_t count) {
    std::vector<std::size_t> missions;
    for (std::size_t k = 0; k < count; ++k) {
        if (shard.has(k % results.approach_training.size())) missions.push_back(k);
    }
    return missions;
}

template <class T>
Json written_missions(const report::MissionResults& results, const Shard& shard, const std::vector<T>& all) {
    Json array = Json::array();
    for (const std::size_t k : missions_of(results, shard, all.size())) array.push_back(written(all[k]));
    return array;
}

template <class T>
void read_missions(const Json& part, const std::string& name, const report::MissionResults& results, const Shard& shard,
                   std::vector<T>& all) {
    const std::vector<std::size_t> missions = missions_of(results, shard, all.size());
    read_elements(part, name, missions.size(), [&](std::size_t j, const Json& one) { read(one, all[missions[j]]); });
}

void read_runs(const Json& part, const std::string& name, const Shard& shard, std::vector<report::SeedRun>& runs) {
    const Json& json = member(part, name);
    try {
        shards::read_runs(json, shard, runs);
    } catch (const FieldError& error) {
        throw error.within(name);
    }
}

}  // namespace

Json head_of(const report::MissionFindings& findings) {
    const report::MissionResults& results = findings.results;
    Json head = Json::object();
    write_settings(results.settings, head);
    head["learner"] = results.learner;
    head["missions"] = results.missions.size();
    head["robots"] = results.approach_training.size();
    head["replays"] = results.replays.size();
    head["curves"] = Json::array();
    head["curve_seeds"] = 0;
    for (const report::LearnerRuns& curve : results.curves) {
        head["curves"].push_back(curve.name);
        head["curve_seeds"] = curve.runs.size();
    }
    head["stage"] = written(findings.stage);
    return head;
}

void set_head(const Json& head, report::MissionFindings& findings) {
    report::MissionResults results;
    results.settings = read_settings(head);
    read_field(head, "learner", results.learner);
    results.missions.resize(field<std::size_t>(head, "missions"));
    const auto robots = field<std::size_t>(head, "robots");
    if (robots == 0) throw FieldError("must not be 0", "robots");
    results.approach_training.resize(robots);
    results.turn_training.resize(robots);
    results.replays.resize(field<std::size_t>(head, "replays"));
    const auto seeds = field<std::size_t>(head, "curve_seeds");
    for (const std::string& name : field<std::vector<std::string>>(head, "curves")) {
        results.curves.push_back({name, std::vector<report::SeedRun>(seeds)});
    }
    findings.results = std::move(results);
    read_field(head, "stage", findings.stage);
}

Json part_of(const report::MissionFindings& findings, const Shard& shard) {
    const report::MissionResults& results = findings.results;
    Json part = Json::object();
    part["missions"] = written_missions(results, shard, results.missions);
    part["replays"] = written_missions(results, shard, results.replays);
    part["approach_training"] = written_runs(results.approach_training, shard);
    part["turn_training"] = written_runs(results.turn_training, shard);
    part["curves"] = Json::array();
    for (const report::LearnerRuns& curve : results.curves) part["curves"].push_back(written_runs(curve.runs, shard));
    if (shard.has(0)) part["map"] = written(results.map);
    return part;
}

void add_part(const Json& part, const Shard& shard, report::MissionFindings& findings) {
    report::MissionResults& results = findings.results;
    read_missions(part, "missions", results, shard, results.missions);
    read_missions(part, "replays", results, shard, results.replays);
    read_runs(part, "approach_training", shard, results.approach_training);
    read_runs(part, "turn_training", shard, results.turn_training);
    read_elements(part, "curves", results.curves.size(),
                  [&](std::size_t i, const Json& runs) { shards::read_runs(runs, shard, results.curves[i].runs); });
    if (shard.has(0)) read_field(part, "map", results.map);
}

}  // namespace sspql::shards
