// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>
#include <Eigen/SparseCore>

#include <sspql/core/ids.hpp>
#include <sspql/core/random.hpp>
#include <sspql/model/cells.hpp>

#include "duels/recording.hpp"
#include "duels/task.hpp"
#include "floors/grid_task.hpp"
#include "floors/match.hpp"
#include "floors/slippery_grid.hpp"
#include "rivals/counting.hpp"

/// \file
/// The duels of scanning: everybody walks over what was recorded, 1000 states in a row, and must find the same sum.

namespace sspql::duels {

/// What is scanned, and where.
struct Scanned {
    explicit Scanned(const floors::SlipperyGrid& grid)
        : library(grid, true, 0), floor(grid, true, 0), eigen(grid, true, 0), states(grid.states()) {}

    Recorder<rivals::Library> library;
    Recorder<rivals::Floor> floor;
    Recorder<rivals::EigenReserved> eigen;
    Random random{seed, RandomStream::environment};
    std::uint32_t states;
    std::uint32_t first = 0;

    void prepare() { first = static_cast<std::uint32_t>(random.below(states - at_once + 1)); }

    /// scan(s) for the states of this turn.
    template <class F>
    void each(F&& scan) const {
        for (std::uint32_t s = first; s < first + at_once; ++s) scan(s);
    }

    static constexpr std::uint32_t at_once = 1000;
};

/// One way to scan: adds to `sum`, returns how many edges, or outcomes, that were.
struct Scan {
    std::string name;
    std::function<std::uint64_t(const Scanned&, std::uint64_t& sum)> work;
};

inline floors::Match scanning(const floors::SlipperyGrid& grid, std::vector<Scan> scans) {
    auto scanned = std::make_shared<Scanned>(grid);
    auto sums = std::make_shared<std::vector<double>>(scans.size());
    floors::Match match;
    match.prepare = [=] { scanned->prepare(); };
    for (std::size_t i = 0; i < scans.size(); ++i) {
        match.rivals.push_back({scans[i].name, [=, work = std::move(scans[i].work)] {
                                    std::uint64_t sum = 0;
                                    const std::uint64_t done = work(*scanned, sum);
                                    (*sums)[i] = static_cast<double>(sum);
                                    return done;
                                }});
    }
    match.disagreement = [=] {
        double largest = 0.0;
        for (const double sum : *sums) largest = std::max(largest, std::fabs((*sums)[0] - sum));
        return largest;
    };
    return match;
}

/// The sum over successors of s' + N(s,a,s') for all a.
inline floors::Match scanning_successors(const floors::SlipperyGrid& grid) {
    const auto library = [](const Scanned& scanned, std::uint64_t& sum) {
        std::uint64_t edges = 0;
        const auto& counts = scanned.library.counts().counts();
        scanned.each([&](std::uint32_t s) {
            counts.for_each_successor(StateId{s}, [&](const auto& successor) {
                sum += index(successor.state());
                for (std::uint32_t a = 0; a < floors::actions; ++a) sum += successor.n(ActionId{a});
            });
            edges += counts.out_degree(StateId{s});
        });
        return edges;
    };
    const auto floor = [](const Scanned& scanned, std::uint64_t& sum) {
        std::uint64_t edges = 0;
        const auto& counts = scanned.floor.counts().counts();
        scanned.each([&](std::uint32_t s) {
            counts.for_each_successor(s, [&](std::uint32_t next, const auto& count) {
                ++edges;
                sum += next;
                for (const std::uint32_t n : count) sum += n & 0x7FFFFFFFu;
            });
        });
        return edges;
    };
    return scanning(grid, {{"library", library}, {"floor", floor}});
}

/// The sum over the outcomes of (s,a) of s' N(s,a,s'), a by turns.
inline floors::Match scanning_outcomes(const floors::SlipperyGrid& grid) {
    constexpr std::uint64_t outcomes = Scanned::at_once;  // of as many (s,a)
    const auto library = [](const Scanned& scanned, std::uint64_t& sum) {
        const auto& counts = scanned.library.counts().counts();
        scanned.each([&](std::uint32_t s) {
            const ActionId a{s % 4};
            counts.for_each_outcome(StateId{s}, a, [&](StateId next, const CountCell& cell) {
                sum += std::uint64_t{index(next)} * cell.count();
            });
        });
        return outcomes;
    };
    const auto floor = [](const Scanned& scanned, std::uint64_t& sum) {
        const auto& counts = scanned.floor.counts().counts();
        scanned.each([&](std::uint32_t s) {
            counts.for_each_successor(s, [&](std::uint32_t next, const auto& count) {
                sum += std::uint64_t{next} * (count[s % 4] & 0x7FFFFFFFu);
            });
        });
        return outcomes;
    };
    const auto eigen = [](const Scanned& scanned, std::uint64_t& sum) {
        using Matrix = Eigen::SparseMatrix<int, Eigen::RowMajor>;
        const Matrix& counts = scanned.eigen.counts().counts();
        scanned.each([&](std::uint32_t s) {
            for (Matrix::InnerIterator it(counts, static_cast<int>(s * 4 + s % 4)); it; ++it) {
                sum += static_cast<std::uint64_t>(it.col()) * static_cast<std::uint64_t>(it.value());
            }
        });
        return outcomes;
    };
    return scanning(grid, {{"library", library}, {"floor", floor}, {"eigen", eigen}});
}

/// The sum over the predecessors; labels are read.
inline floors::Match scanning_predecessors(const floors::SlipperyGrid& grid) {
    const auto scan = [](const Scanned& scanned, std::uint64_t& sum, const auto& for_each_predecessor) {
        std::uint64_t edges = 0;
        double labels = 0.0;  // not a number, as long as nobody wrote them: read, not compared
        scanned.each([&](std::uint32_t s) {
            for_each_predecessor(s, [&](auto u, double label) {
                ++edges;
                sum += static_cast<std::uint32_t>(u);
                labels += label;
            });
        });
        benchmark::DoNotOptimize(labels);
        return edges;
    };
    const auto library = [scan](const Scanned& scanned, std::uint64_t& sum) {
        const auto& counts = scanned.library.counts().counts();
        return scan(scanned, sum, [&](std::uint32_t s, auto&& f) { counts.for_each_predecessor(StateId{s}, f); });
    };
    const auto floor = [scan](const Scanned& scanned, std::uint64_t& sum) {
        const auto& counts = scanned.floor.counts().counts();
        return scan(scanned, sum, [&](std::uint32_t s, auto&& f) { counts.for_each_predecessor(s, f); });
    };
    return scanning(grid, {{"library", library}, {"floor", floor}});
}

}  // namespace sspql::duels
