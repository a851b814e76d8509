// SPDX-License-Identifier: MIT
#include "experiment/parts.hpp"

namespace sspql::experiment {

Parts parts_of(const std::string& program, const ShardOptions& options, const report::OutputFiles& files,
               const Ranks& ranks, int argc, const char* const* argv) {
    Parts parts;
    parts.program = program;
    parts.files = files;
    parts.out = options.out;
    parts.whole_command = command_line(argc, argv, {"--shard", "--out", "--threads"});
    if (options.shard) {
        parts.shard = shards::parse_shard(*options.shard);
        if (options.out.empty()) throw UsageError("--shard needs --out FILE, where its runs go");
        if (!files.given().empty())
            throw UsageError("--shard writes nothing but --out; merge_results writes the reports");
        if (ranks.size() > 1) {
            throw UsageError("--shard and MPI divide a run, each in its own way: got --shard " + *options.shard +
                             " on " + std::to_string(ranks.size()) + " ranks");
        }
        report::require_writable(options.out);
    } else if (!options.out.empty()) {
        throw UsageError("--out is for the runs of a shard: give --shard, too");
    }
    if (ranks.rank() == 0) report::require_writable(files);
    return parts;
}

int run_on_ranks(const char* program, const std::function<int(int, char**, const Ranks&)>& body, int argc,
                 char** argv) {
    const Ranks ranks;  // outlives the message: a launcher may end all processes once one of them has failed
    return run_program(
        program,
        [&](int count, char** arguments) {
            try {
                return body(count, arguments, ranks);
            } catch (const ErrorElsewhere&) {
                return 0;  // the rank that has the error says so, on stderr and to the launcher
            }
        },
        argc, argv);
}

}  // namespace sspql::experiment
