// SPDX-License-Identifier: MIT
#include "report/recorded_run.hpp"

#include <limits>
#include <sstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include <sspql/core/line_reader.hpp>

#include "report/paper_reference.hpp"

namespace sspql::report {

namespace {

using Json = nlohmann::ordered_json;

double number(const Json& value) {
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

/// {"mean", "se"} with perhaps "sd".
Summary summary_of(const Json& value, std::size_t seeds) {
    Summary result;
    result.mean = number(value.at("mean"));
    if (value.at("mean").is_null()) return result;
    const bool varies = !value.at("se").is_null();
    result.count = varies ? seeds : 1;
    result.error = varies ? number(value.at("se")) : 0.0;
    if (value.contains("sd") && !value.at("sd").is_null()) result.deviation = number(value.at("sd"));
    return result;
}

std::vector<double> numbers(const Json& values) {
    std::vector<double> result;
    result.reserve(values.size());
    for (const Json& value : values) result.push_back(number(value));
    return result;
}

LearnerStatistics learner_of(const Json& value, const Json& timing) {
    LearnerStatistics result;
    result.name = value.at("name").get<std::string>();
    result.seeds = value.at("seeds").get<std::size_t>();
    result.episodes = value.at("episodes").get<std::size_t>();
    const auto read = [&](const char* key) { return summary_of(value.at(key), result.seeds); };
    result.total_steps = read("total_steps");
    result.first5_steps = read("first5_steps");
    result.first30_steps = read("first30_steps");
    result.late_steps = read("late_steps");
    result.late_return = read("late_return");
    result.mean_return = read("mean_return");
    result.success_rate = number(value.at("success_rate"));
    result.late_success_rate = number(value.at("late_success_rate"));
    result.capped_episodes = value.at("capped_episodes").get<std::uint64_t>();
    result.model_ops_per_step = number(value.at("model_ops_per_step"));
    result.curve.mean = numbers(value.at("curve").at("mean"));
    result.curve.deviation = numbers(value.at("curve").at("sd"));
    if (result.curve.mean.size() != result.episodes || result.curve.deviation.size() != result.episodes) {
        throw std::runtime_error("the curve of " + result.name + " does not have its " +
                                 std::to_string(result.episodes) + " episodes");
    }
    for (const Json& point : value.at("cumulative_reward")) {
        result.cumulative_reward.push_back({point.at("step").get<std::uint64_t>(), summary_of(point, result.seeds)});
    }
    if (!result.curve.mean.empty()) {
        result.first_episode = {result.seeds, result.curve.mean.front(), result.curve.deviation.front(), 0.0};
    }
    result.learn_ns_per_step = timing.contains(result.name) ? number(timing.at(result.name).at("learn_ns_per_step"))
                                                            : std::numeric_limits<double>::quiet_NaN();
    return result;
}

RecordedRun run_of(const Json& json) {
    RecordedRun run;
    run.experiment = json.at("experiment").get<std::string>();
    if (run.experiment != "grid_experiment" && run.experiment != "pusher_experiment") {
        throw std::runtime_error("a report of " + run.experiment + ", not of grid_experiment or pusher_experiment");
    }
    run.version = json.at("version").get<std::string>();
    for (const auto& [key, value] : json.at("settings").items()) run.settings.emplace_back(key, value.dump());
    const Json timing = json.value("timing", Json::object());
    for (const Json& value : json.at("phases")) {
        RecordedPhase phase;
        phase.name = value.at("name").get<std::string>();
        if (!value.at("optimal_steps").is_null()) phase.optimal_steps = number(value.at("optimal_steps"));
        for (const Json& entry : value.at("learners")) phase.learners.push_back(learner_of(entry, timing));
        run.phases.push_back(std::move(phase));
    }
    return run;
}

/// As a shell takes it.
std::string shell_word(const std::string& word) {
    const bool plain = !word.empty() && word.find_first_not_of(
                                            "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                            "0123456789_-+=./,:@%") == std::string::npos;
    if (plain) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string text_of(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

/// " --key value", as often as needed; nothing for what was not given.
std::string option_text(const std::string& key, const Json& value) {
    std::string name = " --" + key;
    for (char& c : name) c = c == '_' ? '-' : c;
    if (value.is_null() || value == "" || (key == "total_steps" && value == 0)) return {};
    if (!value.is_array()) return name + " " + shell_word(text_of(value));
    std::string text;
    for (const Json& element : value) {
        if (key == "set") {
            text += name + " " + shell_word(text_of(element));
        } else {
            text += (text.empty() ? "" : ",") + text_of(element);
        }
    }
    return key == "set" || text.empty() ? text : name + " " + shell_word(text);
}

}  // namespace

const LearnerStatistics* RecordedPhase::find(std::string_view learner) const noexcept {
    return find_learner(learners, learner);
}

std::string RecordedRun::setting(std::string_view key) const {
    for (const auto& [name, value] : settings) {
        if (name == key && value != "null") return text_of(Json::parse(value));
    }
    return {};
}

std::string RecordedRun::command() const {
    std::string text = experiment;
    for (const auto& [key, value] : settings) text += option_text(key, Json::parse(value));
    // Not among the settings: they follow from the results.
    for (const RecordedPhase& phase : phases) {
        if (phase.learners.empty() || phase.learners.front().cumulative_reward.empty()) continue;
        std::string steps;
        for (const RewardPoint& point : phase.learners.front().cumulative_reward) {
            steps += (steps.empty() ? "" : ",") + std::to_string(point.step);
        }
        if (setting("report_at").empty()) text += " --report-at " + steps;
        break;
    }
    return text;
}

RecordedRun parse_recorded_run(const std::string& text, const std::string& path) {
    try {
        RecordedRun run = run_of(Json::parse(text));
        run.file = path.substr(path.find_last_of('/') + 1);
        return run;
    } catch (const nlohmann::json::exception& error) {
        const std::string what = error.what();  // "[json.exception.out_of_range.403] key 'phases' not found"
        const std::size_t bracket = what.find("] ");
        throw std::runtime_error(path + ": not a report of grid_experiment or pusher_experiment: " +
                                 (bracket == std::string::npos ? what : what.substr(bracket + 2)));
    } catch (const std::exception& error) {
        throw std::runtime_error(path + ": " + error.what());
    }
}

RecordedRun load_recorded_run(const std::string& path) {
    std::ifstream file = open_text(path);
    std::ostringstream text;
    text << file.rdbuf();
    return parse_recorded_run(text.str(), path);
}

std::string_view family_of(std::string_view learner) noexcept { return learner.substr(0, learner.find(':')); }

}  // namespace sspql::report
