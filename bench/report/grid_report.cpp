// SPDX-License-Identifier: MIT
#include "report/grid_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

#include "report/grid_study.hpp"
#include "report/html_page.hpp"
#include "report/line_chart.hpp"
#include "report/numbers.hpp"
#include "report/pusher_study.hpp"
#include "report/table_text.hpp"

namespace sspql::report {

namespace {

constexpr const char* none = "\u2013";
constexpr std::size_t most_report_columns = 5;
constexpr std::size_t crowd = 6;            // so many lines need a taller chart
constexpr double most_linear_ratio = 25.0;  // between the values of one chart

std::string error_text(const Summary& summary, int digits) {
    return summary.count > 1 ? fixed_text(summary.error, digits) : none;
}

/// "64.4 \u00b1 1.6"
std::string with_error(const Summary& summary, int digits) {
    return fixed_text(summary.mean, digits) +
           (summary.count > 1 ? " \u00b1 " + fixed_text(summary.error, digits) : std::string());
}

std::string percent_text(double rate) { return std::isfinite(rate) ? short_text(100.0 * rate, 1) : none; }

// ---- tables -------------------------------------------------------------------------------------------------------

struct TableBuilder {
    std::vector<HtmlColumn> columns;
    std::vector<std::vector<HtmlCell>> rows;
};

void add_column(TableBuilder& builder, HtmlColumn column, const std::vector<HtmlCell>& cells) {
    builder.columns.push_back(std::move(column));
    builder.rows.resize(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) builder.rows[i].push_back(cells[i]);
}

/// A column with a text computed from each learner; the winner's is highlighted on demand.
template <class Text>
void add_column(TableBuilder& builder, HtmlColumn column, const GridPhase& phase, bool highlight, const Text& text) {
    std::vector<HtmlCell> cells;
    for (const LearnerStatistics& learner : phase.learners) {
        const bool best = highlight && &learner == &phase.winner() && phase.learners.size() > 1;
        cells.push_back({text(learner), best});
    }
    add_column(builder, std::move(column), cells);
}

void add_effort(TableBuilder& builder, const GridPhase& phase) {
    add_column(builder, {"model", "ops/step", "effort"}, phase, false,
               [](const auto& learner) { return fixed_text(learner.model_ops_per_step, 1); });
    add_column(builder, {"learning", "ns/step", "effort"}, phase, false,
               [](const auto& learner) { return fixed_text(learner.learn_ns_per_step, 0); });
}

void add_returns(TableBuilder& builder, const GridPhase& phase) {
    const std::string group = "return per episode";
    const bool judged = phase.measure == GridMeasure::returns;
    add_column(builder, {"mean", "", group}, phase, judged,
               [](const auto& learner) { return fixed_text(learner.mean_return.mean, 2); });
    add_column(builder, {"se", "", group}, phase, false,
               [](const auto& learner) { return error_text(learner.mean_return, 2); });
    add_column(builder, {"late", "last 20", group}, phase, false,
               [](const auto& learner) { return fixed_text(learner.late_return.mean, 2); });
}

void add_steps(TableBuilder& builder, const GridPhase& phase) {
    const std::string group = "steps in all";
    const bool judged = phase.measure == GridMeasure::steps;
    if (phase.episodes > 5) {
        add_column(builder, {"first 5", "episodes", group}, phase, false,
                   [](const auto& learner) { return fixed_text(learner.first5_steps.mean, 0); });
    }
    add_column(builder,
               {"first " + std::to_string(phase.episodes), phase.episodes == 1 ? "episode" : "episodes", group}, phase,
               judged, [](const auto& learner) { return fixed_text(learner.first30_steps.mean, 0); });
    add_column(builder, {"se", "", group}, phase, false,
               [](const auto& learner) { return error_text(learner.first30_steps, 1); });
    if (phase.learners.size() > 1) {
        const double first = phase.learners.front().first30_steps.mean;
        add_column(builder, {"ratio", "to " + phase.learners.front().name, group}, phase, judged,
                   [&](const auto& learner) { return fixed_text(learner.first30_steps.mean / first, 2); });
    }
    const std::string late = "steps late";
    add_column(builder, {"mean", "per episode", late}, phase, false,
               [](const auto& learner) { return fixed_text(learner.late_steps.mean, 1); });
    if (phase.optimal_steps) {
        add_column(builder, {"ratio", "to J*", late}, phase, false,
                   [&](const auto& learner) { return fixed_text(learner.late_steps.mean / *phase.optimal_steps, 2); });
    }
}

HtmlTable episode_table(const GridPhase& phase, bool explain) {
    TableBuilder builder;
    add_column(builder, {"learner", "", "", false}, phase, false, [](const auto& learner) { return learner.name; });
    if (phase.returns_vary) add_returns(builder, phase);
    add_steps(builder, phase);
    add_column(builder, {"success", "%", "episodes"}, phase, false,
               [](const auto& learner) { return percent_text(learner.success_rate); });
    add_column(builder, {"cut", "of " + std::to_string(phase.learners.front().all_episodes), "episodes"}, phase, false,
               [](const auto& learner) { return std::to_string(learner.capped_episodes); });
    add_effort(builder, phase);
    HtmlTable table{"", builder.columns, builder.rows};
    if (explain) {
        table.caption =
            "Means over seeds; se: standard error. Late: the last 20 episodes of the phase (all, if there are fewer). "
            "Cut: episodes that reached the step limit; they count the steps made, so the totals of learners with many "
            "of them are too low. Model: records and edges touched. Learning: time spent in the learner, on this "
            "machine; all other numbers are the same wherever the command is run.";
        if (phase.optimal_steps) {
            table.caption +=
                " J*: the fewest steps per episode that are possible on average, by value iteration on the true map.";
        }
    }
    return table;
}

/// Positions of the report steps that the table shows: all, or some and the last.
std::vector<std::size_t> report_columns(std::size_t points) {
    std::vector<std::size_t> shown;
    const std::size_t n = std::min(points, most_report_columns);
    for (std::size_t i = 1; i <= n; ++i) shown.push_back(points * i / n - 1);
    return shown;
}

HtmlTable reward_table(const GridPhase& phase, bool explain) {
    TableBuilder builder;
    add_column(builder, {"learner", "", "", false}, phase, false, [](const auto& learner) { return learner.name; });
    const std::vector<RewardPoint>& points = phase.learners.front().cumulative_reward;
    for (const std::size_t i : report_columns(points.size())) {
        const std::string unit = "by step " + std::to_string(points[i].step);
        add_column(
            builder, {"reward", unit, "collected, \u00b1 se"}, phase, i + 1 == points.size(), [i](const auto& learner) {
                return i < learner.cumulative_reward.size() ? with_error(learner.cumulative_reward[i].reward, 1) : none;
            });
    }
    add_column(builder, {"episodes", "per seed", ""}, phase, false, [](const auto& learner) {
        return fixed_text(static_cast<double>(learner.all_episodes) / static_cast<double>(learner.seeds), 1);
    });
    add_effort(builder, phase);
    HtmlTable table{"", builder.columns, builder.rows};
    if (explain) {
        table.caption =
            "Reward collected since the start of the run, mean over seeds; se: standard error. Model: records and "
            "edges touched. Learning: time spent in the learner, on this machine; all other numbers are the same "
            "wherever the command is run.";
    }
    return table;
}

// ---- charts -------------------------------------------------------------------------------------------------------

std::vector<double> errors_of(const std::vector<double>& deviations, std::size_t seeds) {
    std::vector<double> errors;
    for (const double deviation : deviations) errors.push_back(deviation / std::sqrt(static_cast<double>(seeds)));
    return errors;
}

/// Whether a linear scale would squeeze the lesser values to the bottom.
bool spans_magnitudes(const LineChart& chart) {
    double low = std::numeric_limits<double>::infinity();
    double high = 0.0;
    for (const Series& series : chart.series) {
        for (const double value : series.mean) {
            if (!(value > 0.0)) return false;
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    return high > most_linear_ratio * low;
}

/// How means and bands of the charts came about.
std::string spread_text(const GridPhase& phase) {
    return phase.seeds > 1
               ? "mean over " + count_text(phase.seeds, "seed") + "; bands: one standard error to both sides"
               : "one seed";
}

HtmlFigure steps_figure(const GridPhase& phase) {
    LineChart chart;
    chart.x_label = "episode";
    chart.y_label = "steps";
    for (const LearnerStatistics& learner : phase.learners) {
        chart.series.push_back({learner.name, learner.curve.mean, {}});
        if (learner.seeds > 1) chart.series.back().spread = errors_of(learner.curve.deviation, learner.seeds);
    }
    if (phase.optimal_steps) {
        chart.reference = ReferenceLine{"J* = " + short_text(*phase.optimal_steps, 2), *phase.optimal_steps};
    }
    chart.logarithmic = spans_magnitudes(chart);
    if (chart.series.size() > crowd) chart.height = 480.0;
    return {line_chart(chart), "Steps per episode" + std::string(chart.logarithmic ? ", logarithmic scale, " : ", ") +
                                   spread_text(phase) + "."};
}

HtmlFigure returns_figure(const GridPhase& phase) {
    LineChart chart;
    chart.x_label = "episode";
    chart.y_label = "return";
    for (std::size_t i = 0; i < phase.learners.size(); ++i) {
        const LearnerStatistics& learner = phase.learners[i];
        chart.series.push_back({learner.name, phase.return_curves[i].mean, {}});
        if (learner.seeds > 1) {
            chart.series.back().spread = errors_of(phase.return_curves[i].deviation, learner.seeds);
        }
    }
    if (phase.optimal_return) {
        chart.reference = ReferenceLine{"best = " + short_text(*phase.optimal_return, 2), *phase.optimal_return};
    }
    return {line_chart(chart), "Return per episode, undiscounted, " + spread_text(phase) + "."};
}

HtmlFigure reward_figure(const GridPhase& phase) {
    LineChart chart;
    chart.x_label = "step";
    chart.y_label = "reward collected";
    for (const LearnerStatistics& learner : phase.learners) {
        Series series;
        series.name = learner.name;
        series.x = {0.0};
        series.mean = {0.0};
        series.spread = {0.0};
        for (const RewardPoint& point : learner.cumulative_reward) {
            series.x.push_back(static_cast<double>(point.step));
            series.mean.push_back(point.reward.mean);
            series.spread.push_back(point.reward.error);
        }
        chart.series.push_back(std::move(series));
    }
    return {line_chart(chart), "Reward collected since the start of the run, " + spread_text(phase) + "."};
}

// ---- maps ---------------------------------------------------------------------------------------------------------

void add_maps(HtmlPage& page, const GridPhase& phase, const GridPhasePictures& maps) {
    std::vector<GridPicture> pictures = maps.learners;
    if (pictures.empty()) return;
    const ValueRange range = value_range(pictures);
    std::vector<Svg> drawn;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        GridPicture& picture = pictures[i];
        if (picture.title.empty()) picture.title = phase.learners[i].name;
        picture.legend = false;
        picture.range = range;
        const std::size_t cells = picture.cells.size();
        if (cells > 0 && cells <= most_picture_cells) drawn.push_back(grid_picture(picture));
    }
    if (drawn.size() < pictures.size()) {
        page.note("Maps of more than " + std::to_string(most_picture_cells) + " cells are not drawn.");
    }
    if (drawn.empty()) return;
    page.picture_row(drawn);
    page.figure({grid_legend(pictures), maps.caption});
}

void add_phase(HtmlPage& page, const GridPhase& phase, bool explain) {
    if (phase.measure == GridMeasure::reward) {
        page.table(reward_table(phase, explain));
        page.figure(reward_figure(phase));
        return;
    }
    page.table(episode_table(phase, explain));
    if (phase.returns_vary) page.figure(returns_figure(phase));
    if (phase.measure == GridMeasure::steps) page.figure(steps_figure(phase));
}

std::string title_of(const ExperimentResults& results, const std::vector<GridPhase>& phases) {
    std::string title = setting_of(results, "table").empty() ? "Grid worlds: " : "A table: ";
    for (std::size_t i = 0; i < phases.size(); ++i) title += (i == 0 ? "" : ", ") + phases[i].name;
    return title;
}

}  // namespace

std::string grid_report(const ExperimentResults& results, const std::vector<GridPhasePictures>& pictures) {
    const std::vector<GridPhase> phases = grid_phases(results);
    if (pictures.size() > phases.size()) throw std::invalid_argument("grid_report: more pictures than phases");
    HtmlPage page(title_of(results, phases));
    page.lead(grid_lead(phases));
    page.paragraph(grid_setting(results, phases));
    for (std::size_t i = 0; i < phases.size(); ++i) {
        const GridPhase& phase = phases[i];
        page.section((phases.size() > 1 ? "Phase " + std::to_string(i + 1) + ": " : "") + phase.name);
        const bool explain = i == 0 || phase.measure != phases[i - 1].measure;
        add_phase(page, phase, explain);
        if (i >= pictures.size()) continue;
        if (!pictures[i].learners.empty() && pictures[i].learners.size() != phase.learners.size()) {
            throw std::invalid_argument("grid_report: phase " + phase.name + " needs a picture for each learner");
        }
        add_maps(page, phase, pictures[i]);
    }
    return page.text(results.manifest, results.settings);
}

}  // namespace sspql::report
