// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <iostream>
#include <optional>
#include <string>
#include <utility>

#include "experiment/options.hpp"
#include "ranks/ranks.hpp"
#include "report/output_file.hpp"
#include "report/outputs.hpp"
#include "shards/merge.hpp"

/// \file
/// How a run is divided: not at all, into shards that merge_results puts together, or among MPI's ranks.

namespace sspql::experiment {

/// What a program is asked to do with a run.
struct Parts {
    std::string program;
    std::optional<shards::Shard> shard{};  ///< only this one, to be written to `out`
    std::string out{};
    report::OutputFiles files{};
    std::string whole_command{};  ///< that repeats the whole run in one process

    /// Whether pictures will or may be drawn: of a shard nobody knows yet.
    [[nodiscard]] bool drawn() const { return shard || files.drawn(); }
};

/// \throws UsageError for options that contradict one another, or more ranks than one with a shard; std::runtime_error
/// for files that cannot be written.
[[nodiscard]] Parts parts_of(const std::string& program, const ShardOptions& options, const report::OutputFiles& files,
                             const Ranks& ranks, int argc, const char* const* argv);

/// Carries out a run. `findings`: everything but what is measured. run(shard, findings) measures what belongs to a
/// shard, without printing. \returns the exit status.
template <class Findings, class Run>
int run_parts(const Parts& parts, const Ranks& ranks, Findings findings, const Run& run) {
    const auto text_of_shard = [&](const shards::Shard& shard) {
        run(shard, findings);
        return shard_text(content_of(parts.program, findings, shard, parts.whole_command));
    };
    if (parts.shard) {
        report::write_file(parts.out, text_of_shard(*parts.shard));
        std::cout << parts.program << ": shard " << text_of(*parts.shard) << " is in " << parts.out << std::endl;
        return std::cout.good() ? 0 : 2;
    }
    if (ranks.size() == 1) {
        run(shards::Shard{}, findings);
        publish(findings, parts.files);
        return std::cout.good() ? 0 : 2;
    }
    std::string text;
    ranks.together([&] { text = text_of_shard({ranks.rank(), ranks.size()}); });
    ranks.together([&] {
        shards::Merge<Findings> merge;
        ranks.gather(std::move(text), [&](std::size_t rank, const std::string& part) {
            const std::string name = "rank " + std::to_string(rank);
            merge.add(shards::parse_shard_text(part, name), name);
        });
        if (ranks.rank() != 0) return;
        const std::string command = findings.results.manifest.command;
        findings = merge.take();
        findings.results.manifest.command = command + "  # on " + std::to_string(ranks.size()) + " MPI ranks";
        publish(findings, parts.files);
    });
    return std::cout.good() ? 0 : 2;
}

/// A whole program whose runs can be divided. Experiment has read(argc, argv), false if there is nothing to do;
/// prepare(ranks, argc, argv), which fills `parts`; blank(argc, argv), the findings without what is measured; and
/// run(shard, ranks, findings).
template <class Experiment>
int run_experiment(int argc, char** argv, const Ranks& ranks) {
    using Findings = decltype(std::declval<const Experiment&>().blank(argc, argv));
    Experiment experiment;
    Findings blank;
    bool wanted = false;
    ranks.together([&] {
        wanted = experiment.read(argc, argv);
        if (!wanted) return;
        experiment.prepare(ranks, argc, argv);
        blank = experiment.blank(argc, argv);
    });
    if (!wanted) return 0;
    return run_parts(experiment.parts, ranks, std::move(blank), [&](const shards::Shard& shard, Findings& findings) {
        experiment.run(shard, ranks, findings);
    });
}

/// Main of a program whose runs can be divided: run_program for a body that is told the ranks. All that may throw on
/// more than one rank must stand in `together`.
int run_on_ranks(const char* program, const std::function<int(int, char**, const Ranks&)>& body, int argc, char** argv);

}  // namespace sspql::experiment
