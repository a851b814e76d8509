// SPDX-License-Identifier: MIT
#include "shards/run_fields.hpp"

#include <algorithm>

namespace sspql::shards {

namespace {

bool flag_of(char c) {
    if (c != '0' && c != '1') throw FieldError("has episode flags that are neither 0 nor 1");
    return c == '1';
}

}  // namespace

RunColumns columns_of(const report::SeedRun& run) {
    const auto& [seed, episodes, reward_at, steps, model_operations, learning_ns] = run;
    RunColumns columns;
    columns.seed = seed;
    columns.steps.reserve(episodes.size());
    columns.returns.reserve(episodes.size());
    for (const report::EpisodeRecord& episode : episodes) {
        const auto& [episode_steps, total_reward, success, capped] = episode;
        columns.steps.push_back(episode_steps);
        columns.returns.push_back(total_reward);
        columns.success += success ? '1' : '0';
        columns.capped += capped ? '1' : '0';
    }
    columns.reward_at = reward_at;
    columns.total_steps = steps;
    columns.model_operations = model_operations;
    columns.learning_ns = learning_ns;
    return columns;
}

report::SeedRun run_of(const RunColumns& columns) {
    const std::size_t episodes = columns.steps.size();
    if (columns.returns.size() != episodes || columns.success.size() != episodes || columns.capped.size() != episodes) {
        throw FieldError("has lists of different lengths");
    }
    report::SeedRun run;
    run.seed = columns.seed;
    run.episodes.reserve(episodes);
    for (std::size_t i = 0; i < episodes; ++i) {
        run.episodes.push_back(
            {columns.steps[i], columns.returns[i], flag_of(columns.success[i]), flag_of(columns.capped[i])});
    }
    run.reward_at = columns.reward_at;
    run.steps = columns.total_steps;
    run.model_operations = columns.model_operations;
    run.learning_ns = columns.learning_ns;
    return run;
}

Json written_runs(const std::vector<report::SeedRun>& runs, const Shard& shard) {
    Json array = Json::array();
    for (std::size_t j = 0; j < shard.share(runs.size()); ++j)
        array.push_back(written(columns_of(runs[shard.unit(j)])));
    return array;
}

void read_runs(const Json& json, const Shard& shard, std::vector<report::SeedRun>& runs) {
    read_elements(json, shard.share(runs.size()), [&](std::size_t j, const Json& one) {
        RunColumns columns;
        read(one, columns);
        runs[shard.unit(j)] = run_of(columns);
    });
}

void write_settings(const std::vector<report::Setting>& settings, Json& head) {
    head["settings"] = Json::object();
    head["unquoted"] = Json::array();
    for (const auto& [key, value, quoted] : settings) {
        head["settings"][key] = value;
        if (!quoted) head["unquoted"].push_back(key);
    }
}

std::vector<report::Setting> read_settings(const Json& head) {
    const Json object = field<Json>(head, "settings");
    const auto unquoted = field<std::vector<std::string>>(head, "unquoted");
    std::vector<report::Setting> settings;
    for (const auto& item : object.items()) {
        const bool quoted = std::find(unquoted.begin(), unquoted.end(), item.key()) == unquoted.end();
        settings.push_back({item.key(), field<std::string>(object, item.key()), quoted});
    }
    return settings;
}

}  // namespace sspql::shards
