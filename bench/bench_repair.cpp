// SPDX-License-Identifier: MIT
//
// What does a solve cost after an episode, if only what changed is solved again? PathSolver against itself told to
// forget, which makes it search from scratch: refresh of the visited states' costs, then repair or snapshot and search.
//
// 1. Learning: a grid of 10 000 states, goal in the centre, one step in ten slips, one in ten explores, random starts;
//    episodes 1001 to 3000, solved four ways on the same records: from scratch, repaired exactly, and with tolerances
//    of 1 % and 5 %.
// 2. A local patch: 100 states in the middle of a learnt grid of 100 000 get new weights.
// 3. Everything: refresh, snapshot, search and Q_SSP of a learnt grid of a million states, in microseconds a state.
//    The same once for a grid of any size, which also tells the memory it took:
//      --states=N           a learnt grid of about N states instead of all this (10000000: half a minute, 3 gigabytes)
//
// All solvers take turns in one process; times are CPU times. The summary goes to the standard error.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <sspql/core/random.hpp>
#include <sspql/model/cells.hpp>

#include "duels/repaired_learning.hpp"
#include "duels/whole_solve.hpp"
#include "floors/arguments.hpp"
#include "floors/clock.hpp"
#include "floors/slippery_grid.hpp"

namespace {

using namespace sspql;
using namespace sspql::duels;
using floors::median;
using floors::timed;

std::vector<std::string> summary;

template <class... Numbers>
void report(const char* format, Numbers... numbers) {
    char line[200];
    std::snprintf(line, sizeof line, format, numbers...);
    summary.emplace_back(line);
}

// ---- 1. Learning ----------------------------------------------------------------------------------------------------

void learning(benchmark::State& state) {
    RepairedLearning run(100);
    for (auto _ : state) state.SetIterationTime(run.episode());
    for (const std::string& line : run.summary()) summary.push_back(line);
}

// ---- 2. A local patch -----------------------------------------------------------------------------------------------

void patch(benchmark::State& state) {
    const floors::SlipperyGrid grid(316, 316);
    RepairCounts counts = learnt(grid);
    const std::vector<Goal> goals{{state_id(grid.states() - 1), 0.0}};
    Random random(2, RandomStream::noise);
    RepairSolver repairing;
    repairing.solve(counts, goals);
    RepairCounts other = counts;
    RepairSolver searching;
    std::vector<double> repair;
    std::vector<double> ratio;
    std::vector<double> edges;
    for (auto _ : state) {
        const auto corner = static_cast<std::uint32_t>(random.below(300) * 316 + random.below(300));
        for (std::uint32_t i = 0; i < 100; ++i) {
            const std::uint32_t s = corner + i / 10 * 316 + i % 10;
            const auto action = static_cast<std::uint32_t>(random.below(4));
            const std::uint32_t next = grid.moved(s, action);
            for (RepairCounts* c : {&counts, &other}) c->record(StateId{s}, ActionId{action}, StateId{next});
        }
        const std::uint64_t before = repairing.edges_touched();
        const double ours = timed([&] { repairing.solve(counts, goals); });
        edges.push_back(static_cast<double>(repairing.edges_touched() - before));
        searching.forget();
        const double scratch = timed([&] { searching.solve(other, goals); });
        require_equal(repairing.tree(), searching.tree());
        repair.push_back(ours);
        ratio.push_back(ours / scratch);
        state.SetIterationTime(ours);
    }
    report("local patch, 100 states of 1e5: median %.1f us, ratio %.4f, edges %.0f", 1e6 * median(repair),
           median(ratio), median(edges));
}

// ---- 3. Everything --------------------------------------------------------------------------------------------------

void report_parts(const char* what, const std::vector<std::array<double, 4>>& seconds, double states) {
    std::vector<double> part[4];
    std::vector<double> all;
    for (const auto& run : seconds) {
        for (std::size_t i = 0; i < 4; ++i) part[i].push_back(1e6 * run[i] / states);
        all.push_back(part[0].back() + part[1].back() + part[2].back() + part[3].back());
    }
    report("%s, us a state: refresh %.3f, snapshot %.3f, search %.3f, Q_SSP %.3f; all %.3f (aim: 0.35)", what,
           median(part[0]), median(part[1]), median(part[2]), median(part[3]), median(all));
}

void everything(benchmark::State& state) {
    const floors::SlipperyGrid grid(1000, 1000);
    RepairCounts counts = learnt(grid);
    WholeSolve solve(grid);
    Random random(3, RandomStream::noise);
    std::vector<std::array<double, 4>> seconds;
    for (auto _ : state) {
        change_everything(grid, counts, random);
        seconds.push_back(solve.run(counts));
        const auto& parts = seconds.back();
        state.SetIterationTime(parts[0] + parts[1] + parts[2] + parts[3]);
    }
    report_parts("a million states", seconds, grid.states());
}

/// Once, for a grid of about so many states, and what memory it took.
void one_grid(std::size_t states) {
    const auto side = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(states)));
    const floors::SlipperyGrid grid(side, side);
    RepairCounts counts(0, floors::actions);
    const double learning = timed([&] { counts = learnt(grid); });
    WholeSolve solve(grid);
    const auto first = solve.run(counts);
    Random random(3, RandomStream::noise);
    change_everything(grid, counts, random);
    report_parts("the first solve", {first}, grid.states());
    report_parts("everything changed", {solve.run(counts)}, grid.states());
    std::size_t lost = 0;
    for (const double distance : solve.tree().distance) lost += std::isfinite(distance) ? 0 : 1;
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    report("%u states, %zu edges, %zu states without a path; learnt in %.0f s", grid.states(), solve.edges(), lost,
           learning);
    report("bytes an edge: %.1f in the counts; peak of resident memory %.2f GB",
           static_cast<double>(counts.bytes()) / static_cast<double>(solve.edges()),
           static_cast<double>(usage.ru_maxrss) * 1024e-9);
}

int run(int argc, char** argv) {
    const auto states = floors::take_number(argc, argv, "--states", 100, 100000000, 0);
    benchmark::RegisterBenchmark("learning/1e4", learning)->UseManualTime()->Iterations(2000);
    benchmark::RegisterBenchmark("patch/1e5", patch)->UseManualTime()->Iterations(200);
    benchmark::RegisterBenchmark("everything/1e6", everything)->UseManualTime()->Iterations(9);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    if (states != 0) {
        one_grid(states);
    } else {
        benchmark::RunSpecifiedBenchmarks();
        benchmark::Shutdown();
    }
    for (const std::string& line : summary) std::fprintf(stderr, "%s\n", line.c_str());
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_repair: %s\n", error.what());
        return 2;
    }
}

// Found (g++ 12, -O2, two shared cores with a load of 5 to 7), searches from scratch with AutoQueue; in brackets: the
// aim.
//
//     learning, episodes 1001-3000, 1e4 states   sum / sum      median     99 % below
//       repair, exact                            0.70-0.74     0.71-0.72    1.20-1.28      [1.1]
//       tolerance 1 %                            0.39-0.40     0.36-0.37    0.94-1.00      [0.35]
//       tolerance 5 %                            0.20-0.21     0.15         0.80-0.83      [0.2]
//     local patch of 100 states in 1e5                         0.015-0.017                 [0.05]
//     a million states, us a state: refresh 0.20, snapshot 0.05, search 0.10, Q_SSP 0.12; all 0.47-0.50 [0.35]
//     ten million, 4e7 edges, under ulimit -v 8388608: refresh 0.22, snapshot 0.06, search 0.16, Q_SSP 0.12; all 0.54,
//     peak of resident memory 2.58 GB
//
// An episode ends at the goal, so that about a quarter of all states are affected even at 1 %; a repair costs 1.5 to 2
// times a search for each of them, since it looks at their edges three times and in place. It is given up when more
// than three quarters of the states are marked: sum / sum of the exact repair is 0.98-0.99 with a limit of a quarter,
// 0.79-0.80 with a half, 0.72-0.73 without any. Missed: everything at once, two fifths of whose refresh are exp.
// (A quieter machine took 0.31-0.41 before refresh and Q_SSP became 30 and 15 % faster.)
