// SPDX-License-Identifier: MIT
#include "report/recorded_place.hpp"

#include <charconv>
#include <limits>

#include "report/numbers.hpp"

namespace sspql::report {

TaskKind kind_of(const RecordedRun& run, const RecordedPhase& phase) {
    if (run.experiment == "pusher_experiment") {
        return run.setting("task") == "turn" ? TaskKind::turn : TaskKind::approach;
    }
    if (!run.setting("table").empty()) return TaskKind::other;
    if (phase.name == "chain") return TaskKind::chain;
    for (const char* maze : {"dyna-maze", "blocking-maze", "shortcut-maze"}) {
        if (phase.name == maze) return TaskKind::maze;
    }
    if (phase.name == "cliff") return TaskKind::other;
    // Counted in steps, sums of first episodes say nothing.
    for (const LearnerStatistics& learner : phase.learners) {
        if (!learner.cumulative_reward.empty()) return TaskKind::other;
    }
    return TaskKind::grid;
}

std::vector<Place> places_of(const std::vector<RecordedRun>& runs, TaskKind kind) {
    std::vector<Place> places;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        for (std::size_t p = 0; p < runs[i].phases.size(); ++p) {
            const RecordedPhase& phase = runs[i].phases[p];
            if (kind_of(runs[i], phase) != kind) continue;
            std::string name = phase.name;
            if (kind == TaskKind::chain) name += ", p = " + short_text(1.0 - slip_of(runs[i]), 3);
            places.push_back({&runs[i], &phase, name + label_of(runs, i), p > 0});
        }
    }
    return places;
}

std::string label_of(const std::vector<RecordedRun>& runs, std::size_t i) {
    return runs.size() > 1 ? " (run " + std::to_string(i + 1) + ")" : "";
}

double slip_of(const RecordedRun& run) {
    const std::string text = run.setting("slip");
    double slip = 0.1;  // the chain's, if none is given
    std::from_chars(text.data(), text.data() + text.size(), slip);
    return slip;
}

std::uint64_t change_step(const std::string& maze) {
    return maze == "blocking-maze" ? 1000 : maze == "shortcut-maze" ? 3000 : 0;
}

double recorded_episodes(const RecordedPhase& phase, const LearnerStatistics& learner) {
    if (learner.cumulative_reward.empty()) return static_cast<double>(learner.episodes);
    if (change_step(phase.name) == 0) return std::numeric_limits<double>::quiet_NaN();
    return learner.cumulative_reward.back().reward.mean;
}

}  // namespace sspql::report
