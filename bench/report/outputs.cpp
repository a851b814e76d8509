// SPDX-License-Identifier: MIT
#include "report/outputs.hpp"

#include <cstddef>
#include <cstdint>
#include <iostream>
#include <stdexcept>

#include "report/csv_report.hpp"
#include "report/json_report.hpp"
#include "report/mission_page.hpp"
#include "report/pusher_report.hpp"
#include "report/table_text.hpp"

namespace sspql::report {

namespace {

/// The paths of the learner that needed the fewest steps.
Arena learnt_paths(const PusherFindings& findings) {
    Arena arena;
    const std::vector<LearnerRuns>& learners = findings.results.phases.front().learners;
    std::size_t best = 0;
    std::uint64_t best_steps = 0;
    for (std::size_t i = 0; i < learners.size(); ++i) {
        std::uint64_t steps = 0;
        for (const SeedRun& run : learners[i].runs) steps += run.steps;
        if (i == 0 || steps < best_steps) {
            best = i;
            best_steps = steps;
        }
    }
    if (best < findings.typical_paths.size()) arena.paths = findings.typical_paths[best];
    return arena;
}

void write_numbers(const ExperimentResults& results, const OutputFiles& files) {
    std::cout << table_text(results) << std::flush;
    if (!files.json.empty()) write_file(files.json, json_report(results));
    if (!files.csv.empty()) write_file(files.csv, csv_report(results));
}

}  // namespace

void require_known(const OutputFiles& files, const std::string& program) {
    for (const auto& [option, path] : files.given()) {
        const bool known = program == "pusher_experiment" || option == "--json" || option == "--html" ||
                           (program == "grid_experiment" && option == "--csv");
        if (!known) throw std::invalid_argument(option + ": " + program + " has no such output");
    }
}

void publish(const PusherFindings& findings, const OutputFiles& files) {
    write_numbers(findings.results, files);
    if (!files.drawn()) return;
    const Arena arena = learnt_paths(findings);
    const PusherPictures pictures = pusher_pictures(findings.results, arena);
    if (!files.html.empty()) write_file(files.html, pusher_report(findings.results, arena));
    if (!files.arena_svg.empty()) write_file(files.arena_svg, pictures.arena.document());
    if (!files.curves_svg.empty()) write_file(files.curves_svg, pictures.curves.document());
}

void publish(const GridFindings& findings, const OutputFiles& files) {
    write_numbers(findings.results, files);
    if (!files.html.empty()) write_file(files.html, grid_report(findings.results, findings.pictures));
}

void publish(const MissionFindings& findings, const OutputFiles& files) {
    std::cout << mission_text(findings.results) << std::flush;
    if (!files.json.empty()) write_file(files.json, mission_json(findings.results));
    if (!files.html.empty()) write_file(files.html, mission_page(findings.results, findings.stage));
}

}  // namespace sspql::report
