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
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include <Eigen/SparseCore>
#include <benchmark/benchmark.h>

#include <sspql/core/random.hpp>
#include <sspql/model/transition_counts.hpp>

#include "floors/counts_floor.hpp"
#include "floors/match.hpp"
#include "floors/slippery_grid.hpp"

namespace {

using namespace sspql;
using floors::Match;
using floors::SlipperyGrid;
using floors::Step;

constexpr std::uint64_t seed = 1;
constexpr std::size_t actions = floors::actions;

struct Size {
    const char* name;
    std::uint32_t columns;
    std::uint32_t rows;
};
constexpr Size sizes[] = {{"1e3", 40, 25}, {"1e4", 100, 100}, {"1e5", 400, 250}, {"1e6", 1000, 1000}};

/// Episodes of random steps, the endless source of the benchmark's work.
class Walk {
public:
    explicit Walk(const SlipperyGrid& grid) : grid_(grid), random_(seed, RandomStream::environment) {}

    void fill(std::vector<Step>& steps) {
        for (Step& t : steps) {
            if (left_-- == 0) {
                state_ = static_cast<std::uint32_t>(random_.below(grid_.states()));
                left_ = 99;
            }
            const auto a = static_cast<std::uint32_t>(random_.below(actions));
            const std::uint32_t next = grid_.moved(state_, SlipperyGrid::direction(a, random_));
            t = {state_, a, 0.0, next, next + 1 == grid_.states()};
            state_ = next;
        }
    }

private:
    SlipperyGrid grid_;
    Random random_;
    std::uint32_t state_ = 0;
    std::size_t left_ = 0;
};

// ---- The rivals: record(step), n(s, a, next) ------------------------------------------------------------------------

class Library {
public:
    explicit Library(std::size_t states, bool reserve = true) : counts_(states, actions) {
        if (reserve) counts_.reserve(states, 4 * states);
    }
    void record(const Step& t) {
        counts_.record(StateId{t.state}, ActionId{t.action}, StateId{t.next}, t.terminated);
    }
    void start_turn() { counts_.clear_dirty(); }
    [[nodiscard]] double n(const Step& t) const {
        return counts_.n(StateId{t.state}, ActionId{t.action}, StateId{t.next});
    }
    [[nodiscard]] const TransitionCounts<>& counts() const { return counts_; }
    [[nodiscard]] std::size_t bytes() const { return counts_.bytes(); }

private:
    TransitionCounts<> counts_;
};

class Unreserved : public Library {
public:
    explicit Unreserved(std::size_t states) : Library(states, false) {}
};

class Floor {
public:
    explicit Floor(std::size_t states) : counts_(states) {}
    void record(const Step& t) { counts_.record(t.state, t.action, t.next, t.terminated); }
    void start_turn() { counts_.clear_dirty(); }
    [[nodiscard]] double n(const Step& t) const { return counts_.n(t.state, t.action, t.next); }
    [[nodiscard]] const floors::Counts& counts() const { return counts_; }
    [[nodiscard]] std::size_t bytes() const { return counts_.bytes(); }

private:
    floors::Counts counts_;
};

/// Counts only, no neighbours.
class HashMap {
public:
    explicit HashMap(std::size_t states) : totals_(states * actions, 0) {}
    void record(const Step& t) {
        ++counts_[key(t)];
        ++totals_[t.state * actions + t.action];
    }
    void start_turn() {}
    [[nodiscard]] double n(const Step& t) const {
        const auto found = counts_.find(key(t));
        return found == counts_.end() ? 0.0 : found->second;
    }
    [[nodiscard]] std::size_t bytes() const {
        return counts_.size() * 24 + counts_.bucket_count() * sizeof(void*) + totals_.capacity() * sizeof(std::uint32_t);
    }

private:
    static std::uint64_t key(const Step& t) {
        return (std::uint64_t{t.state} * actions + t.action) << 32 | t.next;
    }
    std::unordered_map<std::uint64_t, std::uint32_t> counts_;
    std::vector<std::uint32_t> totals_;
};

/// Counts only; rows are (s,a), with room for every outcome they can have.
class EigenReserved {
public:
    explicit EigenReserved(std::size_t states) : EigenReserved(states, floors::most_outcomes) {}
    void record(const Step& t) {
        ++counts_.coeffRef(static_cast<int>(t.state * actions + t.action), static_cast<int>(t.next));
        ++totals_[t.state * actions + t.action];
    }
    void start_turn() {}
    [[nodiscard]] double n(const Step& t) const {
        return counts_.coeff(static_cast<int>(t.state * actions + t.action), static_cast<int>(t.next));
    }
    [[nodiscard]] const auto& counts() const { return counts_; }
    [[nodiscard]] std::size_t bytes() const {
        return static_cast<std::size_t>(counts_.data().allocatedSize()) * 8 + totals_.capacity() * 12 + 8;
    }

protected:
    EigenReserved(std::size_t states, std::size_t room)
        : counts_(static_cast<int>(states * actions), static_cast<int>(states)), totals_(states * actions, 0) {
        if (room != 0) counts_.reserve(Eigen::VectorXi::Constant(counts_.rows(), static_cast<int>(room)));
    }

private:
    Eigen::SparseMatrix<int, Eigen::RowMajor> counts_;
    std::vector<std::uint32_t> totals_;
};

class EigenUnreserved : public EigenReserved {
public:
    explicit EigenUnreserved(std::size_t states) : EigenReserved(states, 0) {}
};

// ---- Recording ------------------------------------------------------------------------------------------------------

/// One who records. Begins anew, between turns, after `life` steps (0: never).
template <class T>
class Recorder {
public:
    Recorder(const SlipperyGrid& grid, bool explored, std::size_t life) : grid_(grid), life_(life) {
        renew();
        if (explored) grid.explore(10, seed, [this](const Step& t) { counts_->record(t); });
    }
    void start_turn() {
        if (life_ != 0 && recorded_ >= life_) renew();
        counts_->start_turn();
    }
    std::uint64_t record(const std::vector<Step>& steps) {
        for (const Step& t : steps) counts_->record(t);
        recorded_ += steps.size();
        return steps.size();
    }
    [[nodiscard]] const T& counts() const { return *counts_; }

private:
    void renew() {
        counts_.reset();
        counts_ = std::make_unique<T>(grid_.states());
        recorded_ = 0;
    }
    SlipperyGrid grid_;
    std::size_t life_;
    std::size_t recorded_ = 0;
    std::unique_ptr<T> counts_;
};

/// Library, floor and others record the same steps.
template <class... Others>
Match recording(const SlipperyGrid& grid, bool explored, std::size_t turn, std::size_t life,
                const std::vector<std::string>& names) {
    auto steps = std::make_shared<std::vector<Step>>(turn);
    auto walk = std::make_shared<Walk>(grid);
    auto library = std::make_shared<Recorder<Library>>(grid, explored, life);
    auto prepares = std::make_shared<std::vector<std::function<void()>>>();
    auto differences = std::make_shared<std::vector<std::function<double(const Step&)>>>();
    Match match;
    const auto enter = [&](auto recorder) {
        match.rivals.push_back({names[match.rivals.size()], [=] { return recorder->record(*steps); }});
        prepares->push_back([=] { recorder->start_turn(); });
        differences->push_back(
            [=](const Step& t) { return std::fabs(recorder->counts().n(t) - library->counts().n(t)); });
    };
    enter(library);
    (enter(std::make_shared<Recorder<Others>>(grid, explored, life)), ...);
    match.prepare = [=] {
        walk->fill(*steps);
        for (const auto& prepare : *prepares) prepare();
    };
    // A step's own count, and N(s,a) of the floor, stand for all.
    match.disagreement = [=] {
        double largest = 0.0;
        for (const Step& t : *steps) {
            for (const auto& difference : *differences) largest = std::max(largest, difference(t));
        }
        return largest;
    };
    return match;
}

// ---- Scanning -------------------------------------------------------------------------------------------------------

/// Scans 1000 states beginning anywhere; `scan(s)` returns the number of edges seen.
template <class F>
std::uint64_t scan_all(std::uint32_t first, F&& scan) {
    std::uint64_t edges = 0;
    for (std::uint32_t s = first; s < first + 1000; ++s) edges += static_cast<std::uint64_t>(scan(s));
    return edges;
}

struct Scanned {
    explicit Scanned(const SlipperyGrid& grid)
        : library(grid, true, 0), floor(grid, true, 0), eigen(grid, true, 0), states(grid.states()) {}
    Recorder<Library> library;
    Recorder<Floor> floor;
    Recorder<EigenReserved> eigen;
    Random random{seed, RandomStream::environment};
    std::uint32_t states;
    std::uint32_t first = 0;
    void prepare() { first = static_cast<std::uint32_t>(random.below(states - 999)); }
};

/// The sum over successors of s' + N(s,a,s') for all a.
Match scanning_successors(const SlipperyGrid& grid) {
    auto scanned = std::make_shared<Scanned>(grid);
    auto sums = std::make_shared<std::array<double, 3>>();
    Match match;
    match.prepare = [=] { scanned->prepare(); };
    match.rivals.push_back({"library", [=] {
        std::uint64_t sum = 0;
        const auto& counts = scanned->library.counts().counts();
        const std::uint64_t edges = scan_all(scanned->first, [&](std::uint32_t s) {
            counts.for_each_successor(StateId{s}, [&](const auto& successor) {
                sum += index(successor.state());
                for (std::uint32_t a = 0; a < actions; ++a) sum += successor.n(ActionId{a});
            });
            return counts.out_degree(StateId{s});
        });
        (*sums)[0] = static_cast<double>(sum);
        return edges;
    }});
    match.rivals.push_back({"floor", [=] {
        std::uint64_t sum = 0, edges = 0;
        scan_all(scanned->first, [&](std::uint32_t s) {
            scanned->floor.counts().counts().for_each_successor(s, [&](std::uint32_t next, const auto& count) {
                ++edges;
                sum += next;
                for (const std::uint32_t n : count) sum += n & 0x7FFFFFFFu;
            });
            return 0;
        });
        (*sums)[1] = static_cast<double>(sum);
        return edges;
    }});
    match.disagreement = [=] { return std::fabs((*sums)[0] - (*sums)[1]); };
    return match;
}

/// The sum over the outcomes of (s,a) of s' N(s,a,s'), a by turns.
Match scanning_outcomes(const SlipperyGrid& grid) {
    auto scanned = std::make_shared<Scanned>(grid);
    auto sums = std::make_shared<std::array<double, 3>>();
    Match match;
    match.prepare = [=] { scanned->prepare(); };
    match.rivals.push_back({"library", [=] {
        std::uint64_t sum = 0;
        const auto& counts = scanned->library.counts().counts();
        scan_all(scanned->first, [&](std::uint32_t s) {
            const ActionId a{s % 4};
            counts.for_each_outcome(StateId{s}, a, [&](StateId next, const CountCell& cell) {
                sum += std::uint64_t{index(next)} * cell.count();
            });
            return 0;
        });
        (*sums)[0] = static_cast<double>(sum);
        return std::uint64_t{1000};
    }});
    match.rivals.push_back({"floor", [=] {
        std::uint64_t sum = 0;
        scan_all(scanned->first, [&](std::uint32_t s) {
            scanned->floor.counts().counts().for_each_successor(s, [&](std::uint32_t next, const auto& count) {
                sum += std::uint64_t{next} * (count[s % 4] & 0x7FFFFFFFu);
            });
            return 0;
        });
        (*sums)[1] = static_cast<double>(sum);
        return std::uint64_t{1000};
    }});
    match.rivals.push_back({"eigen", [=] {
        std::uint64_t sum = 0;
        using Matrix = Eigen::SparseMatrix<int, Eigen::RowMajor>;
        const Matrix& counts = scanned->eigen.counts().counts();
        scan_all(scanned->first, [&](std::uint32_t s) {
            for (Matrix::InnerIterator it(counts, static_cast<int>(s * 4 + s % 4)); it; ++it) {
                sum += static_cast<std::uint64_t>(it.col()) * static_cast<std::uint64_t>(it.value());
            }
            return 0;
        });
        (*sums)[2] = static_cast<double>(sum);
        return std::uint64_t{1000};
    }});
    match.disagreement = [=] { return std::fabs((*sums)[0] - (*sums)[1]) + std::fabs((*sums)[0] - (*sums)[2]); };
    return match;
}

Match scanning_predecessors(const SlipperyGrid& grid) {
    auto scanned = std::make_shared<Scanned>(grid);
    auto sums = std::make_shared<std::array<double, 2>>();
    Match match;
    match.prepare = [=] { scanned->prepare(); };
    const auto scan = [=](std::size_t who, auto&& for_each_predecessor) {
        std::uint64_t sum = 0, edges = 0;
        double labels = 0.0;  // not a number, as long as nobody wrote them: read, not compared
        scan_all(scanned->first, [&](std::uint32_t s) {
            for_each_predecessor(s, [&](auto u, double label) {
                ++edges;
                sum += static_cast<std::uint32_t>(u);
                labels += label;
            });
            return 0;
        });
        benchmark::DoNotOptimize(labels);
        (*sums)[who] = static_cast<double>(sum);
        return edges;
    };
    match.rivals.push_back({"library", [=] {
        const auto& counts = scanned->library.counts().counts();
        return scan(0, [&](std::uint32_t s, auto&& f) { counts.for_each_predecessor(StateId{s}, f); });
    }});
    match.rivals.push_back({"floor", [=] {
        const auto& counts = scanned->floor.counts().counts();
        return scan(1, [&](std::uint32_t s, auto&& f) { counts.for_each_predecessor(s, f); });
    }});
    match.disagreement = [=] { return std::fabs((*sums)[0] - (*sums)[1]); };
    return match;
}

// ---- Bytes ----------------------------------------------------------------------------------------------------------

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

/// Another kind of cell, or no reserve.
template <class Cell>
class LibraryOf {
public:
    explicit LibraryOf(std::size_t states) : counts_(states, actions) {}
    void record(const Step& t) {
        counts_.record(StateId{t.state}, ActionId{t.action}, StateId{t.next}, t.terminated);
    }
    [[nodiscard]] double n(const Step& t) const {
        return static_cast<double>(counts_.n(StateId{t.state}, ActionId{t.action}, StateId{t.next}));
    }
    [[nodiscard]] std::size_t bytes() const { return counts_.bytes(); }

private:
    TransitionCounts<Cell> counts_;
};

template <class T>
void add_bytes(const std::string& name) {
    for (const Size& size : sizes) {
        const SlipperyGrid grid(size.columns, size.rows);
        benchmark::RegisterBenchmark(("bytes per transition, " + name + "/" + size.name).c_str(),
                                     [grid](benchmark::State& state) { measure_bytes<T>(state, grid); })
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
    }
}

}  // namespace

int main(int argc, char** argv) {
    floors::Tournament tournament;
    for (const Size& size : sizes) {
        const SlipperyGrid grid(size.columns, size.rows);
        tournament.add(std::string("record, known/") + size.name, [=] {
            return recording<Floor, HashMap, EigenReserved>(grid, true, 20000, 0,
                                                            {"library", "floor", "unordered_map", "eigen"});
        });
    }
    for (const Size& size : sizes) {
        const SlipperyGrid grid(size.columns, size.rows);
        const std::size_t turn = std::min<std::size_t>(20 * grid.states(), 200000);
        tournament.add(std::string("record, growing/") + size.name, [=] {
            return recording<Floor, Unreserved, HashMap, EigenReserved>(
                grid, false, turn, 20 * grid.states(), {"library", "floor", "unreserved", "unordered_map", "eigen"});
        });
    }
    for (const Size& size : {Size{"1e3", 40, 25}, Size{"4e3", 80, 50}}) {
        const SlipperyGrid grid(size.columns, size.rows);
        tournament.add(std::string("record, growing, eigen without reserve/") + size.name, [=] {
            const std::size_t life = 5 * grid.states();
            return recording<EigenUnreserved>(grid, false, life, life, {"library", "eigen"});
        }, 15);
    }
    for (const Size& size : sizes) {
        const SlipperyGrid grid(size.columns, size.rows);
        tournament.add(std::string("successor/") + size.name, [=] { return scanning_successors(grid); });
        tournament.add(std::string("outcomes of (s,a)/") + size.name, [=] { return scanning_outcomes(grid); });
        tournament.add(std::string("predecessor/") + size.name, [=] { return scanning_predecessors(grid); });
    }
    add_bytes<LibraryOf<CountCell>>("CountCell");
    add_bytes<LibraryOf<FadingCell>>("FadingCell");
    add_bytes<Floor>("floor");
    add_bytes<HashMap>("unordered_map");
    add_bytes<EigenReserved>("eigen");
    return tournament.run(argc, argv);
}

// Found (g++ 12, -O2, two shared and busy cores; medians of library / other, one run):
//
//     states                          1e3     1e4     1e5     1e6    bound
//     record, known / floor          0.45    0.83    1.04    0.98     1.3
//     record, growing / floor        1.03    1.08    1.26    1.56     1.5
//     record, known / unordered_map  0.28    0.17    0.30    0.29
//     record, known / eigen          0.32    0.64    0.77    0.72     room reserved for every outcome
//     record, growing / unordered_map 0.46   0.43    0.35    0.35
//     successor / floor              3.88    3.62    2.34    2.10
//     outcomes of (s,a) / floor      1.46    3.01    2.06    1.86
//     predecessor / floor            1.24    1.22    1.14    1.08
//     bytes, CountCell               30.9    31.9    31.6    31.5      36
//     bytes, FadingCell              88.6    90.7    90.3    90.2
//     bytes, floor / unordered_map   30 / 41 30 / 39 30 / 37 30 / 35
//
// Eigen without reserve costs 143 ns a record at 1e3 states and 476 at 4e3, the library 42 and 49. A known record takes
// 52 instructions, with 1e4 states as with 1e6. Growing misses its bound by a hair at 1e6: the library meets its memory
// untouched within the turn, the floor's was written when it was made. Scans in order of states pay for that layout: a
// state's predecessors no longer lie next to the next state's, and successors carry all that a Successor can tell.
