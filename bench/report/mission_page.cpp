// SPDX-License-Identifier: MIT
#include "report/mission_page.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "report/html_page.hpp"
#include "report/learner_statistics.hpp"
#include "report/line_chart.hpp"
#include "report/mission_map.hpp"
#include "report/mission_player.hpp"
#include "report/numbers.hpp"
#include "report/pusher_study.hpp"

namespace sspql::report {

namespace {

std::string setting_of(const MissionResults& results, const std::string& key) {
    for (const Setting& setting : results.settings) {
        if (setting.key == key) return setting.value;
    }
    return {};
}

std::string lead(const MissionResults& results, const MissionStatistics& statistics) {
    return "In " + rate_text(statistics.in_goal) + " of " + count_text(statistics.missions, "mission") +
           " the box ends in the goal, in " + rate_text(statistics.first_push) +
           " at the first push. To get behind the box and to face it is learnt, by the learner \u201C" +
           results.learner + "\u201D.";
}

std::string description(const MissionResults& results) {
    std::string text =
        "Robot, box and goal stand anywhere in an arena of 5 m by 5 m. The robot has to find both, get behind the box, "
        "turn towards it and push it into the goal. Searching and pushing are rules; approaching and turning are "
        "learnt, first without physics, then, during the missions, with it. ";
    text += setting_of(results, "sensing") == "truth" ? "In this run it is told where everything is."
                                                      : "It starts knowing nothing, sees 60 degrees, not through the "
                                                        "box, and its wheels, eyes and distances err.";
    return text;
}

void add_tasks(HtmlPage& page, const MissionStatistics& statistics) {
    page.section("Sub-task by sub-task");
    HtmlTable table;
    table.columns = {{"sub-task", "", "", false},
                     {"attempts", "", ""},
                     {"succeeded", "of the attempts, with standard error", ""},
                     {"actions", "a mission, mean", ""},
                     {"sd", "over missions", ""}};
    for (std::size_t t = 0; t < mission_tasks; ++t) {
        const TaskStatistics& task = statistics.tasks[t];
        table.rows.push_back({{mission_task_names[t]},
                              {std::to_string(task.success.of)},
                              {rate_text(task.success)},
                              {fixed_text(task.actions.mean, 1)},
                              {fixed_text(task.actions.deviation, 1)}});
    }
    table.caption = "A mission begins " + fixed_text(statistics.pushes.mean, 2) + " pushes and drives for " +
                    fixed_text(statistics.driven_s.mean, 0) +
                    " s on average. A sub-task that fails is followed by another attempt, from the search on, up to "
                    "nine times.";
    page.table(table);
}

void add_reasons(HtmlPage& page, const MissionStatistics& statistics) {
    page.section("What failed, and why");
    const std::size_t lost = statistics.missions - statistics.in_goal.count;
    if (lost == 0) {
        page.paragraph("No mission failed.");
    } else {
        page.paragraph(count_text(lost, "mission") + " of " + std::to_string(statistics.missions) + " failed; in " +
                       std::to_string(statistics.mistaken) + " of them the robot believes the box to be in the goal.");
    }
    if (statistics.failures.empty() && statistics.failed_ends.empty()) return;
    HtmlTable table;
    table.columns = {{"reason", "", "", false},
                     {"attempts", "that ended so", ""},
                     {"missions", "lost by it", ""}};
    std::vector<ReasonCount> rows = statistics.failed_ends;
    for (const ReasonCount& failure : statistics.failures) {
        bool listed = false;
        for (const ReasonCount& row : rows) listed = listed || row.reason == failure.reason;
        if (!listed) rows.push_back({failure.reason, 0});
    }
    for (const ReasonCount& row : rows) {
        std::size_t missions = 0;
        for (const ReasonCount& failure : statistics.failures)
            missions += failure.reason == row.reason ? failure.count : 0;
        table.rows.push_back({{row.reason}, {std::to_string(row.count)}, {std::to_string(missions)}});
    }
    page.table(table);
}

/// Mean steps per episode with a band of one standard deviation, or error.
LineChart chart_of(const std::vector<LearnerStatistics>& curves, bool errors) {
    LineChart chart;
    chart.x_label = "episode";
    chart.y_label = "steps";
    for (const LearnerStatistics& learner : curves) {
        Series series{learner.name, learner.curve.mean, {}, {}};
        const double divisor = errors ? std::sqrt(static_cast<double>(learner.seeds)) : 1.0;
        for (const double deviation : learner.curve.deviation) series.spread.push_back(deviation / divisor);
        chart.series.push_back(std::move(series));
    }
    return chart;
}

LineChart training_chart(const char* task, Ink ink, const std::vector<SeedRun>& runs) {
    LineChart chart = chart_of({statistics_of(LearnerRuns{task, runs}, {})}, true);
    chart.series[0].ink = ink;
    chart.title = task;
    chart.legend = false;
    chart.width = 460.0;
    chart.height = 270.0;
    return chart;
}

void add_training(HtmlPage& page, const MissionResults& results) {
    const auto trained = [](const std::vector<SeedRun>& runs) { return !runs.empty() && !runs[0].episodes.empty(); };
    std::vector<HtmlFigure> figures;
    const std::string robots = count_text(results.approach_training.size(), "robot");
    if (trained(results.approach_training)) {
        figures.push_back({line_chart(training_chart("approach", Ink::series2, results.approach_training)),
                           "Steps per episode from random places about the box, mean over " + robots +
                               "; band: one standard error."});
    }
    if (trained(results.turn_training)) {
        figures.push_back(
            {line_chart(training_chart("turn", Ink::series1, results.turn_training)), "The same for facing the goal."});
    }
    if (figures.empty()) return;
    page.section("How the robots learnt");
    page.paragraph("Before their missions, in a world without physics, with " + results.learner +
                   ". What they know is then taken to the other world.");
    page.figure_row(figures);
}

void add_map(HtmlPage& page, const MissionResults& results) {
    if (results.map.best.empty()) return;
    std::size_t known = 0;
    for (const int action : results.map.best) known += action >= 0 ? 1 : 0;
    page.section("What the first robot knows about the 36 positions");
    page.figure({mission_map(results.map),
                 "After its missions. Each dial stands for one position relative to the box, each of its twelve wedges "
                 "for a heading; the colour is the action it would choose. Of 432 states it has tried " +
                     std::to_string(known) + ". In A the approach is over."});
}

std::string percent_more(double a, double b) {
    const double more = 100.0 * (a / b - 1.0);
    return fixed_text(std::fabs(more), 0) + (more < 0.0 ? " % less" : " % more");
}

void add_curves(HtmlPage& page, const MissionResults& results) {
    if (results.curves.size() != 2 || results.curves[0].runs.empty()) return;
    const std::vector<LearnerStatistics> curves{statistics_of(results.curves[0], {}),
                                                statistics_of(results.curves[1], {})};
    page.section("Figs. 11 and 13: more noise, more spread?");
    page.paragraph(
        "The paper reports that on the real robot, with its errors and from two starting places, early episodes were "
        "shorter than in the simulation and episodes spread more. Here: SSPQL with bonus on Box2D from two places, "
        "once "
        "with nominal actuator noise and true poses, once with twice the noise on actuators and sensors, going by what "
        "it believes.");
    std::vector<HtmlFigure> figures;
    std::vector<LineChart> charts = small_multiples(chart_of(curves, false), 460.0, 270.0);
    for (std::size_t i = 0; i < charts.size(); ++i) {
        figures.push_back({line_chart(charts[i]), std::string(i == 0 ? "Compare Fig. 11." : "Compare Fig. 13.") +
                                                      " Band: one standard deviation over " +
                                                      count_text(curves[i].seeds, "run") + "."});
    }
    page.figure_row(figures);
    HtmlTable table;
    table.columns = {{"setting", "", "", false},
                     {"episodes 1 to 5", "steps, sum"},
                     {"se", "steps"},
                     {"sd", "over runs"},
                     {"episodes 1 to 30", "steps, sum"},
                     {"sd of an episode", "steps, mean over episodes"},
                     {"late steps", "an episode"},
                     {"capped", "episodes"}};
    std::vector<double> spread;
    for (const LearnerStatistics& curve : curves) {
        spread.push_back(summarize(curve.curve.deviation).mean);
        table.rows.push_back({{curve.name},
                              {fixed_text(curve.first5_steps.mean, 0)},
                              {fixed_text(curve.first5_steps.error, 0)},
                              {fixed_text(curve.first5_steps.deviation, 0)},
                              {fixed_text(curve.first30_steps.mean, 0)},
                              {fixed_text(spread.back(), 1)},
                              {fixed_text(curve.late_steps.mean, 1)},
                              {std::to_string(curve.capped_episodes)}});
    }
    page.table(table);
    const double z = z_score(curves[1].first5_steps, curves[0].first5_steps);
    page.paragraph("With more noise the first five episodes take " +
                   percent_more(curves[1].first5_steps.mean, curves[0].first5_steps.mean) + " steps (" +
                   fixed_text(std::fabs(z), 1) +
                   " standard errors of the difference; the paper: less), and an episode's "
                   "standard deviation over runs is " +
                   percent_more(spread[1], spread[0]) + " (the paper: more).");
}

}  // namespace

std::string mission_page(const MissionResults& results, const ReplayStage& stage) {
    const MissionStatistics statistics = statistics_of(results.missions);
    HtmlPage page("The box pusher's missions");
    page.lead(lead(results, statistics));
    page.paragraph(description(results));
    if (!results.replays.empty()) {
        page.section("Watch " + count_text(results.replays.size(), "mission"));
        page.markup(mission_player(stage, results.replays));
    }
    add_tasks(page, statistics);
    add_reasons(page, statistics);
    add_training(page, results);
    add_map(page, results);
    add_curves(page, results);
    return page.text(results.manifest, results.settings);
}

}  // namespace sspql::report
