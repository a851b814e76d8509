// SPDX-License-Identifier: MIT
//
// What does saving a learner cost, next to writing the same bytes without knowing what they mean?
//
// SSPQL that has tried every (s,a) of a grid ten times: 64 states, 10 000, and 640 000 with some 9 million distinct
// (s,a,s'). Three take turns in one process, each replacing a file of its own on the same disk: save(), the same bytes
// from memory through AtomicFile (one call), and load(). Wall-clock time, fsync included: the disk is part of the answer.
// The table goes to the standard error; for JSON use --benchmark_out=FILE --benchmark_out_format=json. Files are made in
// the directory named by TMPDIR, or /tmp.

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <unistd.h>

#include <benchmark/benchmark.h>

#include <sspql/io/checkpoint.hpp>
#include <sspql/learn/sspql.hpp>

#include "floors/clock.hpp"
#include "floors/slippery_grid.hpp"

namespace {

using namespace sspql;

struct Row {
    std::string name;
    std::size_t bytes = 0;
    std::vector<double> save, raw, load, ratio;  // seconds, and save / raw turn by turn
};
std::vector<Row> rows;

template <class Work>
double seconds(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void run(benchmark::State& state, const char* name, std::uint32_t columns, std::uint32_t lines) {
    const floors::SlipperyGrid grid(columns, lines);
    Sspql<> learner(grid.states(), floors::actions, {}, 1);
    learner.set_goals({{state_id(grid.states() - 1), 0.0}});
    grid.explore(10, 1, [&](const floors::Step& t) {
        learner.observe(state_id(t.state), action_id(t.action), t.reward, state_id(t.next), false);
    });
    learner.update_paths();
    const auto directory = std::filesystem::temp_directory_path();
    const std::string ours = (directory / ("bench-checkpoint-" + std::to_string(::getpid()))).string();
    const std::string theirs = ours + "-raw";
    const std::string bytes = save_to_bytes(learner);
    Sspql<> loaded(grid.states(), floors::actions);
    Row row;
    row.name = name;
    row.bytes = bytes.size();
    for (auto _ : state) {
        const double save_s = seconds([&] { save(learner, ours); });
        const double raw_s = seconds([&] {
            AtomicFile file(theirs);
            file.write(bytes);
            file.commit();
        });
        const double load_s = seconds([&] { load(ours, loaded); });
        row.save.push_back(save_s);
        row.raw.push_back(raw_s);
        row.load.push_back(load_s);
        row.ratio.push_back(save_s / raw_s);
        state.SetIterationTime(save_s);
    }
    if (save_to_bytes(loaded) != bytes) state.SkipWithError("what was loaded is not what was saved");
    std::filesystem::remove(ours);
    std::filesystem::remove(theirs);
    state.counters["bytes"] = static_cast<double>(row.bytes);
    state.counters["save_to_raw"] = floors::median(row.ratio);
    if (!rows.empty() && rows.back().name == row.name) rows.pop_back();  // a trial round of the framework
    rows.push_back(row);
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    const auto add = [](const char* name, std::uint32_t columns, std::uint32_t lines, int turns) {
        benchmark::RegisterBenchmark(name, [=](benchmark::State& state) { run(state, name, columns, lines); })
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond)
            ->Iterations(turns);
    };
    add("checkpoint/64", 8, 8, 101);
    add("checkpoint/10000", 100, 100, 31);
    add("checkpoint/640000", 800, 800, 7);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    std::fprintf(stderr, "\n%-20s %12s %10s %10s %10s %12s   medians\n", "", "bytes", "save ms", "raw ms", "load ms",
                 "save / raw");
    for (const Row& row : rows) {
        std::fprintf(stderr, "%-20s %12zu %10.2f %10.2f %10.2f %12.2f\n", row.name.c_str(), row.bytes,
                     1e3 * floors::median(row.save), 1e3 * floors::median(row.raw), 1e3 * floors::median(row.load),
                     floors::median(row.ratio));
    }
    return 0;
}
