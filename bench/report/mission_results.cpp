// SPDX-License-Identifier: MIT
#include "report/mission_results.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <nlohmann/json.hpp>

#include "report/numbers.hpp"

namespace sspql::report {

namespace {

using Json = nlohmann::ordered_json;

void count(std::vector<ReasonCount>& counts, const std::string& reason) {
    for (ReasonCount& known : counts) {
        if (known.reason == reason) {
            ++known.count;
            return;
        }
    }
    counts.push_back({reason, 1});
}

void sort(std::vector<ReasonCount>& counts) {
    std::sort(counts.begin(), counts.end(), [](const ReasonCount& a, const ReasonCount& b) {
        return a.count != b.count ? a.count > b.count : a.reason < b.reason;
    });
}

/// Why the box is not in the goal.
std::string failure_of(const MissionRecord& mission) {
    if (mission.cornered) return "the box was shoved to a wall: no room behind it";
    return mission.believed ? "believed to be delivered, but lies outside the goal" : mission.end;
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json counts_object(const std::vector<ReasonCount>& counts) {
    Json object = Json::object();
    for (const ReasonCount& reason : counts) object[reason.reason] = reason.count;
    return object;
}

std::string padded(const std::string& text, std::size_t width) {
    return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

std::string line(const char* name, const std::string& a, const std::string& b, const std::string& c,
                 const std::string& d) {
    std::string first = name;
    first.resize(std::max<std::size_t>(first.size(), 10), ' ');
    return first + padded(a, 10) + padded(b, 16) + padded(c, 10) + padded(d, 10) + "\n";
}

/// The terminal's letters.
std::string plain(std::string text) {
    const std::string sign = "\u00B1";
    for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign)) text.replace(at, 2, "+-");
    return text;
}

}  // namespace

Rate rate_of(std::size_t count, std::size_t of) {
    if (of == 0) return {count, of, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
    const double p = static_cast<double>(count) / static_cast<double>(of);
    const double q = (static_cast<double>(count) + 1.0) / (static_cast<double>(of) + 2.0);
    return {count, of, p, std::sqrt(q * (1.0 - q) / (static_cast<double>(of) + 2.0))};
}

std::string rate_text(const Rate& rate) {
    if (rate.of == 0) return "n/a";
    return fixed_text(100.0 * rate.value, 1) + " \u00B1 " + fixed_text(100.0 * rate.error, 1) + " %";
}

MissionStatistics statistics_of(const std::vector<MissionRecord>& missions) {
    MissionStatistics statistics;
    statistics.missions = missions.size();
    std::size_t in_goal = 0;
    std::size_t first_push = 0;
    std::vector<double> pushes;
    std::vector<double> driven;
    for (const MissionRecord& mission : missions) {
        in_goal += mission.in_goal ? 1 : 0;
        first_push += mission.first_push ? 1 : 0;
        statistics.mistaken += mission.believed && !mission.in_goal ? 1 : 0;
        pushes.push_back(mission.tasks[mission_tasks - 1].attempts);
        driven.push_back(mission.driven_s);
        if (!mission.in_goal) count(statistics.failures, failure_of(mission));
        for (const std::string& end : mission.failed_ends) count(statistics.failed_ends, end);
    }
    statistics.in_goal = rate_of(in_goal, missions.size());
    statistics.first_push = rate_of(first_push, missions.size());
    statistics.pushes = summarize(pushes);
    statistics.driven_s = summarize(driven);
    for (std::size_t t = 0; t < mission_tasks; ++t) {
        std::size_t attempts = 0;
        std::size_t successes = 0;
        std::vector<double> actions;
        for (const MissionRecord& mission : missions) {
            attempts += static_cast<std::size_t>(mission.tasks[t].attempts);
            successes += static_cast<std::size_t>(mission.tasks[t].successes);
            actions.push_back(mission.tasks[t].actions);
        }
        statistics.tasks[t] = {rate_of(successes, attempts), summarize(actions)};
    }
    sort(statistics.failures);
    sort(statistics.failed_ends);
    return statistics;
}

std::string mission_text(const MissionResults& results) {
    const MissionStatistics statistics = statistics_of(results.missions);
    std::string out = std::to_string(statistics.missions) + " missions, learner " + results.learner + "\n";
    out += "box in the goal        " + rate_text(statistics.in_goal) + "\n";
    out += "... at the first push  " + rate_text(statistics.first_push) + "\n\n";
    out += line("sub-task", "attempts", "succeeded", "actions", "sd");
    for (std::size_t t = 0; t < mission_tasks; ++t) {
        const TaskStatistics& task = statistics.tasks[t];
        out += line(mission_task_names[t], std::to_string(task.success.of), plain(rate_text(task.success)),
                    fixed_text(task.actions.mean, 1), fixed_text(task.actions.deviation, 1));
    }
    out += "\nattempts that failed:";
    if (statistics.failed_ends.empty()) out += " none";
    for (const ReasonCount& reason : statistics.failed_ends) {
        out += "\n" + padded(std::to_string(reason.count), 6) + "  " + reason.reason;
    }
    out += "\nmissions that failed:";
    if (statistics.failures.empty()) out += " none";
    for (const ReasonCount& reason : statistics.failures) {
        out += "\n" + padded(std::to_string(reason.count), 6) + "  " + reason.reason;
    }
    return plain(out + "\n");
}

std::string mission_json(const MissionResults& results) {
    const MissionStatistics statistics = statistics_of(results.missions);
    Json settings = Json::object();
    for (const Setting& setting : results.settings) {
        settings[setting.key] = setting.quoted ? Json(setting.value) : Json::parse(setting.value);
    }
    Json tasks = Json::object();
    for (std::size_t t = 0; t < mission_tasks; ++t) {
        const TaskStatistics& task = statistics.tasks[t];
        tasks[mission_task_names[t]] = {
            {"attempts", task.success.of},
            {"success_rate", number(task.success.value)},
            {"success_se", number(task.success.error)},
            {"actions", {{"mean", number(task.actions.mean)}, {"sd", number(task.actions.deviation)}}}};
    }
    const Json report = {
        {"experiment", "pusher_mission"},
        {"version", results.manifest.version},
        {"settings", settings},
        {"missions", statistics.missions},
        {"in_goal_rate", number(statistics.in_goal.value)},
        {"in_goal_se", number(statistics.in_goal.error)},
        {"first_push_rate", number(statistics.first_push.value)},
        {"first_push_se", number(statistics.first_push.error)},
        {"pushes", {{"mean", number(statistics.pushes.mean)}, {"sd", number(statistics.pushes.deviation)}}},
        {"driven_s", {{"mean", number(statistics.driven_s.mean)}, {"sd", number(statistics.driven_s.deviation)}}},
        {"mistaken", statistics.mistaken},
        {"subtasks", tasks},
        {"failures", counts_object(statistics.failures)},
        {"failed_attempts", counts_object(statistics.failed_ends)}};
    return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace sspql::report
