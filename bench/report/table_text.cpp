// SPDX-License-Identifier: MIT
#include "report/table_text.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "report/learner_statistics.hpp"
#include "report/numbers.hpp"
#include "report/paper_reference.hpp"

namespace sspql::report {

namespace {

constexpr std::size_t columns = 10;
constexpr std::size_t paper_columns = 2;
constexpr std::size_t widest_name = 18;

using Row = std::array<std::string, columns>;

std::size_t least_episodes(const std::vector<LearnerStatistics>& learners) {
    std::size_t least = learners.empty() ? 0 : learners.front().episodes;
    for (const LearnerStatistics& learner : learners) least = std::min(least, learner.episodes);
    return least;
}

std::vector<Row> rows_of(const std::vector<LearnerStatistics>& learners) {
    const LearnerStatistics* q = find_learner(learners, "q");
    std::vector<Row> rows{{"learner", "steps", "sd", "se", "ratio", "first ep.", "z", "capped", "paper", "ratio"}};
    for (std::size_t i = 0; i < learners.size(); ++i) {
        const LearnerStatistics& learner = learners[i];
        const Summary& steps = learner.first30_steps;
        const PaperRow* paper = paper_row(learner.name);
        const bool varies = learner.seeds > 1;
        rows.push_back({learner.name.substr(0, widest_name), fixed_text(steps.mean, 1),
                        varies ? fixed_text(steps.deviation, 1) : "-", varies ? fixed_text(steps.error, 1) : "-",
                        q != nullptr ? fixed_text(steps.mean / q->first30_steps.mean, 2) : "-",
                        fixed_text(learner.first_episode.mean, 1),
                        varies && i > 0 ? fixed_text(z_score(learners[i - 1].first30_steps, steps), 1) : "-",
                        std::to_string(learner.capped_episodes), paper != nullptr ? fixed_text(paper->steps, 0) : "-",
                        paper != nullptr ? fixed_text(paper->steps / paper_row("q")->steps, 2) : "-"});
    }
    return rows;
}

/// The first column to the left, the others to the right, two spaces between.
std::string aligned(const std::vector<Row>& rows, std::size_t shown) {
    std::array<std::size_t, columns> widths{};
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < shown; ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    std::string out;
    for (const Row& row : rows) {
        out += row[0] + std::string(widths[0] - row[0].size(), ' ');
        for (std::size_t i = 1; i < shown; ++i) out += std::string(widths[i] - row[i].size() + 2, ' ') + row[i];
        out += '\n';
        if (&row != &rows.front()) continue;
        std::size_t total = widths[0];
        for (std::size_t i = 1; i < shown; ++i) total += widths[i] + 2;
        out += std::string(total, '-') + '\n';
    }
    return out;
}

}  // namespace

std::string setting_of(const ExperimentResults& results, const std::string& key) {
    for (const Setting& setting : results.settings) {
        if (setting.key == key) return setting.value;
    }
    return {};
}

bool has_paper_table(const ExperimentResults& results) {
    if (results.experiment != "pusher_experiment" || setting_of(results, "task") == "turn") return false;
    for (const PhaseRuns& phase : results.phases) {
        if (least_episodes(statistics_of(phase)) < 30) return false;
    }
    return !results.phases.empty();
}

std::string table_text(const ExperimentResults& results) {
    const std::size_t shown = has_paper_table(results) ? columns : columns - paper_columns;
    std::string out;
    for (const PhaseRuns& phase : results.phases) {
        const std::vector<LearnerStatistics> learners = statistics_of(phase);
        if (learners.empty()) continue;
        const std::size_t episodes = std::min<std::size_t>(30, least_episodes(learners));
        const std::size_t seeds = learners.front().seeds;
        if (!out.empty()) out += '\n';
        out += phase.name + ": steps of " +
               (episodes == 1 ? "episode 1" : "episodes 1 to " + std::to_string(episodes)) + ", " +
               std::to_string(seeds) + (seeds == 1 ? " seed\n" : " seeds\n");
        out += aligned(rows_of(learners), shown);
    }
    return out;
}

}  // namespace sspql::report
