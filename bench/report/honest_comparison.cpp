// SPDX-License-Identifier: MIT
#include "report/honest_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "report/markdown.hpp"
#include "report/numbers.hpp"
#include "report/paper_statements.hpp"
#include "report/pusher_study.hpp"
#include "report/statement_builders.hpp"

namespace sspql::report {

namespace {

constexpr const char* none = "\u2013";

bool all_missing(const Statement& statement) {
    const Tally tally = statement.tally();
    return tally.holds + tally.fails + tally.open == 0;
}

std::string ratio_text(const Contest& contest) {
    if (contest.verdict == Verdict::missing || !std::isfinite(contest.ratio)) return none;
    std::string text = fixed_text(contest.ratio, 2);
    if (std::isfinite(contest.ratio_error) && contest.ratio_error > 0.0) {
        text += " \u00b1 " + fixed_text(contest.ratio_error, 2);
    }
    return text;
}

std::string z_text(const Contest& contest) {
    if (contest.verdict == Verdict::missing || std::isnan(contest.z)) return none;
    if (std::isinf(contest.z)) return contest.z > 0.0 ? "\u221e" : "-\u221e";
    return fixed_text(contest.z, 1);
}

/// ": nest54 (run 2)", where a statement fails that does not fail everywhere.
std::string failures_text(const Statement& statement) {
    const Tally tally = statement.tally();
    if (tally.fails == 0 || tally.holds + tally.open == 0) return {};
    std::string places;
    std::vector<std::string> named;
    for (const Finding& finding : statement.findings) {
        const bool known = std::find(named.begin(), named.end(), finding.where) != named.end();
        if (finding.contest.verdict != Verdict::fails || known) continue;
        named.push_back(finding.where);
        places += (places.empty() ? "" : ", ") + finding.where;
    }
    return ": " + places;
}

std::string verdicts_table(const std::vector<ComparisonSection>& sections) {
    std::vector<std::vector<std::string>> rows;
    for (const ComparisonSection& section : sections) {
        std::string heading = section.heading;  // on its first line only
        for (const Statement& statement : section.statements) {
            rows.push_back(
                {std::exchange(heading, {}), statement.claim, statement.tally().text() + failures_text(statement)});
        }
    }
    return markdown_table({"part", "statement", "verdict"}, rows, 3);
}

std::string lead_text(const std::vector<ComparisonSection>& sections) {
    std::size_t checked = 0;
    std::size_t hold = 0;
    std::size_t fail = 0;
    std::size_t open = 0;
    std::size_t missing = 0;
    for (const ComparisonSection& section : sections) {
        for (const Statement& statement : section.statements) {
            const Tally tally = statement.tally();
            const std::size_t all = tally.holds + tally.fails + tally.open;
            checked += all > 0 ? 1u : 0u;
            missing += all == 0 ? 1u : 0u;
            hold += all > 0 && tally.holds == all ? 1u : 0u;
            fail += all > 0 && tally.fails == all ? 1u : 0u;
            open += all > 0 && tally.open == all ? 1u : 0u;
        }
    }
    return "Of " + count_text(checked, "statement") + " that the recorded runs bear on, " + std::to_string(hold) +
           " hold wherever they were tried, " + std::to_string(fail) + " hold nowhere, " + std::to_string(open) +
           " are not decided anywhere, and " + std::to_string(checked - hold - fail - open) + " depend on the place. " +
           std::to_string(missing) + " are not in the recorded runs.\n\n";
}

/// A row for each finding, a column for each statement's verdict.
std::string side_by_side_table(const std::vector<Statement>& statements) {
    std::vector<std::string> headings{"where", "numbers"};
    std::vector<std::vector<std::string>> rows;
    for (const Statement& statement : statements) {
        headings.push_back(statement.claim);
        rows.resize(std::max(rows.size(), statement.findings.size()));
        for (std::size_t i = 0; i < statement.findings.size(); ++i) {
            const Finding& finding = statement.findings[i];
            if (rows[i].empty()) rows[i] = {finding.where, finding.numbers};
            rows[i].push_back(verdict_text(finding.contest.verdict) + " (ratio " + ratio_text(finding.contest) + ")");
        }
    }
    return markdown_table(headings, rows, headings.size());
}

std::string section_text(const ComparisonSection& section) {
    std::string text = "## " + section.heading + "\n\n" + section.intro + "\n\n";
    if (section.side_by_side && !section.statements.front().findings.empty()) {
        return text + side_by_side_table(section.statements);
    }
    std::vector<std::vector<std::string>> rows;
    std::vector<std::string> absent;
    for (const Statement& statement : section.statements) {
        if (all_missing(statement)) {
            absent.push_back("- " + statement.claim + ": not in the recorded run" +
                             (statement.findings.empty() ? "" : " (" + statement.findings.front().numbers + ")") +
                             ".\n");
            continue;
        }
        std::string claim = statement.claim;  // on its first line only
        for (const Finding& finding : statement.findings) {
            rows.push_back({claim, finding.where, finding.numbers, ratio_text(finding.contest), z_text(finding.contest),
                            verdict_text(finding.contest.verdict)});
            claim.clear();
        }
    }
    if (!rows.empty()) text += markdown_table({"statement", "where", "numbers", "ratio", "z", "verdict"}, rows, 6);
    for (const std::string& line : absent) text += line;
    return text + (absent.empty() ? "" : "\n");
}

std::string ratio_to(const LearnerStatistics& learner, const LearnerStatistics* reference) {
    if (reference == nullptr || reference->first30_steps.mean <= 0.0) return none;
    return fixed_text(learner.first30_steps.mean / reference->first30_steps.mean, 2);
}

std::string numbers_table(const RecordedPhase& phase) {
    const bool counted = !phase.learners.empty() && !phase.learners.front().cumulative_reward.empty();
    std::vector<std::string> headings{"learner"};
    if (counted) {
        for (const RewardPoint& point : phase.learners.front().cumulative_reward) {
            headings.push_back("reward by step " + std::to_string(point.step));
        }
    } else {
        for (const char* heading : {"first 5 episodes", "first 30 episodes", "/ `q`", "/ `q-bonus`", "late steps",
                                    "late / J*", "cut episodes"}) {
            headings.emplace_back(heading);
        }
    }
    for (const char* heading : {"steps per episode", "operations per step", "ns per step"}) {
        headings.emplace_back(heading);
    }
    std::vector<std::vector<std::string>> rows;
    for (const LearnerStatistics& learner : phase.learners) {
        std::vector<std::string> row{"`" + learner.name + "`"};
        if (counted) {
            for (const RewardPoint& point : learner.cumulative_reward) row.push_back(with_error(point.reward, 1));
            row.resize(headings.size() - 3, none);
        } else {
            row.push_back(with_error(learner.first5_steps, 0));
            row.push_back(with_error(learner.first30_steps, 0));
            row.push_back(ratio_to(learner, phase.find("q")));
            row.push_back(ratio_to(learner, phase.find("q-bonus")));
            row.push_back(with_error(learner.late_steps, 1));
            row.push_back(phase.optimal_steps ? fixed_text(learner.late_steps.mean / *phase.optimal_steps, 2) : none);
            row.push_back(std::to_string(learner.capped_episodes));
        }
        row.push_back(fixed_text(learner.total_steps.mean / recorded_episodes(phase, learner), 1));
        row.push_back(fixed_text(learner.model_ops_per_step, 1));
        row.push_back(fixed_text(learner.learn_ns_per_step, 0));
        rows.push_back(std::move(row));
    }
    return markdown_table(headings, rows, 1);
}

std::string numbers_text(const std::vector<RecordedRun>& runs) {
    std::string text =
        "## All numbers\n\nMeans over seeds \u00b1 standard errors. Late: per episode, over the last 20 episodes. J*: "
        "the fewest steps possible. Cut: episodes of all seeds that reached the step limit and count the steps made. "
        "Operations: records and edges of the model touched. The time per step is over all phases of the run.\n\n";
    for (std::size_t i = 0; i < runs.size(); ++i) {
        for (const RecordedPhase& phase : runs[i].phases) {
            const std::size_t seeds = phase.learners.empty() ? 0 : phase.learners.front().seeds;
            text += "**" + phase.name + "** (run " + std::to_string(i + 1) + ", " + count_text(seeds, "seed");
            const bool counted = seeds > 0 && !phase.learners.front().cumulative_reward.empty();
            if (seeds > 0 && !counted) text += ", " + count_text(phase.learners.front().episodes, "episode");
            if (phase.optimal_steps) text += ", J* = " + fixed_text(*phase.optimal_steps, 3);
            text += ")\n\n" + numbers_table(phase);
        }
    }
    return text;
}

std::string commands_text(const std::vector<RecordedRun>& runs) {
    std::string text =
        "## The recorded runs\n\nEach command records its run again (add `--json FILE`); this page follows from the "
        "files by\n\n```sh\nhonest_comparison";
    for (const RecordedRun& run : runs) text += " " + run.file;
    text += " --out docs/honest-comparison.md\n```\n\n";
    for (std::size_t i = 0; i < runs.size(); ++i) {
        text += "Run " + std::to_string(i + 1) + ": `" + runs[i].file + "`, sspql " + runs[i].version + "\n\n```sh\n" +
                runs[i].command() + "\n```\n\n";
    }
    return text;
}

}  // namespace

Tally Statement::tally() const {
    Tally tally;
    for (const Finding& finding : findings) tally.add(finding.contest.verdict);
    return tally;
}

namespace {

/// Runs that share a map and its seeds (two chains that begin alike) say the same thing; once is enough.
void drop_repeated(Statement& statement) {
    const auto place = [](const Finding& finding) { return finding.where.substr(0, finding.where.find(" (run ")); };
    std::vector<Finding> kept;
    for (Finding& finding : statement.findings) {
        const bool repeated = std::any_of(kept.begin(), kept.end(), [&](const Finding& other) {
            return other.numbers == finding.numbers && place(other) == place(finding);
        });
        if (!repeated) kept.push_back(std::move(finding));
    }
    statement.findings = std::move(kept);
}

}  // namespace

std::vector<ComparisonSection> compare_runs(const std::vector<RecordedRun>& runs) {
    const std::vector<Place> grids = places_of(runs, TaskKind::grid);
    const std::vector<Place> approaches = places_of(runs, TaskKind::approach);
    std::vector<Place> robots = approaches;
    for (const Place& place : places_of(runs, TaskKind::turn)) robots.push_back(place);
    std::vector<ComparisonSection> sections{scratch_section(grids),
                                            change_section(grids),
                                            constant_section(grids),
                                            table1_section(approaches),
                                            robot_section(robots),
                                            cost_section(runs),
                                            chain_section(places_of(runs, TaskKind::chain)),
                                            maze_section(places_of(runs, TaskKind::maze)),
                                            adaptive_section(grids)};
    for (ComparisonSection& section : sections) {
        for (Statement& statement : section.statements) drop_repeated(statement);
    }
    return sections;
}

std::string honest_comparison(const std::vector<RecordedRun>& runs) {
    const std::vector<ComparisonSection> sections = compare_runs(runs);
    std::string text =
        "# What holds of the paper, and what does not\n\n"
        "<!-- Written by honest_comparison from recorded runs. Do not edit: record the runs again instead. -->\n\n"
        "Kwon, Suh and Lee (2011) against what this library measures. " +
        lead_text(sections) +
        "Every verdict on this page is computed from the numbers beside it. A comparison of means *holds* if it is "
        "true by at least " +
        short_text(decisive_z, 1) +
        " standard errors of the difference (z, seeds taken as independent samples), *does not hold* if the opposite "
        "is true by as much, and is *not decided* otherwise. Of comparisons between equal learners, about one in "
        "twenty ends beyond 2 standard errors by chance. Steps are sums over the first 30 episodes of a phase unless "
        "said otherwise; the ratio is that of the learner named first to the other.\n\n## Verdicts\n\n";
    text += verdicts_table(sections);
    for (const ComparisonSection& section : sections) text += section_text(section);
    text += numbers_text(runs) + commands_text(runs);
    text.erase(text.find_last_not_of('\n') + 1);
    return text + "\n";
}

}  // namespace sspql::report
