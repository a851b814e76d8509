// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "clock.hpp"

/// \file
/// Rivals that take turns in one process, for benchmarks whose answer is a ratio: times drift on a busy machine, ratios
/// of neighbouring turns do not.

namespace sspql::floors {

/// One who takes part: does a turn's work and returns how many operations that was.
struct Rival {
    std::string name;
    std::function<std::uint64_t()> work;
};

/// What is compared. `prepare` makes the next turn's work, the same for all; the first rival is the library.
struct Match {
    std::function<void()> prepare;
    std::vector<Rival> rivals;
    std::function<double()> disagreement = [] { return 0.0; };  ///< must stay within 1e-12
    std::vector<std::pair<std::string, double>> facts = {};     ///< measured once: bytes, sizes
};

/// All matches of a program: registers them with Google Benchmark, keeps what came out, prints it. A match is made when
/// its turn comes and dropped for the next one's.
class Tournament {
public:
    /// \param turns that are taken; 0: until the library's took 0.3 seconds.
    void add(const std::string& name, std::function<Match()> make, int turns = 0) {
        results_.push_back(std::make_unique<Result>());
        Result& result = *results_.back();
        result.name = name;
        auto* registered = benchmark::RegisterBenchmark(
            name.c_str(), [this, make = std::move(make), &result](benchmark::State& state) {
                if (playing_ != &result) {
                    match_.reset();
                    match_ = std::make_unique<Match>(make());
                    playing_ = &result;
                }
                play(state, result);
            });
        registered->UseManualTime()->Unit(benchmark::kMicrosecond);
        if (turns > 0) {
            registered->Iterations(turns);
        } else {
            registered->MinTime(0.3);
        }
    }

    void print() const {
        std::fprintf(stderr, "\n%-40s %10s   %s\n", "ns per operation, medians", "library", "others (library / other)");
        for (const auto& result : results_) {
            if (result->ns.empty()) continue;
            std::fprintf(stderr, "%-40s %10.1f  ", result->name.c_str(), median(result->ns[0]));
            for (std::size_t i = 1; i < result->ns.size(); ++i) {
                std::fprintf(stderr, " %s %.1f (%.2f)", result->names[i].c_str(), median(result->ns[i]),
                             median(result->ratio[i]));
            }
            for (const auto& [fact, value] : result->facts) std::fprintf(stderr, " %s %.4g", fact.c_str(), value);
            std::fprintf(stderr, "%s\n", result->disagreement <= 1e-12 ? "" : " THEY DISAGREE");
        }
    }

    /// Median ns per operation of each rival; empty for what did not run.
    [[nodiscard]] std::vector<double> medians(const std::string& name) const {
        std::vector<double> medians;
        for (const auto& result : results_) {
            if (result->name != name) continue;
            for (const std::vector<double>& ns : result->ns) medians.push_back(median(ns));
        }
        return medians;
    }

    /// Runs what the command line asks for, and prints. \returns the program's exit code.
    int run(int argc, char** argv) {
        benchmark::Initialize(&argc, argv);
        if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
        benchmark::RunSpecifiedBenchmarks();
        benchmark::Shutdown();
        print();
        return 0;
    }

private:
    struct Result {
        std::string name;
        std::vector<std::string> names;
        std::vector<std::vector<double>> ns;     // of each rival, a number a turn
        std::vector<std::vector<double>> ratio;  // library / rival
        std::vector<std::pair<std::string, double>> facts;
        double disagreement = 0.0;
    };

    void play(benchmark::State& state, Result& result) {
        const std::size_t rivals = match_->rivals.size();
        result.names.clear();
        for (const Rival& rival : match_->rivals) result.names.push_back(rival.name);
        result.ns.resize(rivals);
        result.ratio.resize(rivals);
        std::vector<double> seconds(rivals), ns(rivals);
        for (auto _ : state) {
            match_->prepare();
            ++turn_;
            bool idle = false;  // somebody found nothing to do
            for (std::size_t k = 0; k < rivals; ++k) {
                const std::size_t i = (k + turn_) % rivals;
                const double start = cpu_seconds();
                const std::uint64_t done = match_->rivals[i].work();
                seconds[i] = cpu_seconds() - start;
                ns[i] = 1e9 * seconds[i] / static_cast<double>(done);
                idle = idle || done == 0;
            }
            state.SetIterationTime(seconds[0]);
            if (idle) continue;
            for (std::size_t i = 0; i < rivals; ++i) {
                result.ns[i].push_back(ns[i]);
                result.ratio[i].push_back(ns[0] / ns[i]);
            }
        }
        result.disagreement = match_->disagreement();
        if (!(result.disagreement <= 1e-12)) state.SkipWithError("the rivals disagree");
        result.facts = match_->facts;
        for (std::size_t i = 0; i < rivals; ++i) {
            state.counters[result.names[i] + "_ns"] = median(result.ns[i]);
            if (i > 0) state.counters["ratio_" + result.names[i]] = median(result.ratio[i]);
        }
        for (const auto& [fact, value] : result.facts) state.counters[fact] = value;
    }

    std::vector<std::unique_ptr<Result>> results_;
    std::unique_ptr<Match> match_;
    const Result* playing_ = nullptr;
    std::size_t turn_ = 0;
};

}  // namespace sspql::floors
