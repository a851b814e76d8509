// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "report/numbers.hpp"
#include "report/paper_statements.hpp"
#include "report/statement_builders.hpp"

namespace sspql::report {

namespace {

struct Effort {
    double episodes = 0.0;
    double steps = 0.0;
    double operations = 0.0;
    double ns_per_step = std::numeric_limits<double>::quiet_NaN();
};

/// A learner's, mean over seeds, summed over the run's phases.
Effort effort_of(const RecordedRun& run, const std::string& name) {
    Effort effort;
    for (const RecordedPhase& phase : run.phases) {
        const LearnerStatistics* learner = phase.find(name);
        if (learner == nullptr) continue;
        effort.episodes += recorded_episodes(phase, *learner);
        effort.steps += learner->total_steps.mean;
        effort.operations += learner->total_steps.mean * learner->model_ops_per_step;
        effort.ns_per_step = learner->learn_ns_per_step;
    }
    return effort;
}

/// "`dyna-q:20` (k = 20): 17.2 steps per episode, 21.0 operations and 300 ns per step"
std::string effort_text(const RecordedRun& run, const std::string& name, bool plans) {
    const Effort effort = effort_of(run, name);
    return "`" + name + "`" + (plans ? " (k = " + planning_steps(run, name) + ")" : "") + ": " +
           fixed_text(effort.steps / effort.episodes, 1) + " steps per episode, " +
           fixed_text(effort.operations / effort.steps, 1) + " operations and " + fixed_text(effort.ns_per_step, 0) +
           " ns per step";
}

/// Sums over the same seeds: there is no error to judge by.
Contest plainly_less(double a, double b) {
    Contest contest;
    contest.ratio = a / b;
    contest.ratio_error = std::numeric_limits<double>::quiet_NaN();
    contest.z = std::numeric_limits<double>::quiet_NaN();
    contest.verdict = !std::isfinite(contest.ratio) ? Verdict::missing
                      : a < b                       ? Verdict::holds
                      : a > b                       ? Verdict::fails
                                                    : Verdict::open;
    return contest;
}

bool has_bonus(const std::string& name) {
    const std::string_view family = family_of(name);
    return family.size() > 6 && family.substr(family.size() - 6) == "-bonus";
}

/// SSPQL with a bonus for rivals with one, without for those without; else the other.
const LearnerStatistics* sspql_like(const RecordedPhase& phase, const std::string& rival) {
    const LearnerStatistics* plain = phase.find("sspql");
    const LearnerStatistics* bonus = phase.find("sspql-bonus");
    if (has_bonus(rival)) return bonus != nullptr ? bonus : plain;
    return plain != nullptr ? plain : bonus;
}

bool is_planner(const std::string& name) {
    const std::string_view family = family_of(name);
    return family.substr(0, 6) == "dyna-q" || family == "ps" || family.substr(0, 3) == "ps-";
}

std::vector<std::string> assignments_of(const RecordedRun& run) {
    const auto json = nlohmann::ordered_json::parse(run.setting("set"), nullptr, false);
    std::vector<std::string> assignments;
    if (!json.is_array()) return assignments;
    for (const auto& entry : json) {
        if (entry.is_string()) assignments.push_back(entry.get<std::string>());
    }
    return assignments;
}

}  // namespace

std::string planning_steps(const RecordedRun& run, const std::string& learner) {
    std::string k = "10";
    const std::size_t colon = learner.find(':');
    if (colon != std::string::npos) k = learner.substr(colon + 1);
    for (const std::string& assignment : assignments_of(run)) {
        const std::size_t equals = assignment.find('=');
        const std::string target = assignment.substr(0, equals);
        if (equals != std::string::npos && (target == learner + ".k" || target == "*.k")) {
            k = assignment.substr(equals + 1);
        }
    }
    return k;
}

double steps_per_episode(const RecordedRun& run, const std::string& learner) {
    const Effort effort = effort_of(run, learner);
    return effort.steps / effort.episodes;
}

ComparisonSection cost_section(const std::vector<RecordedRun>& runs) {
    Statement operations{"SSPQL touches fewer records and edges per step", {}};
    Statement time{"SSPQL takes less time per step", {}};
    Statement altogether{"SSPQL touches fewer records and edges in the whole run, its number of steps included", {}};
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const RecordedRun& run = runs[i];
        if (run.phases.empty()) continue;
        const RecordedPhase& phase = run.phases.front();
        const std::string where = phase.name + (run.phases.size() > 1 ? " and so on" : "") + label_of(runs, i);
        for (const LearnerStatistics& rival : phase.learners) {
            const LearnerStatistics* ours = sspql_like(phase, rival.name);
            if (ours == nullptr || !is_planner(rival.name)) continue;
            const Effort mine = effort_of(run, ours->name);
            const Effort theirs = effort_of(run, rival.name);
            const std::string numbers =
                effort_text(run, ours->name, false) + "; " + effort_text(run, rival.name, true) +
                "; operations per run: " + fixed_text(mine.operations, 0) + " and " + fixed_text(theirs.operations, 0);
            operations.findings.push_back(
                {where, numbers, plainly_less(mine.operations / mine.steps, theirs.operations / theirs.steps)});
            time.findings.push_back({where, numbers, plainly_less(mine.ns_per_step, theirs.ns_per_step)});
            altogether.findings.push_back({where, numbers, plainly_less(mine.operations, theirs.operations)});
        }
    }
    return {"What Dyna-Q and prioritized sweeping cost (Section 3.1)",
            "The paper: SSPQL solves once an episode, the others plan k times a step, so SSPQL is cheaper. That "
            "depends on k and on how long episodes are (a solve is paid by all steps of its episode), so both stand "
            "with every number. Totals of the same run are compared as they are: no z. Times are those of the machine "
            "that recorded the run.",
            {operations, time, altogether},
            true};
}

}  // namespace sspql::report
