// SPDX-License-Identifier: MIT
#include "report/adaptive_tasks.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include <nlohmann/json.hpp>

#include "report/numbers.hpp"

namespace sspql::report {

namespace {

/// One learner's numbers on one map.
struct Sample {
    std::string map;
    const RecordedPhase* phase;
    const LearnerStatistics* learner;
};

/// All maps of one learner under one set of parameters.
struct Pool {
    std::string learner;
    std::string changes;
    std::vector<Sample> samples;
};

struct Group {
    std::string name;
    std::vector<Pool> pools;
};

/// "walls60" of "walls60:2".
std::string without_number(const std::string& map) { return map.substr(0, map.find(':')); }

/// What --set changed for this learner: "decay=1, gamma=.95".
std::string changes_of(const RecordedRun& run, const std::string& learner) {
    std::string changes;
    const std::string set = run.setting("set");
    if (set.empty()) return changes;
    for (const auto& word : nlohmann::json::parse(set)) {
        const auto assignment = word.get<std::string>();
        const std::size_t dot = assignment.find('.');
        const std::string name = assignment.substr(0, dot);
        if (name != "*" && name != learner) continue;
        changes += (changes.empty() ? "" : ", ") + assignment.substr(dot + 1);
    }
    return changes;
}

std::string robot_name(const RecordedRun& run, const RecordedPhase& phase) {
    return "robot, " + phase.name + " (" + (run.setting("backend") == "box2d" ? "Box2D" : run.setting("backend")) + ")";
}

/// What makes two phases the same task, in words.
std::string task_name(const RecordedRun& run, std::size_t p) {
    if (run.experiment == "pusher_experiment") return robot_name(run, run.phases[p]);
    std::string name = without_number(run.phases[p].name);
    if (p > 0) name += ", after " + without_number(run.phases[p - 1].name);
    const std::string slip = run.setting("slip");
    double part = 0.0;
    if (std::from_chars(slip.data(), slip.data() + slip.size(), part).ec == std::errc{}) {
        name += ", " + short_text(100.0 * part, 1) + " % slip";
    }
    return name;
}

/// The element for which `is_it` holds; a new one if there is none.
template <class T, class IsIt>
T& found_or_added(std::vector<T>& all, const IsIt& is_it, T&& fresh) {
    const auto at = std::find_if(all.begin(), all.end(), is_it);
    return at != all.end() ? *at : all.emplace_back(std::forward<T>(fresh));
}

std::vector<Group> grouped(const std::vector<RecordedRun>& runs) {
    std::vector<Group> groups;
    for (const RecordedRun& run : runs) {
        for (std::size_t p = 0; p < run.phases.size(); ++p) {
            const RecordedPhase& phase = run.phases[p];
            const std::string name = task_name(run, p);
            for (const LearnerStatistics& learner : phase.learners) {
                Group& group = found_or_added(
                    groups, [&](const Group& other) { return other.name == name; }, Group{name, {}});
                const std::string changes = changes_of(run, learner.name);
                const auto is_it = [&](const Pool& other) {
                    return other.learner == learner.name && other.changes == changes;
                };
                Pool& pool = found_or_added(group.pools, is_it, Pool{learner.name, changes, {}});
                const bool repeated = std::any_of(pool.samples.begin(), pool.samples.end(),
                                                  [&](const Sample& other) { return other.map == phase.name; });
                if (!repeated) pool.samples.push_back({phase.name, &phase, &learner});
            }
        }
    }
    return groups;
}

Summary measured(const LearnerStatistics& learner, TaskMeasure measure) {
    switch (measure) {
        case TaskMeasure::first_steps: break;
        case TaskMeasure::all_steps: return learner.total_steps;
        case TaskMeasure::reward: return learner.cumulative_reward.back().reward;
        case TaskMeasure::late_return: return learner.late_return;
    }
    return learner.first30_steps;
}

std::string measure_text(TaskMeasure measure, const LearnerStatistics& learner) {
    switch (measure) {
        case TaskMeasure::first_steps: break;
        case TaskMeasure::all_steps: return "steps, " + std::to_string(learner.episodes) + " episodes";
        case TaskMeasure::reward:
            return "reward by step " + std::to_string(learner.cumulative_reward.back().step) + " (more is better)";
        case TaskMeasure::late_return:
            return "return of the last " + std::to_string(std::min<std::size_t>(20, learner.episodes)) +
                   " episodes, mean";
    }
    return "steps, " + std::to_string(std::min<std::size_t>(30, learner.episodes)) + " episodes";
}

std::vector<TaskMeasure> measures_of(const Group& group) {
    const Sample& first = group.pools.front().samples.front();
    if (!first.learner->cumulative_reward.empty()) return {TaskMeasure::reward};
    if (first.map.rfind("walls", 0) == 0) return {TaskMeasure::all_steps};
    for (const Pool& pool : group.pools) {
        if (pool.samples.front().learner->late_return.mean < 0.0) {
            return {TaskMeasure::first_steps, TaskMeasure::late_return};
        }
    }
    return {TaskMeasure::first_steps};
}

TaskEntry entry_of(const Pool& pool, TaskMeasure measure) {
    TaskEntry entry{pool.learner, pool.changes, {}, 0.0, 0.0, 0, 0};
    std::vector<double> means;
    double steps = 0.0;
    for (const Sample& sample : pool.samples) {
        const LearnerStatistics& learner = *sample.learner;
        means.push_back(measured(learner, measure).mean);
        steps += learner.total_steps.mean;
        entry.touches += learner.total_steps.mean * learner.model_ops_per_step;
        entry.late_steps += learner.late_steps.mean / static_cast<double>(pool.samples.size());
        entry.cut += learner.capped_episodes;
        entry.episodes += learner.seeds * learner.episodes;
    }
    entry.touches /= steps;
    // Seeds of one map are not independent samples of maps; the maps' means are.
    entry.value = means.size() == 1 ? measured(*pool.samples.front().learner, measure) : summarize(means);
    return entry;
}

AdaptiveTask task_of(const Group& group, TaskMeasure measure) {
    const std::vector<Sample>& samples = group.pools.front().samples;
    AdaptiveTask task;
    task.name = group.name;
    task.measure = measure;
    task.measured = measure_text(measure, *samples.front().learner);
    task.maps = samples.size();
    task.seeds = samples.front().learner->seeds;
    double optimal = 0.0;
    bool known = true;
    for (const Sample& sample : samples) {
        known = known && sample.phase->optimal_steps.has_value();
        optimal += sample.phase->optimal_steps.value_or(0.0) / static_cast<double>(samples.size());
    }
    if (known) task.optimal_steps = optimal;
    for (const Pool& pool : group.pools) task.entries.push_back(entry_of(pool, measure));
    return task;
}

}  // namespace

const TaskEntry* AdaptiveTask::find(const std::string& learner) const noexcept {
    for (const TaskEntry& entry : entries) {
        if (entry.learner == learner && entry.changes.empty()) return &entry;
    }
    return nullptr;
}

const TaskEntry* AdaptiveTask::best(bool (*admitted)(const TaskEntry&)) const {
    const TaskEntry* best = nullptr;
    for (const TaskEntry& entry : entries) {
        if (admitted(entry) && (best == nullptr || better(entry, *best).ratio < 1.0)) best = &entry;
    }
    return best;
}

Contest AdaptiveTask::better(const TaskEntry& a, const TaskEntry& b) const {
    switch (measure) {
        case TaskMeasure::reward: return is_less(b.value, a.value);
        case TaskMeasure::late_return: return is_greater(a.value, b.value);
        default: return is_less(a.value, b.value);
    }
}

std::vector<AdaptiveTask> adaptive_tasks(const std::vector<RecordedRun>& runs) {
    std::vector<AdaptiveTask> tasks;
    for (const Group& group : grouped(runs)) {
        for (const TaskMeasure measure : measures_of(group)) tasks.push_back(task_of(group, measure));
    }
    return tasks;
}

}  // namespace sspql::report
