// SPDX-License-Identifier: MIT
#include "shards/experiment_shard.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "shards/run_fields.hpp"

namespace sspql::shards {

namespace {

/// What is known of a phase before anything runs.
struct PhaseHead {
    std::string name{};
    std::optional<double> optimal_steps{};
    std::optional<double> optimal_return{};
    std::vector<std::uint64_t> report_at{};
    std::vector<std::string> learners{};
    std::size_t seeds = 0;
};

template <class Io>
void fields(Io& io, Like<Io, PhaseHead>& phase) {
    auto& [name, optimal_steps, optimal_return, report_at, learners, seeds] = phase;
    io("name", name);
    io("optimal_steps", optimal_steps);
    io("optimal_return", optimal_return);
    io("report_at", report_at);
    io("learners", learners);
    io("seeds", seeds);
}

/// A map with what was learnt, a character or number a cell.
struct PictureColumns {
    std::string title{};
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::string kinds{};    ///< see kind_letters
    std::string actions{};  ///< see move_letters
    std::vector<std::optional<double>> values{};
    std::vector<std::string> reasons{};
    std::string value_name{};
};

template <class Io>
void fields(Io& io, Like<Io, PictureColumns>& picture) {
    auto& [title, rows, columns, kinds, actions, values, reasons, value_name] = picture;
    io("title", title);
    io("rows", rows);
    io("columns", columns);
    io("kinds", kinds);
    io("actions", actions);
    io("values", values);
    io("reasons", reasons);
    io("value_name", value_name);
}

const std::string kind_letters = ".#GHS";  // in the order of GridCellKind
const std::string move_letters = "udlr-";  // in the order of GridMove, and none

std::size_t letter(const std::string& letters, char c) {
    const std::size_t at = letters.find(c);
    if (at == std::string::npos) throw FieldError("has a cell that is none of " + letters);
    return at;
}

PictureColumns columns_of(const report::GridPicture& picture) {
    // What the report itself fills in is not carried.
    const auto& [title, rows, columns, cells, value_name, range, legend] = picture;
    static_cast<void>(range);
    static_cast<void>(legend);
    PictureColumns out{title, rows, columns, {}, {}, {}, {}, value_name};
    for (const auto& [kind, value, action, why] : cells) {
        out.kinds += kind_letters[static_cast<std::size_t>(kind)];
        out.actions += action ? move_letters[static_cast<std::size_t>(*action)] : '-';
        out.values.push_back(value);
        out.reasons.push_back(why);
    }
    return out;
}

report::GridPicture picture_of(const PictureColumns& columns) {
    const std::size_t cells = columns.kinds.size();
    if (columns.actions.size() != cells || columns.values.size() != cells || columns.reasons.size() != cells) {
        throw FieldError("has lists of different lengths");
    }
    report::GridPicture picture;
    picture.title = columns.title;
    picture.rows = columns.rows;
    picture.columns = columns.columns;
    picture.value_name = columns.value_name;
    for (std::size_t i = 0; i < cells; ++i) {
        report::GridPictureCell cell;
        cell.kind = static_cast<report::GridCellKind>(letter(kind_letters, columns.kinds[i]));
        cell.value = columns.values[i];
        cell.why = columns.reasons[i];
        const std::size_t move = letter(move_letters, columns.actions[i]);
        if (move + 1 < move_letters.size()) cell.action = static_cast<report::GridMove>(move);
        picture.cells.push_back(cell);
    }
    return picture;
}

Json results_head(const report::ExperimentResults& results) {
    Json head = Json::object();
    write_settings(results.settings, head);
    Json phases = Json::array();
    for (const report::PhaseRuns& phase : results.phases) {
        PhaseHead one{phase.name, phase.optimal_steps, phase.optimal_return, phase.report_at, {}, 0};
        for (const report::LearnerRuns& learner : phase.learners) {
            one.learners.push_back(learner.name);
            one.seeds = learner.runs.size();
        }
        phases.push_back(written(one));
    }
    head["phases"] = std::move(phases);
    return head;
}

report::ExperimentResults blank_results(const Json& head) {
    report::ExperimentResults results;
    results.experiment = field<std::string>(head, "program");
    results.settings = read_settings(head);
    for (const PhaseHead& one : field<std::vector<PhaseHead>>(head, "phases")) {
        report::PhaseRuns phase{one.name, one.optimal_steps, one.optimal_return, one.report_at, {}};
        for (const std::string& name : one.learners) {
            phase.learners.push_back({name, std::vector<report::SeedRun>(one.seeds)});
        }
        results.phases.push_back(std::move(phase));
    }
    return results;
}

Json runs_part(const report::ExperimentResults& results, const Shard& shard) {
    Json phases = Json::array();
    for (const report::PhaseRuns& phase : results.phases) {
        Json learners = Json::array();
        for (const report::LearnerRuns& learner : phase.learners) learners.push_back(written_runs(learner.runs, shard));
        phases.push_back(std::move(learners));
    }
    return {{"runs", std::move(phases)}};
}

void add_runs(const Json& part, const Shard& shard, report::ExperimentResults& results) {
    read_elements(part, "runs", results.phases.size(), [&](std::size_t p, const Json& phase) {
        std::vector<report::LearnerRuns>& learners = results.phases[p].learners;
        read_elements(phase, learners.size(),
                      [&](std::size_t i, const Json& runs) { read_runs(runs, shard, learners[i].runs); });
    });
}

}  // namespace

Json head_of(const report::PusherFindings& findings) { return results_head(findings.results); }

void set_head(const Json& head, report::PusherFindings& findings) { findings.results = blank_results(head); }

Json part_of(const report::PusherFindings& findings, const Shard& shard) {
    Json part = runs_part(findings.results, shard);
    part["typical_paths"] = written(findings.typical_paths);
    return part;
}

void add_part(const Json& part, const Shard& shard, report::PusherFindings& findings) {
    add_runs(part, shard, findings.results);
    auto paths = field<std::vector<std::vector<report::ArenaPath>>>(part, "typical_paths");
    if (!paths.empty()) findings.typical_paths = std::move(paths);
}

Json head_of(const report::GridFindings& findings) {
    Json head = results_head(findings.results);
    head["map_checksums"] = written(findings.checksums);
    Json captions = Json::array();
    for (const report::GridPhasePictures& phase : findings.pictures) captions.push_back(phase.caption);
    head["pictures"] = std::move(captions);
    return head;
}

void set_head(const Json& head, report::GridFindings& findings) {
    findings.results = blank_results(head);
    read_field(head, "map_checksums", findings.checksums);
    findings.pictures.clear();
    for (const std::string& caption : field<std::vector<std::string>>(head, "pictures")) {
        findings.pictures.push_back({{}, caption});
    }
}

Json part_of(const report::GridFindings& findings, const Shard& shard) {
    Json part = runs_part(findings.results, shard);
    std::vector<std::vector<PictureColumns>> pictures;
    for (const report::GridPhasePictures& phase : findings.pictures) {
        if (!shard.has(0)) break;
        pictures.emplace_back();
        for (const report::GridPicture& picture : phase.learners) pictures.back().push_back(columns_of(picture));
    }
    part["pictures"] = written(pictures);
    return part;
}

void add_part(const Json& part, const Shard& shard, report::GridFindings& findings) {
    add_runs(part, shard, findings.results);
    if (!shard.has(0)) return;
    read_elements(part, "pictures", findings.pictures.size(), [&](std::size_t p, const Json& phase) {
        std::vector<PictureColumns> learners;
        read(phase, learners);
        for (const PictureColumns& columns : learners) findings.pictures[p].learners.push_back(picture_of(columns));
    });
}

}  // namespace sspql::shards
