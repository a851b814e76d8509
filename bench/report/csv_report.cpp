// SPDX-License-Identifier: MIT
#include "report/csv_report.hpp"

#include "report/numbers.hpp"

namespace sspql::report {

namespace {

std::string field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

void append_run(std::string& out, const std::string& prefix, const SeedRun& run) {
    const std::string row = prefix + std::to_string(run.seed) + ',';
    for (std::size_t i = 0; i < run.episodes.size(); ++i) {
        const EpisodeRecord& episode = run.episodes[i];
        out += row + std::to_string(i + 1) + ',' + std::to_string(episode.steps) + ',';
        out += exact_text(episode.total_reward);
        out += episode.success ? ",1" : ",0";
        out += episode.capped ? ",1\n" : ",0\n";
    }
}

}  // namespace

std::string csv_report(const ExperimentResults& results) {
    std::string out = "phase,learner,seed,episode,steps,return,success,capped\n";
    for (const PhaseRuns& phase : results.phases) {
        for (const LearnerRuns& learner : phase.learners) {
            const std::string prefix = field(phase.name) + ',' + field(learner.name) + ',';
            for (const SeedRun& run : learner.runs) append_run(out, prefix, run);
        }
    }
    return out;
}

}  // namespace sspql::report
