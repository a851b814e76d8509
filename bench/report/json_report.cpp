// SPDX-License-Identifier: MIT
#include "report/json_report.hpp"

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <nlohmann/json.hpp>

#include "report/learner_statistics.hpp"

namespace sspql::report {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json numbers(const std::vector<double>& values) {
    Json array = Json::array();
    for (const double value : values) array.push_back(number(value));
    return array;
}

/// Sums of steps: whole numbers without a point.
Json whole_numbers(const std::vector<double>& values) {
    Json array = Json::array();
    for (const double value : values) array.push_back(static_cast<std::uint64_t>(value));
    return array;
}

Json mean_and_error(const Summary& summary) {
    return {{"mean", summary.count > 0 ? number(summary.mean) : Json(nullptr)},
            {"se", summary.count > 1 ? number(summary.error) : Json(nullptr)}};
}

Json mean_error_deviation(const Summary& summary) {
    Json object = mean_and_error(summary);
    object["sd"] = summary.count > 0 ? number(summary.deviation) : Json(nullptr);
    return object;
}

Json optional_number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }

Json setting_value(const Setting& setting) {
    if (setting.quoted) return setting.value;
    Json value = Json::parse(setting.value, nullptr, false);
    if (value.is_discarded()) {
        throw std::invalid_argument("setting " + setting.key + " must be JSON, got " + setting.value);
    }
    return value;
}

Json settings_object(const std::vector<Setting>& settings) {
    Json object = Json::object();
    for (const Setting& setting : settings) object[setting.key] = setting_value(setting);
    return object;
}

Json learner_object(const LearnerStatistics& learner) {
    Json rewards = Json::array();
    for (const RewardPoint& point : learner.cumulative_reward) {
        Json object = {{"step", point.step}};
        object.update(mean_and_error(point.reward));
        rewards.push_back(object);
    }
    return {{"name", learner.name},
            {"seeds", learner.seeds},
            {"episodes", learner.episodes},
            {"total_steps", mean_error_deviation(learner.total_steps)},
            {"first5_steps", mean_error_deviation(learner.first5_steps)},
            {"first30_steps", mean_error_deviation(learner.first30_steps)},
            {"late_steps", mean_and_error(learner.late_steps)},
            {"late_return", mean_and_error(learner.late_return)},
            {"mean_return", mean_and_error(learner.mean_return)},
            {"success_rate", number(learner.success_rate)},
            {"late_success_rate", number(learner.late_success_rate)},
            {"capped_episodes", learner.capped_episodes},
            {"model_ops_per_step", number(learner.model_ops_per_step)},
            {"curve", {{"mean", numbers(learner.curve.mean)}, {"sd", numbers(learner.curve.deviation)}}},
            {"cumulative_reward", rewards},
            {"per_seed",
             {{"total_steps", whole_numbers(learner.total_steps_of)},
              {"first5_steps", whole_numbers(learner.first5_steps_of)},
              {"first30_steps", whole_numbers(learner.first30_steps_of)},
              {"late_steps", numbers(learner.late_steps_of)}}}};
}

Json phase_object(const PhaseRuns& phase) {
    Json learners = Json::array();
    for (const LearnerStatistics& learner : statistics_of(phase)) learners.push_back(learner_object(learner));
    return {{"name", phase.name},
            {"optimal_steps", optional_number(phase.optimal_steps)},
            {"optimal_return", optional_number(phase.optimal_return)},
            {"learners", learners}};
}

/// Nanoseconds in the learner per step, by learner's name, over all phases and seeds.
Json timing_object(const std::vector<PhaseRuns>& phases) {
    struct Clock {
        double nanoseconds = 0.0;
        double steps = 0.0;
    };
    std::vector<std::pair<std::string, Clock>> clocks;
    for (const PhaseRuns& phase : phases) {
        for (const LearnerRuns& learner : phase.learners) {
            std::size_t at = 0;
            while (at < clocks.size() && clocks[at].first != learner.name) ++at;
            if (at == clocks.size()) clocks.push_back({learner.name, {}});
            for (const SeedRun& run : learner.runs) {
                clocks[at].second.nanoseconds += run.learning_ns;
                clocks[at].second.steps += static_cast<double>(run.steps);
            }
        }
    }
    Json object = Json::object();
    for (const auto& [name, clock] : clocks) {
        object[name] = {{"learn_ns_per_step", number(clock.nanoseconds / clock.steps)}};
    }
    return object;
}

std::string inline_text(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// Scalars, arrays of scalars and small objects of scalars stand on one line.
bool fits_one_line(const Json& value) {
    if (!value.is_structured()) return true;
    if (value.is_object() && value.size() > 4) return false;
    for (const Json& element : value) {
        if (element.is_structured()) return false;
    }
    return true;
}

/// nlohmann's indented text puts every seed's number on a line of its own; here only nested values are broken up.
void write(std::string& out, const Json& value, std::size_t indent) {
    if (fits_one_line(value)) {
        out += inline_text(value);
        return;
    }
    const std::string margin(indent + 2, ' ');
    out += value.is_object() ? "{\n" : "[\n";
    bool first = true;
    for (auto item = value.begin(); item != value.end(); ++item) {
        if (!first) out += ",\n";
        first = false;
        out += margin;
        if (value.is_object()) out += inline_text(Json(item.key())) + ": ";
        write(out, *item, indent + 2);
    }
    out += "\n" + std::string(indent, ' ') + (value.is_object() ? "}" : "]");
}

}  // namespace

std::string json_report(const ExperimentResults& results) {
    Json phases = Json::array();
    for (const PhaseRuns& phase : results.phases) phases.push_back(phase_object(phase));
    const Json report = {{"experiment", results.experiment},
                         {"version", results.manifest.version},
                         {"settings", settings_object(results.settings)},
                         {"phases", phases},
                         {"timing", timing_object(results.phases)}};
    std::string out;
    write(out, report, 0);
    return out + "\n";
}

}  // namespace sspql::report
