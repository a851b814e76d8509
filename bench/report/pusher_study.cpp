// SPDX-License-Identifier: MIT
#include "report/pusher_study.hpp"

#include <algorithm>
#include <stdexcept>

#include "report/numbers.hpp"
#include "report/paper_reference.hpp"
#include "report/table_text.hpp"

namespace sspql::report {

namespace {

std::string span_text(const Study& study) {
    return study.episodes == 1 ? "the first episode" : "the first " + std::to_string(study.episodes) + " episodes";
}

/// "0.33 of Q-learning's steps" or "1.20 times Q-learning's steps".
std::string share_text(double share) {
    return fixed_text(share, 2) + (share <= 1.0 ? " of" : " times") + " Q-learning's steps";
}

std::string against_q(const Study& study, const LearnerStatistics& learner) {
    return share_text(learner.first30_steps.mean / study.q()->first30_steps.mean);
}

}  // namespace

const LearnerStatistics* Study::q() const noexcept { return find_learner(learners, "q"); }

const LearnerStatistics& Study::best() const noexcept {
    return *std::min_element(learners.begin(), learners.end(),
                             [](const auto& a, const auto& b) { return a.first30_steps.mean < b.first30_steps.mean; });
}

Study study_of(const ExperimentResults& results) {
    if (results.phases.empty() || results.phases.front().learners.empty()) {
        throw std::invalid_argument("pusher_report needs a phase with learners");
    }
    Study study;
    study.learners = statistics_of(results.phases.front());
    study.task = setting_of(results, "task").empty() ? "approach" : setting_of(results, "task");
    study.backend = setting_of(results, "backend");
    study.paper_table = has_paper_table(results);
    study.seeds = study.learners.front().seeds;
    study.episodes = 30;
    for (const LearnerStatistics& learner : study.learners) study.episodes = std::min(study.episodes, learner.episodes);
    return study;
}

std::string count_text(std::size_t n, const std::string& singular) {
    return std::to_string(n) + " " + singular + (n == 1 ? "" : "s");
}

std::string lead_text(const Study& study) {
    const LearnerStatistics* hero = find_learner(study.learners, "sspql-bonus");
    if (hero == nullptr) hero = &study.best();
    const std::string mean = study.seeds == 1 ? "one seed" : "mean of " + std::to_string(study.seeds) + " seeds";
    const std::string least = method_name(study.best().name);
    if (study.q() == nullptr || study.learners.size() < 2 || hero == study.q()) {
        return least + " needed " + fixed_text(study.best().first30_steps.mean, 0) + " steps over " + span_text(study) +
               " (" + mean + ")" + (study.learners.size() > 1 ? ", fewer than every other learner." : ".");
    }
    std::string text = method_name(hero->name) + " needed " + against_q(study, *hero) + " over " + span_text(study) +
                       ": " + fixed_text(hero->first30_steps.mean, 0) + " against " +
                       fixed_text(study.q()->first30_steps.mean, 0) + " (" + mean + ").";
    if (&study.best() != hero) {
        text += " The fewest, " + against_q(study, study.best()) + ", were needed by " + least + ".";
    } else if (study.learners.size() > 2) {
        text += " No other learner needed fewer.";
    }
    return text;
}

std::string setting_text(const Study& study) {
    std::string text = "Task: " + study.task + ", the robot ";
    text += study.task == "turn" ? "turns on the spot behind the box until it faces it"
                                 : "drives to region A, behind the box as seen from the goal";
    text += ". A step is one action: forward 0.3 m, back 0.2 m, turn 30 degrees left or 25 degrees right";
    if (study.task == "turn") text += " (here the turns only)";
    text += ". " + count_text(study.seeds, "seed") + " for each learner";
    if (!study.backend.empty()) text += ", " + study.backend + " backend";
    return text + ".";
}

}  // namespace sspql::report
