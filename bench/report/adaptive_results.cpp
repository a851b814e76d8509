// SPDX-License-Identifier: MIT
#include "report/adaptive_results.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "report/adaptive_tasks.hpp"
#include "report/markdown.hpp"
#include "report/numbers.hpp"
#include "report/statement_builders.hpp"

namespace sspql::report {

namespace {

constexpr const char* subject = "adaptive";
constexpr const char* none = "\u2013";

bool is_other(const TaskEntry& entry) { return entry.learner != subject; }
bool is_plain(const TaskEntry& entry) { return entry.changes.empty(); }

bool compares(const AdaptiveTask& task) { return task.find(subject) != nullptr && task.best(is_other) != nullptr; }

std::string value_text(const AdaptiveTask& task, const TaskEntry& entry) {
    const double size = std::fabs(entry.value.mean);
    return with_error(entry.value, task.measure == TaskMeasure::late_return ? 2 : size >= 100.0 ? 0 : 1);
}

std::string entry_name(const TaskEntry& entry) {
    return "`" + entry.learner + "`" + (is_plain(entry) ? "" : " with " + entry.changes);
}

std::string ratio_text(const Contest& contest) {
    std::string text = fixed_text(contest.ratio, 2);
    if (contest.ratio_error > 0.0) text += " \u00b1 " + fixed_text(contest.ratio_error, 2);
    return text;
}

std::string outcome_text(Verdict verdict) {
    return verdict == Verdict::holds ? "better" : verdict == Verdict::fails ? "worse" : "level";
}

std::string late_text(const AdaptiveTask& task, const TaskEntry& entry) {
    return task.optimal_steps && task.measure != TaskMeasure::reward
               ? fixed_text(entry.late_steps / *task.optimal_steps, 2)
               : none;
}

std::string lead_text(const std::vector<AdaptiveTask>& tasks) {
    Tally tally;
    for (const AdaptiveTask& task : tasks) tally.add(task.better(*task.find(subject), *task.best(is_other)).verdict);
    return "Against the best of the others on each task, whichever that is, `adaptive` is better on " +
           std::to_string(tally.holds) + " of " + std::to_string(tasks.size()) + " measurements, level on " +
           std::to_string(tally.open) + " (a difference below " + short_text(decisive_z, 1) +
           " standard errors) and worse on " + std::to_string(tally.fails) + ".\n\n";
}

std::string glance_table(const std::vector<AdaptiveTask>& tasks) {
    std::vector<std::vector<std::string>> rows;
    for (const AdaptiveTask& task : tasks) {
        const TaskEntry& own = *task.find(subject);
        const TaskEntry& best = *task.best(is_other);
        const Contest contest = task.better(own, best);
        rows.push_back({task.name, task.measured, entry_name(best), value_text(task, best), value_text(task, own),
                        ratio_text(contest), outcome_text(contest.verdict), fixed_text(own.touches, 1),
                        late_text(task, own)});
    }
    return markdown_table({"task", "measured", "best of the others", "its result", "`adaptive`", "ratio", "that is",
                           "touches per step", "late steps / optimum"},
                          rows, 3);
}

/// The learners with the parameters they have everywhere, in order of appearance.
std::vector<std::string> plain_learners(const std::vector<AdaptiveTask>& tasks) {
    std::vector<std::string> names;
    for (const AdaptiveTask& task : tasks) {
        for (const TaskEntry& entry : task.entries) {
            if (is_plain(entry) && std::find(names.begin(), names.end(), entry.learner) == names.end()) {
                names.push_back(entry.learner);
            }
        }
    }
    return names;
}

/// How far each learner is from the best on every task, with the parameters it has everywhere.
std::string overall_table(const std::vector<AdaptiveTask>& tasks, const std::vector<std::string>& learners) {
    std::vector<std::vector<std::string>> rows;
    for (const std::string& learner : learners) {
        std::size_t count = 0;
        double logs = 0.0;
        double worst = 0.0;
        std::string where;
        for (const AdaptiveTask& task : tasks) {
            const TaskEntry* own = task.find(learner);
            if (own == nullptr) continue;
            const double ratio = task.better(*own, *task.best(is_plain)).ratio;
            ++count;
            logs += std::log(ratio);
            if (ratio > worst) {
                worst = ratio;
                where = task.name + " (" + task.measured + ")";
            }
        }
        rows.push_back({"`" + learner + "`", where, fixed_text(worst, 2),
                        fixed_text(std::exp(logs / static_cast<double>(count)), 2), std::to_string(count)});
    }
    return markdown_table({"learner", "worst on", "there", "geometric mean", "measurements"}, rows, 2);
}

/// A row for each task, a column for each learner.
template <class Cell>
std::string matrix(const std::vector<AdaptiveTask>& tasks, const std::vector<std::string>& learners, bool with_changed,
                   const Cell& cell) {
    std::vector<std::string> headings{"task"};
    for (const std::string& learner : learners) headings.push_back("`" + learner + "`");
    if (with_changed) headings.emplace_back("with other parameters");
    std::vector<std::vector<std::string>> rows;
    for (const AdaptiveTask& task : tasks) {
        std::vector<std::string> row{task.name + (task.measure == TaskMeasure::late_return ? ", late return" : "")};
        for (const std::string& learner : learners) {
            const TaskEntry* entry = task.find(learner);
            row.push_back(entry != nullptr ? cell(task, *entry) : none);
        }
        std::string changed;
        for (const TaskEntry& entry : task.entries) {
            if (!is_plain(entry))
                changed += (changed.empty() ? "" : "; ") + entry_name(entry) + ": " + cell(task, entry);
        }
        if (with_changed) row.push_back(changed);
        rows.push_back(std::move(row));
    }
    return markdown_table(headings, rows, 1);
}

template <class Keep>
std::vector<AdaptiveTask> only(const std::vector<AdaptiveTask>& tasks, const Keep& keep) {
    std::vector<AdaptiveTask> kept;
    std::copy_if(tasks.begin(), tasks.end(), std::back_inserter(kept), keep);
    return kept;
}

std::string all_numbers(const std::vector<AdaptiveTask>& tasks, const std::vector<std::string>& learners) {
    std::string text = "## All learners\n\nThe best with its usual parameters is bold.\n\n";
    text += matrix(tasks, learners, true, [](const AdaptiveTask& task, const TaskEntry& entry) {
        const bool best = is_plain(entry) && task.best(is_plain) == task.find(entry.learner);
        return best ? "**" + value_text(task, entry) + "**" : value_text(task, entry);
    });
    const auto counted = only(tasks, [](const AdaptiveTask& task) { return task.measure != TaskMeasure::late_return; });
    text += "## Work\n\nRecords and edges of the model touched per step, for learning and planning together.\n\n";
    text += matrix(counted, learners, true,
                   [](const AdaptiveTask&, const TaskEntry& entry) { return fixed_text(entry.touches, 1); });
    const auto judged = only(
        counted, [](const AdaptiveTask& task) { return task.optimal_steps && task.measure != TaskMeasure::reward; });
    text += "## In the end\n\nSteps per episode over the last 20 episodes, as a multiple of the fewest possible.\n\n";
    text += matrix(judged, learners, true, late_text);
    const auto cut = only(counted, [](const AdaptiveTask& task) {
        return std::any_of(task.entries.begin(), task.entries.end(),
                           [](const TaskEntry& entry) { return entry.cut > 0; });
    });
    text += "## Episodes cut at the step limit\n\nThey count the steps made";
    if (cut.empty()) return text + "; there were none.\n\n";
    return text + ". Tasks without any are left out.\n\n" +
           matrix(cut, learners, true, [](const AdaptiveTask&, const TaskEntry& entry) {
               return std::to_string(entry.cut) + " of " + std::to_string(entry.episodes);
           });
}

std::string commands_text(const std::vector<RecordedRun>& runs) {
    std::string text =
        "## The recorded runs\n\n`bench/record_adaptive.sh` records them all and writes this page. Further maps of a "
        "kind "
        "(walls60:2, ...) are recorded like the first.\n\n```sh\n";
    for (const RecordedRun& run : runs) {
        const bool further = !run.phases.empty() && run.phases.front().name.find(':') != std::string::npos;
        if (!further) text += run.command() + "\n";
    }
    return text + "```\n";
}

std::string seeds_text(const std::vector<AdaptiveTask>& tasks) {
    std::string text = "Seeds: ";
    std::size_t usual = 0;
    for (const AdaptiveTask& task : tasks) usual = std::max(usual, task.seeds);
    text += std::to_string(usual);
    for (const AdaptiveTask& task : tasks) {
        if (task.seeds == usual && task.maps == 1) continue;
        text += "; " + task.name + ": ";
        if (task.maps > 1) text += std::to_string(task.maps) + " maps with ";
        text += std::to_string(task.seeds);
        if (task.maps > 1) text += " each";
    }
    return text + ".\n\n";
}

}  // namespace

std::string adaptive_results(const std::vector<RecordedRun>& runs) {
    const std::vector<AdaptiveTask> tasks = only(adaptive_tasks(runs), compares);
    if (tasks.empty()) throw std::invalid_argument("no recorded run has both `adaptive` and another learner");
    const std::vector<std::string> learners = plain_learners(tasks);
    return "# The adaptive planner beside the others\n\n"
           "<!-- Written by adaptive_results from recorded runs. Do not edit: record the runs again instead. -->\n\n"
           "What [`adaptive`](adaptive.md) needs, with its default parameters on every task, and what the others need. "
           "Results are means \u00b1 standard errors over seeds, or over maps where there are several. A ratio below 1 "
           "says that `adaptive` does better, whatever is measured. " +
           seeds_text(tasks) + "## At a glance\n\n" + lead_text(tasks) + glance_table(tasks) +
           "Touches: records and edges of the model per step, for learning and planning together. Late: steps per "
           "episode over the last 20 episodes; the optimum is that of a planner who knows the world.\n\n"
           "## One learner for everything\n\n"
           "Who does not know the task beforehand cannot choose the best learner for it. How many times worse than the "
           "best of this page each one is, all with the parameters they have everywhere:\n\n" +
           overall_table(tasks, learners) + all_numbers(tasks, learners) + commands_text(runs);
}

}  // namespace sspql::report
