// SPDX-License-Identifier: MIT
//
// Puts together the shards of a run (--shard i/n of pusher_experiment, grid_experiment and pusher_mission): prints and
// writes what one process would have printed and written: merge_results --help

#include <cstddef>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "experiment/options.hpp"
#include "report/outputs.hpp"
#include "shards/merge.hpp"

namespace {

using namespace sspql;
using namespace sspql::experiment;

template <class Findings>
void merge(shards::ShardContent first, const std::vector<std::string>& paths, const report::OutputFiles& files) {
    shards::Merge<Findings> merge;
    merge.add(first, paths.front());
    const std::size_t count = first.shard.count;
    first = {};
    for (std::size_t i = 1; i < paths.size(); ++i) merge.add(shards::load_shard(paths[i]), paths[i]);
    Findings findings = merge.take();
    report::Manifest& manifest = findings.results.manifest;
    for (const auto& [option, path] : files.given()) manifest.command += " " + option + " " + shell_word(path);
    manifest.command += "  # in " + std::to_string(count) + (count == 1 ? " shard" : " shards");
    publish(findings, files);
}

int body(int argc, char** argv) {
    std::vector<std::string> paths;
    report::OutputFiles files;
    Options parser("merge_results",
                   "Puts together the shards of a run of pusher_experiment, grid_experiment or pusher_mission, in any "
                   "order, and prints what one process would have printed, digit for digit.");
    parser.files("SHARD", paths, "What --shard i/n wrote with --out: all n of them");
    parser.reports(files);
    parser.text("--arena-svg", files.arena_svg, "Write the picture of the arena and the learnt paths");
    parser.text("--curves-svg", files.curves_svg, "Write the picture of the learning curves");
    if (!parser.parse(argc, argv)) return 0;

    shards::ShardContent first = shards::load_shard(paths.front());
    const std::string program = first.program();
    require_known(files, program);
    require_writable(files);
    if (program == "pusher_experiment") {
        merge<report::PusherFindings>(std::move(first), paths, files);
    } else if (program == "grid_experiment") {
        merge<report::GridFindings>(std::move(first), paths, files);
    } else if (program == "pusher_mission") {
        merge<report::MissionFindings>(std::move(first), paths, files);
    } else {
        throw std::runtime_error(paths.front() + ": shard of a program unknown here, " + program);
    }
    return std::cout.good() ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) { return sspql::experiment::run_program("merge_results", body, argc, argv); }
