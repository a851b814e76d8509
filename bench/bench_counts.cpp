// SPDX-License-Identifier: MIT
//
// What does it cost to learn the transition graph online, in time and bytes, next to counting by hand for one task and to
// the containers one would take first?
//
// A grid of 1e3 to 1e6 states, four actions, one step in ten slips; episodes of 100 random steps from random cells. The
// library counts with predecessors, labels and dirty states; so does the floor (floors/counts_floor.hpp), which knows
// the task. std::unordered_map and Eigen's sparse matrix count only. All take turns in one process on the same steps and
// must end with the same counts. Times are CPU times; a ratio is the median over the turns of library / other. The
// summary goes to the standard error; for JSON use --benchmark_out=FILE --benchmark_out_format=json.

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include <sspql/model/cells.hpp>

#include "duels/recording.hpp"
#include "duels/scanning.hpp"
#include "floors/grid_task.hpp"
#include "floors/match.hpp"
#include "floors/slippery_grid.hpp"
#include "rivals/counting.hpp"

namespace {

using namespace sspql;
using namespace sspql::duels;
using namespace sspql::rivals;
using floors::GridSize;
using floors::SlipperyGrid;
using floors::Step;

constexpr GridSize sizes[] = {{"1e3", 40, 25}, {"1e4", 100, 100}, {"1e5", 400, 250}, {"1e6", 1000, 1000}};

/// Bytes per distinct (s,a,s') after 20 steps a state, nothing reserved, capacity included.
template <class T>
void measure_bytes(benchmark::State& state, const SlipperyGrid& grid) {
    for (auto _ : state) {
        T counts(grid.states());
        Walk walk(grid);
        std::vector<Step> steps(10000);
        double distinct = 0.0;
        for (std::size_t i = 0; i < 20 * std::size_t{grid.states()} / steps.size(); ++i) {
            walk.fill(steps);
            for (const Step& t : steps) {
                distinct += counts.n(t) < 0.5 ? 1.0 : 0.0;
                counts.record(t);
            }
        }
        state.counters["bytes"] = static_cast<double>(counts.bytes()) / distinct;
        state.counters["transitions"] = distinct;
    }
}

template <class T>
void add_bytes(const std::string& name) {
    for (const GridSize& size : sizes) {
        const SlipperyGrid grid = size.grid();
        benchmark::RegisterBenchmark(("bytes per transition, " + name + "/" + size.name).c_str(),
                                     [grid](benchmark::State& state) { measure_bytes<T>(state, grid); })
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
    }
}

}  // namespace

int main(int argc, char** argv) {
    floors::Tournament tournament;
    for (const GridSize& size : sizes) {
        const SlipperyGrid grid = size.grid();
        tournament.add(std::string("record, known/") + size.name, [=] {
            return recording<Floor, HashMap, EigenReserved>(grid, true, 20000, 0,
                                                            {"library", "floor", "unordered_map", "eigen"});
        });
    }
    for (const GridSize& size : sizes) {
        const SlipperyGrid grid = size.grid();
        const std::size_t turn = std::min<std::size_t>(20 * grid.states(), 200000);
        tournament.add(std::string("record, growing/") + size.name, [=] {
            return recording<Floor, Unreserved<>, HashMap, EigenReserved>(
                grid, false, turn, 20 * grid.states(), {"library", "floor", "unreserved", "unordered_map", "eigen"});
        });
    }
    for (const GridSize& size : {GridSize{"1e3", 40, 25}, GridSize{"4e3", 80, 50}}) {
        const SlipperyGrid grid = size.grid();
        tournament.add(std::string("record, growing, eigen without reserve/") + size.name, [=] {
            const std::size_t life = 5 * grid.states();
            return recording<EigenUnreserved>(grid, false, life, life, {"library", "eigen"});
        }, 15);
    }
    for (const GridSize& size : sizes) {
        const SlipperyGrid grid = size.grid();
        tournament.add(std::string("successor/") + size.name, [=] { return scanning_successors(grid); });
        tournament.add(std::string("outcomes of (s,a)/") + size.name, [=] { return scanning_outcomes(grid); });
        tournament.add(std::string("predecessor/") + size.name, [=] { return scanning_predecessors(grid); });
    }
    add_bytes<Unreserved<CountCell>>("CountCell");
    add_bytes<Unreserved<FadingCell>>("FadingCell");
    add_bytes<Floor>("floor");
    add_bytes<HashMap>("unordered_map");
    add_bytes<EigenReserved>("eigen");
    return tournament.run(argc, argv);
}

// Found (g++ 12, -O2, one complete run on two shared cores with a load of 5 to 8; medians of library / other):
//
//     states                          1e3     1e4     1e5     1e6    bound
//     record, known / floor          0.50    0.83    1.05    1.01     1.3
//     record, growing / floor        1.01    1.12    1.25    1.56     1.5
//     record, known / unordered_map  0.24    0.16    0.30    0.29
//     record, known / eigen          0.35    0.64    0.77    0.74     room reserved for every outcome
//     record, growing / unordered_map 0.46   0.39    0.36    0.38
//     successor / floor              3.80    3.12    1.88    1.92
//     outcomes of (s,a) / floor      1.26    2.36    1.84    1.99
//     predecessor / floor            1.12    1.07    1.10    1.11
//     bytes, CountCell               30.9    31.9    31.6    31.5      36
//     bytes, FadingCell              88.6    90.7    90.3    90.2
//     bytes, floor / unordered_map   30 / 41 30 / 39 30 / 37 30 / 35
//
// Eigen without reserve costs 147 ns a record at 1e3 states and 487 at 4e3, the library 45 and 52. A known record takes
// 52 instructions, with 1e4 states as with 1e6. Growing misses its bound by a hair at 1e6: the library meets its memory
// untouched within the turn, the floor's was written when it was made. Scans in order of states pay for that layout: a
// state's predecessors no longer lie next to the next state's, and successors carry all that a Successor can tell.
