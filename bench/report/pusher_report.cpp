// SPDX-License-Identifier: MIT
#include "report/pusher_report.hpp"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "report/html_page.hpp"
#include "report/learner_statistics.hpp"
#include "report/line_chart.hpp"
#include "report/numbers.hpp"
#include "report/paper_reference.hpp"
#include "report/pusher_study.hpp"

namespace sspql::report {

namespace {

std::vector<HtmlColumn> table_columns(const Study& study) {
    const std::string group = "this run";
    std::vector<HtmlColumn> columns{
        {"learner", "", "", false},
        {"steps", study.episodes == 1 ? "episode 1" : "ep. 1 to " + std::to_string(study.episodes), group},
        {"sd", "steps", group},
        {"se", "steps", group},
        {"ratio", "to Q", group},
        {"z", "row above", group},
        {"first episode", "steps", group},
        {"capped", "episodes", group}};
    if (study.paper_table) {
        columns.push_back({"steps", "ep. 1 to 30", "paper, Table 1"});
        columns.push_back({"ratio", "to Q", "paper, Table 1"});
    }
    return columns;
}

HtmlTable steps_table(const Study& study) {
    HtmlTable table;
    table.columns = table_columns(study);
    const std::string none = "\u2013";
    for (std::size_t i = 0; i < study.learners.size(); ++i) {
        const LearnerStatistics& learner = study.learners[i];
        const Summary& steps = learner.first30_steps;
        const bool varies = learner.seeds > 1;
        const bool best = &learner == &study.best() && study.learners.size() > 1;
        std::vector<HtmlCell> row{
            {method_name(learner.name)},
            {fixed_text(steps.mean, 0), best},
            {varies ? fixed_text(steps.deviation, 0) : none},
            {varies ? fixed_text(steps.error, 1) : none},
            {study.q() != nullptr ? fixed_text(steps.mean / study.q()->first30_steps.mean, 2) : none, best},
            {varies && i > 0 ? fixed_text(z_score(study.learners[i - 1].first30_steps, steps), 1) : none},
            {fixed_text(learner.first_episode.mean, 1)},
            {std::to_string(learner.capped_episodes)}};
        if (study.paper_table) {
            const PaperRow* paper = paper_row(learner.name);
            row.push_back({paper != nullptr ? fixed_text(paper->steps, 0) : none});
            row.push_back({paper != nullptr ? fixed_text(paper->steps / paper_row("q")->steps, 2) : none});
        }
        table.rows.push_back(std::move(row));
    }
    table.caption =
        "Steps: sum over the episodes, mean over seeds, with sample standard deviation (sd) and standard error (se). "
        "z: by how many standard errors of the difference the row above needed more, seeds taken as independent. "
        "Capped: episodes of all seeds cut at the step limit; they count the steps made.";
    return table;
}

/// Mean curves; the bands are filled in by the caller.
LineChart curves_chart(const Study& study) {
    LineChart chart;
    chart.x_label = "episode";
    chart.y_label = "steps";
    for (std::size_t i = 0; i < study.learners.size(); ++i) {
        const LearnerStatistics& learner = study.learners[i];
        chart.series.push_back({method_name(learner.name), learner.curve.mean, {}, {}, series_ink(i)});
    }
    return chart;
}

std::string figure_reference(const Study& study, const std::string& learner) {
    if (study.task == "turn") return paper_row(learner) != nullptr ? " Compare the paper's Fig. 12." : "";
    const PaperRow* row = paper_row(learner);
    return row != nullptr ? " Compare the paper's " + std::string(row->figure) + "." : " Not in the paper.";
}

/// All learners' curves with a band of one standard error to both sides.
LineChart joint_chart(const Study& study) {
    LineChart joint = curves_chart(study);
    for (std::size_t i = 0; study.seeds > 1 && i < study.learners.size(); ++i) {
        for (const double deviation : study.learners[i].curve.deviation) {
            joint.series[i].spread.push_back(deviation / std::sqrt(static_cast<double>(study.learners[i].seeds)));
        }
    }
    return joint;
}

void add_curves(HtmlPage& page, const Study& study) {
    page.section("Learning curves");
    const bool varies = study.seeds > 1;
    const LineChart joint = joint_chart(study);
    LineChart spread = curves_chart(study);
    for (std::size_t i = 0; varies && i < study.learners.size(); ++i) {
        spread.series[i].spread = study.learners[i].curve.deviation;
    }
    const std::string seeds = varies ? "mean over " + count_text(study.seeds, "seed") : "one seed";
    page.figure({line_chart(joint),
                 "Steps per episode, " + seeds + (varies ? "; bands: one standard error to both sides." : ".")});
    if (study.learners.size() < 2) return;
    std::vector<HtmlFigure> figures;
    const std::vector<LineChart> charts = small_multiples(spread, 460.0, 270.0);
    for (std::size_t i = 0; i < charts.size(); ++i) {
        figures.push_back({line_chart(charts[i]), (varies ? "Band: one standard deviation over seeds." : "One seed.") +
                                                      figure_reference(study, study.learners[i].name)});
    }
    page.figure_row(figures);
}

/// Whether a path's name is the learner's, perhaps with something after it: "sspql, start 1".
bool is_path_of(const std::string& path, const std::string& learner) {
    if (path.compare(0, learner.size(), learner) != 0) return false;
    return path.size() == learner.size() || path[learner.size()] == ' ' || path[learner.size()] == ',';
}

/// A learner's paths have its colour.
Svg inked_arena(const Study& study, Arena arena) {
    for (std::size_t p = arena.inks.size(); p < arena.paths.size(); ++p) {
        arena.inks.push_back(series_ink(p));
        for (std::size_t i = 0; i < study.learners.size(); ++i) {
            if (is_path_of(arena.paths[p].name, study.learners[i].name)) arena.inks[p] = series_ink(i);
        }
    }
    return arena_picture(arena);
}

void add_arena(HtmlPage& page, const Study& study, const Arena& arena) {
    page.section("The arena");
    std::string caption =
        "Seen from above. The robot keeps inside the fence about the box; its position is known as "
        "one of the cells (sector and ring), its heading as one of 12.";
    if (!arena.paths.empty()) {
        caption +=
            " A path is, of the last ten episodes from that start in the first seed's run, the one of median length; a "
            "dot is a step's end, its tick the heading.";
    }
    page.figure({inked_arena(study, arena), caption});
}

void add_honest_part(HtmlPage& page, const Study& study) {
    std::uint64_t capped = 0;
    std::uint64_t episodes = 0;
    for (const LearnerStatistics& learner : study.learners) {
        capped += learner.capped_episodes;
        episodes += learner.all_episodes;
    }
    page.section("What reproduces, and what does not");
    const std::vector<Claim> claims = study.paper_table ? compare_with_paper(study.learners) : std::vector<Claim>{};
    if (!claims.empty()) {
        HtmlTable table;
        table.columns = {{"the paper", "", "", false}, {"this run", "", "", false}, {"agrees", "", "", false}};
        std::size_t agreeing = 0;
        for (const Claim& claim : claims) {
            table.rows.push_back({{claim.statement}, {claim.measured}, {claim.agrees ? "yes" : "no", claim.agrees}});
            agreeing += claim.agrees ? 1u : 0u;
        }
        table.caption = "Numbers agree when they lie within " + fixed_text(100.0 * claim_tolerance, 0) +
                        " % of the paper's. Converged: the five episodes that follow need at most " +
                        fixed_text(100.0 * claim_tolerance, 0) + " % more steps than the last five.";
        page.paragraph("Of " + count_text(claims.size(), "statement") + " of the paper that this run can check, " +
                       std::to_string(agreeing) + (agreeing == 1 ? " agrees" : " agree") + " with it.");
        page.table(table);
        page.paragraph(
            "The paper gives neither the arena's size nor the starting places, the noise, the lambda of its eq. 2, the "
            "eps of its eq. 8 or the number of runs it averages; all of these are choices of ours, and the counts "
            "depend on them. Its text also says that SSP alone takes fewer steps per episode than SSPQL, while its "
            "Table 1 gives SSP the greater total.");
    } else if (study.task == "turn") {
        page.paragraph(
            "The paper shows this task's curves in Fig. 12 and gives no totals, so there is nothing to "
            "compare the table with.");
    } else {
        page.paragraph(
            "This run has too few episodes (Table 1 counts 30) or too few of the paper's four learners to "
            "be compared with the paper.");
    }
    page.paragraph(capped == 0 ? "No episode was cut at the step limit."
                               : std::to_string(capped) + " of " + std::to_string(episodes) +
                                     " episodes were cut at the step limit. They count the steps made, so the totals "
                                     "of learners with many of them are too low.");
}

}  // namespace

std::string pusher_report(const ExperimentResults& results, const Arena& arena) {
    const Study study = study_of(results);
    HtmlPage page("The box pusher: " + study.task);
    page.lead(lead_text(study));
    page.paragraph(setting_text(study));
    page.section(study.paper_table ? "Table 1: total steps" : "Total steps");
    page.table(steps_table(study));
    add_curves(page, study);
    if (study.task != "turn" || !arena.paths.empty()) add_arena(page, study, arena);
    add_honest_part(page, study);
    return page.text(results.manifest, results.settings);
}

PusherPictures pusher_pictures(const ExperimentResults& results, const Arena& arena) {
    const Study study = study_of(results);
    return {inked_arena(study, arena), line_chart(joint_chart(study))};
}

}  // namespace sspql::report
