// SPDX-License-Identifier: MIT
//
// What does it cost that the learners are general? A planning step of Dyna-Q, a backup of prioritized sweeping and a
// step of Q-learning, each against the same learner written by hand for one task (floors/planning_floor.hpp).
//
// A grid of 64, 10 000 and 1 000 000 states, four actions, one step in ten slips; the model is learnt from ten tries of
// every (s,a). Library and floor take turns in one process, on the same steps and the same random numbers, and must
// reach the same values. Times are CPU times; `ratio` is the median over the turns of ours / floor. The summary goes to
// the standard error; for JSON use --benchmark_out=FILE --benchmark_out_format=json.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>
#include <time.h>

#include <sspql/learn/dyna_q.hpp>
#include <sspql/learn/prioritized_sweeping.hpp>
#include <sspql/learn/q_learning.hpp>

#include "floors/planning_floor.hpp"
#include "floors/slippery_grid.hpp"

namespace {

using namespace sspql;
using floors::SlipperyGrid;
using floors::Step;

constexpr double alpha = 0.8;
constexpr double gamma_ = 0.95;
constexpr std::uint32_t tries = 10;
constexpr std::uint64_t seed = 1;

struct Size {
    const char* name;
    std::uint32_t columns;
    std::uint32_t rows;
};
constexpr Size sizes[] = {{"64", 8, 8}, {"1e4", 100, 100}, {"1e6", 1000, 1000}};

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A library's learner that learns the model first and plans afterwards.
template <class Learner>
class Planner : public Learner {
public:
    using Learner::Learner;
    void set_planning_steps(std::size_t steps) { this->params_.planning_steps = steps; }

    void learn_from(const Step& t) {
        Learner::observe(StateId{t.state}, ActionId{t.action}, t.reward, StateId{t.next}, t.terminated);
    }
};

/// Some of the steps of the exploration, spread over the grid, in random order; rewards in [0, 1).
class StepPool {
public:
    explicit StepPool(const SlipperyGrid& grid) : random_(seed, RandomStream::environment) {
        const std::size_t every = std::max<std::size_t>(1, std::size_t{grid.states()} * 4 * tries / most);
        std::size_t i = 0;
        grid.explore(tries, seed, [&](const Step& t) {
            if (i++ % every == 0) steps_.push_back(t);
        });
    }

    Step draw() {
        Step t = steps_[random_.below(steps_.size())];
        t.reward = random_.uniform();
        return t;
    }

private:
    static constexpr std::size_t most = 1 << 16;
    Random random_;
    std::vector<Step> steps_;
};

/// The largest difference between the two tables.
double difference(const QTable& ours, const floors::Values& floor) {
    double largest = 0.0;
    for (std::size_t s = 0; s < ours.states(); ++s) {
        for (std::size_t a = 0; a < floors::actions; ++a) {
            largest = std::max(largest, std::fabs(ours(state_id(s), action_id(a)) - floor[s * floors::actions + a]));
        }
    }
    return largest;
}

// ---- The duels: `turn` prepares one, `ours` and `floor` do the same amount of work and return it --------------------

class DynaQDuel {
public:
    explicit DynaQDuel(const SlipperyGrid& grid)
        : ours_(grid.states(), floors::actions, params(), seed),
          floor_(grid.states(), alpha, gamma_, seed),
          pool_(grid) {
        grid.explore(tries, seed, [this](const Step& t) { ours_.learn_from(t); });
        grid.explore(tries, seed, [this](const Step& t) { floor_.observe(t, 0); });
        ours_.set_planning_steps(planning_steps);
    }

    void turn() { step_ = pool_.draw(); }
    std::uint64_t ours() {
        ours_.learn_from(step_);
        return planning_steps;
    }
    std::uint64_t floor() {
        floor_.observe(step_, planning_steps);
        return planning_steps;
    }
    [[nodiscard]] double disagreement() const { return difference(ours_.q(), floor_.q()); }

private:
    static constexpr std::size_t planning_steps = 2000;

    static DynaQParams<> params() {
        DynaQParams<> params;
        params.alpha = alpha;
        params.gamma = gamma_;
        params.planning_steps = 0;
        return params;
    }

    Planner<DynaQ<>> ours_;
    floors::DynaQ floor_;
    StepPool pool_;
    Step step_{};
};

class SweepingDuel {
public:
    explicit SweepingDuel(const SlipperyGrid& grid)
        : ours_(grid.states(), floors::actions, params(), seed), floor_(grid.states(), gamma_, threshold), pool_(grid) {
        grid.explore(tries, seed, [this](const Step& t) { ours_.learn_from(t); });
        grid.explore(tries, seed, [this](const Step& t) { floor_.observe(t, 0); });
        ours_.set_planning_steps(most_backups);
    }

    /// Rewards that bring the mean reward of (s,a) to a new value in [0, 1): however much was seen, values move.
    void turn() {
        for (Step& t : steps_) {
            t = pool_.draw();
            double sum = 0.0;
            ours_.counts().for_each_successor(StateId{t.state}, [&](const auto& successor) {
                if (const FadingCell* cell = successor.cell(ActionId{t.action})) sum += cell->reward_sum;
            });
            t.reward = t.reward * (ours_.counts().n(StateId{t.state}, ActionId{t.action}) + 1.0) - sum;
        }
    }
    std::uint64_t ours() {
        const std::uint64_t before = ours_.backups();
        for (const Step& t : steps_) ours_.learn_from(t);
        return ours_.backups() - before;
    }
    std::uint64_t floor() {
        const std::uint64_t before = floor_.backups();
        for (const Step& t : steps_) floor_.observe(t, most_backups);
        return floor_.backups() - before;
    }
    [[nodiscard]] double disagreement() const { return difference(ours_.q(), floor_.q()); }

private:
    static constexpr double threshold = 1e-3;
    static constexpr std::size_t most_backups = 1000;

    static PrioritizedSweepingParams<> params() {
        PrioritizedSweepingParams<> params;
        params.gamma = gamma_;
        params.threshold = threshold;
        params.planning_steps = 0;
        return params;
    }

    Planner<PrioritizedSweeping<>> ours_;
    floors::PrioritizedSweeping floor_;
    StepPool pool_;
    std::vector<Step> steps_ = std::vector<Step>(16);
};

/// Both are led through the same random walk, whatever they choose; the choices are compared through the values.
class QLearningDuel {
public:
    explicit QLearningDuel(const SlipperyGrid& grid)
        : grid_(grid),
          ours_(grid.states(), floors::actions, params(), seed),
          floor_(grid.states(), alpha, gamma_, noise, seed),
          random_(seed, RandomStream::environment) {
        static_cast<void>(ours_.begin(StateId{state_}));
        floor_.begin(state_);
    }

    void turn() {
        for (auto& [reward, next] : walk_) {
            state_ = grid_.moved(state_, static_cast<std::uint32_t>(random_.below(4)));
            reward = random_.uniform();
            next = state_;
        }
    }
    std::uint64_t ours() {
        for (const auto& [reward, next] : walk_) static_cast<void>(ours_.step(reward, StateId{next}));
        return walk_.size();
    }
    std::uint64_t floor() {
        for (const auto& [reward, next] : walk_) floor_.step(reward, next);
        return walk_.size();
    }
    [[nodiscard]] double disagreement() const { return difference(ours_.q(), floor_.q()); }

private:
    static constexpr double noise = 0.01;

    static QLearningParams<> params() {
        QLearningParams<> params;
        params.alpha = alpha;
        params.gamma = gamma_;
        params.selector = ActionSelector(noise);
        return params;
    }

    SlipperyGrid grid_;
    QLearning<> ours_;
    floors::QLearning floor_;
    Random random_;
    std::uint32_t state_ = 0;
    std::vector<std::pair<double, std::uint32_t>> walk_ = std::vector<std::pair<double, std::uint32_t>>(2000);
};

// ---- Taking turns ---------------------------------------------------------------------------------------------------

/// Medians over all turns of one case.
struct Result {
    std::string name;
    std::vector<double> ours;   // ns per operation
    std::vector<double> floor;
    std::vector<double> ratio;
    double disagreement = 0.0;
};

std::vector<std::unique_ptr<Result>> results;

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

template <class Duel>
void run(benchmark::State& state, const Size& size, std::shared_ptr<Duel>& duel, Result& result) {
    if (!duel) duel = std::make_shared<Duel>(SlipperyGrid(size.columns, size.rows));
    const auto timed = [](auto&& work) {
        const double start = cpu_seconds();
        const auto done = static_cast<double>(work());
        const double seconds = cpu_seconds() - start;
        return std::pair(1e9 * seconds / done, seconds);
    };
    bool first = false;
    for (auto _ : state) {
        duel->turn();
        first = !first;
        std::pair<double, double> ours;
        std::pair<double, double> floor;
        if (first) ours = timed([&] { return duel->ours(); });
        floor = timed([&] { return duel->floor(); });
        if (!first) ours = timed([&] { return duel->ours(); });
        state.SetIterationTime(ours.second);
        if (!(ours.first < 1e9 && floor.first < 1e9)) continue;  // a turn without any operation
        result.ours.push_back(ours.first);
        result.floor.push_back(floor.first);
        result.ratio.push_back(ours.first / floor.first);
    }
    result.disagreement = duel->disagreement();
    if (!(result.disagreement <= 1e-12)) state.SkipWithError("library and floor disagree");
    state.counters["ours_ns"] = median(result.ours);
    state.counters["floor_ns"] = median(result.floor);
    state.counters["ratio"] = median(result.ratio);
}

/// Google Benchmark calls a case several times, each with more turns; the learners go on where they were, and make
/// room for the next case's.
std::function<void()> release_last = [] {};

template <class Duel>
void add(const std::string& what, const Size& size) {
    results.push_back(std::make_unique<Result>());
    Result& result = *results.back();
    result.name = what + " / " + size.name;
    auto duel = std::make_shared<std::shared_ptr<Duel>>();
    benchmark::RegisterBenchmark((what + "/" + size.name).c_str(), [size, duel, &result](benchmark::State& state) {
        if (!*duel) {
            release_last();
            release_last = [duel] { duel->reset(); };
        }
        run<Duel>(state, size, *duel, result);
    })->UseManualTime()->Unit(benchmark::kMicrosecond)->MinTime(0.5);
}

void print_summary() {
    std::fprintf(stderr, "\n%-36s %10s %10s %7s %14s\n", "per operation, medians", "ours", "floor", "ratio",
                 "max |Q - Q'|");
    for (const auto& result : results) {
        if (result->ratio.empty()) continue;
        std::fprintf(stderr, "%-36s %7.1f ns %7.1f ns %7.2f %14.1e\n", result->name.c_str(), median(result->ours),
                     median(result->floor), median(result->ratio), result->disagreement);
    }
}

}  // namespace

int main(int argc, char** argv) {
    for (const Size& size : sizes) add<DynaQDuel>("dyna-q planning step", size);
    for (const Size& size : sizes) add<SweepingDuel>("prioritized sweeping backup", size);
    for (const Size& size : sizes) add<QLearningDuel>("q-learning step", size);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    print_summary();
}

// Found (g++ 12, -O2, two shared and busy cores; medians of ours / floor, range over three runs):
//
//     states                          64          1e4         1e6      bound
//     dyna-q planning step         1.30-1.69   1.50-1.61   1.45-1.49    1.3
//     prioritized sweeping backup     1.52     1.28-1.33   1.25-1.31    1.5
//     q-learning step              2.16-3.11   2.78-3.14   2.62-2.99     -
//
// All values agreed to the last bit. Sweeping keeps its bound from 1e4 states on and misses it by a hair at 64. Dyna-Q
// misses its bound. The likely reason, not isolated: our outcomes lie by (s,s'), a cell for each action, which suits
// searches and predecessors but scatters the outcomes of one (s,a) over several cache lines; the floor has them in one
// block. Limits: the machine was shared, and ours at 64 states took 28 or 48 ns from run to run of the same program.
