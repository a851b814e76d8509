// SPDX-License-Identifier: MIT
#include "report/grid_study.hpp"

#include <algorithm>
#include <stdexcept>

#include "report/numbers.hpp"
#include "report/paper_reference.hpp"
#include "report/pusher_study.hpp"
#include "report/table_text.hpp"

namespace sspql::report {

namespace {

/// Means that are this many standard errors of their difference apart differ; nearer ones are level.
constexpr double decisive_z = 2.0;

bool is_better(const Summary& a, const Summary& b, GridMeasure measure) {
    return measure == GridMeasure::steps ? a.mean < b.mean : a.mean > b.mean;
}

std::string joined(const std::vector<std::string>& parts) {
    std::string text;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
    }
    return text;
}

LearningCurve return_curve(const LearnerRuns& learner, std::size_t episodes) {
    LearningCurve curve;
    for (std::size_t episode = 0; episode < episodes; ++episode) {
        std::vector<double> returns;
        returns.reserve(learner.runs.size());
        for (const SeedRun& run : learner.runs) returns.push_back(run.episodes[episode].total_reward);
        const Summary summary = summarize(returns);
        curve.mean.push_back(summary.mean);
        curve.deviation.push_back(summary.deviation);
    }
    return curve;
}

bool varies(const PhaseRuns& phase) {
    for (const LearnerRuns& learner : phase.learners) {
        for (const SeedRun& run : learner.runs) {
            for (const EpisodeRecord& episode : run.episodes) {
                if (episode.total_reward != 0.0 && episode.total_reward != 1.0) return true;
            }
        }
    }
    return false;
}

GridPhase phase_of(const PhaseRuns& runs, bool table) {
    if (runs.learners.empty()) throw std::invalid_argument("grid_report needs learners in every phase");
    GridPhase phase;
    phase.name = runs.name;
    phase.optimal_steps = runs.optimal_steps;
    phase.optimal_return = runs.optimal_return;
    phase.learners = statistics_of(runs);
    phase.returns_vary = table || varies(runs);
    phase.seeds = phase.learners.front().seeds;
    phase.episodes = 30;
    bool counted = true;
    for (std::size_t i = 0; i < phase.learners.size(); ++i) {
        const LearnerStatistics& learner = phase.learners[i];
        phase.episodes = std::min(phase.episodes, learner.episodes);
        counted = counted && !learner.cumulative_reward.empty();
        if (phase.returns_vary) phase.return_curves.push_back(return_curve(runs.learners[i], learner.episodes));
    }
    phase.measure = counted ? GridMeasure::reward : table ? GridMeasure::returns : GridMeasure::steps;
    for (std::size_t i = 1; i < phase.learners.size(); ++i) {
        const bool better = is_better(measured(phase.learners[i], phase.measure),
                                      measured(phase.learners[phase.best], phase.measure), phase.measure);
        if (better) phase.best = i;
    }
    return phase;
}

const LearnerStatistics* reference_of(const GridPhase& phase) {
    const LearnerStatistics* q = find_learner(phase.learners, "q");
    return q != nullptr ? q : find_learner(phase.learners, "q-bonus");
}

/// The others whose mean chance alone could have put on the other side of the winner's.
std::vector<std::string> level_with_winner(const GridPhase& phase) {
    std::vector<std::string> names;
    const Summary best = measured(phase.winner(), phase.measure);
    for (std::size_t i = 0; i < phase.learners.size(); ++i) {
        const Summary other = measured(phase.learners[i], phase.measure);
        const bool apart = is_better(best, other, phase.measure) && phase.seeds > 1 &&
                           !(std::abs(z_score(best, other)) < decisive_z && best.error + other.error > 0.0);
        if (i != phase.best && !apart && (phase.seeds > 1 || best.mean == other.mean)) {
            names.push_back(phase.learners[i].name);
        }
    }
    return names;
}

/// "open64: 637, 0.30 of q's, level with ps-bonus"
std::string result_text(const GridPhase& phase) {
    const Summary best = measured(phase.winner(), phase.measure);
    std::string text = phase.name + ": " + fixed_text(best.mean, phase.measure == GridMeasure::steps ? 0 : 1);
    const LearnerStatistics* reference = reference_of(phase);
    if (reference != nullptr && reference != &phase.winner()) {
        const Summary other = measured(*reference, phase.measure);
        if (phase.measure == GridMeasure::steps) {
            text += ", " + fixed_text(best.mean / other.mean, 2) + " of " + reference->name + "'s";
        } else {
            text += " against " + reference->name + "'s " + fixed_text(other.mean, 1);
        }
    }
    const std::vector<std::string> level = level_with_winner(phase);
    if (level.size() > 3) {
        text += ", level with " + std::to_string(level.size()) + " others";
    } else if (!level.empty()) {
        text += ", level with " + joined(level);
    }
    return text;
}

std::string measure_text(const GridPhase& phase) {
    switch (phase.measure) {
        case GridMeasure::steps:
            return phase.episodes == 1
                       ? "the fewest steps in the first episode"
                       : "the fewest steps in the first " + std::to_string(phase.episodes) + " episodes";
        case GridMeasure::reward:
            return "the most reward in " + std::to_string(phase.winner().cumulative_reward.back().step) + " steps";
        case GridMeasure::returns: return "the highest mean return";
    }
    return {};
}

/// The start of a sentence about the only learner there is.
std::string alone_text(const GridPhase& phase) {
    const std::string& name = phase.winner().name;
    switch (phase.measure) {
        case GridMeasure::steps:
            return "Steps of " + name + " in the first " +
                   (phase.episodes == 1 ? "episode" : std::to_string(phase.episodes) + " episodes");
        case GridMeasure::reward:
            return "Reward of " + name + " in " + std::to_string(phase.winner().cumulative_reward.back().step) +
                   " steps";
        case GridMeasure::returns: return "Mean return of " + name;
    }
    return {};
}

}  // namespace

std::vector<GridPhase> grid_phases(const ExperimentResults& results) {
    if (results.phases.empty()) throw std::invalid_argument("grid_report needs a phase");
    const bool table = !setting_of(results, "table").empty();
    std::vector<GridPhase> phases;
    for (const PhaseRuns& runs : results.phases) phases.push_back(phase_of(runs, table));
    return phases;
}

Summary measured(const LearnerStatistics& learner, GridMeasure measure) {
    if (measure == GridMeasure::returns) return learner.mean_return;
    if (measure == GridMeasure::steps || learner.cumulative_reward.empty()) return learner.first30_steps;
    return learner.cumulative_reward.back().reward;
}

std::string grid_lead(const std::vector<GridPhase>& phases) {
    // Sentences by what was best and who was it, in order of appearance.
    struct Finding {
        std::string start;
        std::vector<std::string> results;
    };
    std::vector<Finding> findings;
    for (const GridPhase& phase : phases) {
        std::string start =
            phase.winner().name + (phase.measure == GridMeasure::steps ? " needed " : " got ") + measure_text(phase);
        if (phase.learners.size() == 1) start = alone_text(phase);
        auto found = std::find_if(findings.begin(), findings.end(), [&](const Finding& f) { return f.start == start; });
        if (found == findings.end()) found = findings.insert(findings.end(), {start, {}});
        found->results.push_back(result_text(phase));
    }
    std::string text;
    for (const Finding& finding : findings) {
        text += (text.empty() ? "" : " ") + finding.start + " on ";
        for (std::size_t i = 0; i < finding.results.size(); ++i) text += (i == 0 ? "" : "; ") + finding.results[i];
        text += ".";
    }
    const std::size_t seeds = phases.front().seeds;
    if (seeds == 1) return text + " One seed: chance cannot be told from skill.";
    return text + " Means of " + std::to_string(seeds) + " seeds.";
}

std::string grid_setting(const ExperimentResults& results, const std::vector<GridPhase>& phases) {
    std::string text = count_text(phases.front().learners.size(), "learner") + ", " +
                       count_text(phases.front().seeds, "seed") + " each.";
    if (phases.size() > 1) {
        text += " " + std::to_string(phases.size()) +
                " phases, one after the other: what was learnt in one is kept in the next.";
    }
    const std::string slip = setting_of(results, "slip");
    if (!slip.empty() && slip != "null" && setting_of(results, "table").empty()) {
        const std::string kind = setting_of(results, "noise_kind");
        const std::string where = kind == "perpendicular" ? "to one of the two sides"
                                  : kind == "lost"        ? "not at all"
                                                          : "in one of the three other directions";
        text += " With probability " + slip + " a step goes " + where + ".";
    }
    const std::string cap = setting_of(results, "steps_per_episode");
    if (!cap.empty() && cap != "null") text += " An episode is cut after " + cap + " steps.";
    return text;
}

}  // namespace sspql::report
