// SPDX-License-Identifier: MIT
//
// How fast are the shortest paths that a learner finds after every episode: our queues against Boost.Graph, Boost.Heap
// and LEMON, and against floors that no search can pass?
//
// Families: grids (costs as learnt), the same with shuffled states, random graphs (m/n = 4 and 16, costs within a
// factor of 55), a star, a family built for decreases (m/n = 64), and costs over six decades. All contenders take turns
// in one process, on the same edges, with buffers of their own that they may keep; distances must agree to the last
// bit, and our trees too. Times are CPU times; the figures are medians over the turns, the ratios those of medians. The
// summary goes to the standard error; for JSON use --benchmark_out=FILE --benchmark_out_format=json. More options:
//   --largest=N          graphs of up to N states (default 1000000; 4000000 takes minutes and gigabytes)
//   --counts-svg=FILE    draws operations counted over m + n log2 n, on the family built for decreases
//   --times-svg=FILE     draws time per state and edge, grids and random graphs, by number of states

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>
#include <time.h>

#include <sspql/paths/auto_queue.hpp>
#include <sspql/paths/dary_heap.hpp>
#include <sspql/paths/fibonacci_heap.hpp>
#include <sspql/paths/ring_queue.hpp>

#include "paths/search_families.hpp"
#include "report/line_chart.hpp"
#include "report/output_file.hpp"
#include "rivals/boost_rivals.hpp"
#include "rivals/graph_floors.hpp"
#include "rivals/our_queues.hpp"
#if SSPQL_HAS_LEMON
#include "rivals/lemon_rivals.hpp"
#endif

namespace {

using namespace sspql;
using rivals::Contender;
using rivals::Ours;
using sspql_test::SearchCase;

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
    if (values.empty()) return std::nan("");
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// ---- The cases ------------------------------------------------------------------------------------------------------

constexpr double factor_55 = 1.74;  // decades

struct Family {
    const char* name;
    SearchCase (*make)(std::size_t n);
    std::size_t largest;  // in a default run
    bool grid_or_random;  // those the summary is about
};

const Family families[] = {
    {"grid", [](std::size_t n) { return sspql_test::grid_case(n, false); }, 1000000, true},
    {"shuffled grid", [](std::size_t n) { return shuffled(sspql_test::grid_case(n, false)); }, 1000000, true},
    {"random 4", [](std::size_t n) { return sspql_test::random_case(n, 4, factor_55); }, 1000000, true},
    {"random 16", [](std::size_t n) { return sspql_test::random_case(n, 16, factor_55); }, 100000, true},
    {"star", [](std::size_t n) { return sspql_test::star_case(n); }, 100000, false},
    {"adversarial 64", [](std::size_t n) { return sspql_test::adversarial_case(n, 64); }, 10000, false},
    {"six decades", [](std::size_t n) { return sspql_test::random_case(n, 4, 6.0); }, 100000, false},
};

/// Medians of one case, in ns per (n + m), by contender.
struct Result {
    std::string family;
    std::size_t n = 0;
    bool grid_or_random = false;
    double per_state = 1.0;  // (n + m) / n
    std::vector<std::pair<std::string, double>> time;

    [[nodiscard]] double of(const std::string& name) const {
        for (const auto& [contender, ns] : time) {
            if (contender == name) return ns;
        }
        return std::nan("");
    }
};

std::vector<Result> results;

/// Everybody, ready to run on one graph.
class Field {
public:
    explicit Field(SearchCase c) : case_(std::move(c)) {
        add<Ours<AutoQueue<>>>("auto", case_.graph, case_.goal);
        add<Ours<RingQueue<>>>("ring<Fibonacci>", case_.graph, case_.goal);
        add<Ours<FibonacciHeap<>>>("Fibonacci", case_.graph, case_.goal);
        add<Ours<DaryHeap<4>>>("4-ary", case_.graph, case_.goal);
        add<rivals::BoostListDijkstra>(case_.graph, case_.goal);
        add<rivals::BoostBothWaysDijkstra>(case_.graph, case_.goal);
        add<rivals::BoostRowsDijkstra>(case_.graph, case_.goal);
        add<rivals::BoostFibonacciDijkstra>(case_.graph, case_.goal);
#if SSPQL_HAS_LEMON
        lemon_ = std::make_unique<rivals::LemonInput>(case_.graph);
        add<rivals::LemonDijkstra<rivals::LemonBinary>>("LEMON binary", *lemon_, case_.goal);
        add<rivals::LemonDijkstra<rivals::LemonQuaternary>>("LEMON 4-ary", *lemon_, case_.goal);
        add<rivals::LemonDijkstra<rivals::LemonFibonacci>>("LEMON Fibonacci", *lemon_, case_.goal);
#endif
        add<rivals::BreadthFirst>(case_.graph, case_.goal);
        add<rivals::OnePass>(case_.graph);
        seconds_.resize(contenders_.size());
    }

    /// Everybody once, starting with another one each time. \returns the seconds of the first.
    double turn() {
        for (std::size_t i = 0; i < contenders_.size(); ++i) {
            const std::size_t which = (i + turns_) % contenders_.size();
            const double start = cpu_seconds();
            contenders_[which]->run();
            seconds_[which].push_back(cpu_seconds() - start);
        }
        ++turns_;
        return seconds_[0].back();
    }

    /// A turn that does not count, to fetch memory and to compare the answers.
    [[nodiscard]] bool warm_up() {
        for (const auto& contender : contenders_) contender->run();
        const Contender& first = *contenders_.front();
        for (const auto& contender : contenders_) {
            if (!contender->finds_distances()) continue;
            for (std::size_t s = 0; s < case_.graph.size(); ++s) {
                if (contender->distance(s) != first.distance(s)) return false;
            }
        }
        const auto& tree = static_cast<const Ours<AutoQueue<>>&>(first).tree();
        return static_cast<const Ours<RingQueue<>>&>(*contenders_[1]).tree().next == tree.next &&
               static_cast<const Ours<FibonacciHeap<>>&>(*contenders_[2]).tree().next == tree.next &&
               static_cast<const Ours<DaryHeap<4>>&>(*contenders_[3]).tree().next == tree.next;
    }

    [[nodiscard]] Result result(const Family& family) const {
        const auto n = static_cast<double>(case_.graph.size());
        const double touched = n + static_cast<double>(case_.graph.edges());
        Result result{family.name, case_.graph.size(), family.grid_or_random, touched / n, {}};
        for (std::size_t i = 0; i < contenders_.size(); ++i) {
            result.time.emplace_back(contenders_[i]->name(), 1e9 * median(seconds_[i]) / touched);
        }
        return result;
    }

private:
    template <class T, class... Arguments>
    void add(Arguments&&... arguments) {
        contenders_.push_back(std::make_unique<T>(std::forward<Arguments>(arguments)...));
    }

    SearchCase case_;
#if SSPQL_HAS_LEMON
    std::unique_ptr<rivals::LemonInput> lemon_;
#endif
    std::vector<std::unique_ptr<Contender>> contenders_;
    std::vector<std::vector<double>> seconds_;
    std::size_t turns_ = 0;
};

void run(benchmark::State& state, const Family& family, std::size_t n) {
    Field field(family.make(n));
    if (!field.warm_up()) {
        state.SkipWithError("the answers differ");
        return;
    }
    for (auto _ : state) state.SetIterationTime(field.turn());
    results.push_back(field.result(family));
    for (const auto& [name, ns] : results.back().time) {
        state.counters[name + " ns/(n+m)"] = ns;
        state.counters["auto / " + name] = results.back().of("auto") / ns;
    }
}

void add_cases(std::size_t largest) {
    for (const Family& family : families) {
        for (std::size_t n = 1000; n <= largest; n = n == 1000000 ? 4000000 : 10 * n) {
            if (n > family.largest && n <= 1000000) continue;
            if (n > 1000000 && family.largest < 1000000) continue;
            const std::string name = std::string(family.name) + "/" + std::to_string(n);
            benchmark::RegisterBenchmark(name.c_str(), [&family, n](benchmark::State& state) { run(state, family, n); })
                ->UseManualTime()
                ->Unit(benchmark::kMicrosecond)
                ->Iterations(n <= 1000     ? 101
                             : n <= 10000  ? 21
                             : n <= 100000 ? 7
                                           : 3);
        }
    }
}

// ---- The summary ----------------------------------------------------------------------------------------------------

/// Geometric mean and greatest of a ratio over some results.
struct Ratio {
    double mean = std::nan("");
    double greatest = 0.0;
};

template <class Wanted>
Ratio ratio(const std::string& ours, const std::string& rival, const Wanted& wanted) {
    double sum = 0.0;
    double greatest = 0.0;
    std::size_t count = 0;
    for (const Result& result : results) {
        const double r = result.of(ours) / result.of(rival);
        if (!wanted(result) || !(r > 0.0)) continue;
        sum += std::log(r);
        greatest = std::max(greatest, r);
        ++count;
    }
    if (count == 0) return {};
    return {std::exp(sum / static_cast<double>(count)), greatest};
}

void print_times() {
    std::fprintf(stderr, "\nns per (n + m), medians\n");
    for (const auto& [name, ns] : results.front().time) std::fprintf(stderr, "  %s\n", name.c_str());
    for (const Result& result : results) {
        std::fprintf(stderr, "%-15s %8zu", result.family.c_str(), result.n);
        for (const auto& [name, ns] : result.time) std::fprintf(stderr, " %7.2f", ns);
        std::fprintf(stderr, "\n");
    }
}

void print_ratios() {
    const auto usual = [](const Result& r) { return r.grid_or_random; };
    const auto large = [](const Result& r) { return r.grid_or_random && r.n >= 90000; };
    const auto all = [](const Result&) { return true; };
    struct Line {
        const char* ours;
        const char* rival;
        const char* over;
        Ratio ratio;
        double asked;
    };
    const char* const usually = "grids and random graphs";
    const Line lines[] = {
        {"auto", "Boost rows", usually, ratio("auto", "Boost rows", usual), 0.40},
        {"auto", "Boost both ways", usually, ratio("auto", "Boost both ways", usual), 0.20},
        {"auto", "LEMON binary", usually, ratio("auto", "LEMON binary", usual), 0.40},
        {"auto", "BFS", "the same, n >= 1e5", ratio("auto", "BFS", large), 4.0},
        {"ring<Fibonacci>", "Fibonacci", "all families", ratio("ring<Fibonacci>", "Fibonacci", all), 0.60},
        {"Fibonacci", "LEMON Fibonacci", "all families", ratio("Fibonacci", "LEMON Fibonacci", all), 0.85},
        {"Fibonacci", "Boost rows, Boost.Heap Fibonacci", "all families",
         ratio("Fibonacci", "Boost rows, Boost.Heap Fibonacci", all), 0.85},
    };
    std::fprintf(stderr, "\n%-52s %-25s %6s %8s %6s\n", "ratio of medians", "over", "mean", "greatest", "asked");
    for (const Line& line : lines) {
        const std::string name = std::string(line.ours) + " / " + line.rival;
        std::fprintf(stderr, "%-52s %-25s %6.2f %8.2f %6.2f\n", name.c_str(), line.over, line.ratio.mean,
                     line.ratio.greatest, line.asked);
    }
    for (const Result& result : results) {
        if (result.family != "grid" || result.n < 1000000) continue;
        std::fprintf(stderr, "grid of %zu states, auto: %.3f us a state (asked: 0.12)\n", result.n,
                     1e-3 * result.of("auto") * result.per_state);
    }
}

// ---- The charts -----------------------------------------------------------------------------------------------------

/// The x of a chart: powers of ten of the number of states.
std::vector<double> decades(const std::vector<std::size_t>& sizes) {
    std::vector<double> x;
    for (const std::size_t n : sizes) x.push_back(std::round(std::log10(static_cast<double>(n))));
    return x;
}

double work_of(const OperationCounters& counts) { return static_cast<double>(counts.work()); }

/// Work over m + n log2 n on the adversarial family.
template <class Queue, class Work>
report::Series counted(const char* name, const std::vector<std::size_t>& sizes, const Work& work) {
    report::Series series;
    series.name = name;
    series.x = decades(sizes);
    for (const std::size_t size : sizes) {
        const SearchCase c = sspql_test::adversarial_case(size, 64);
        Queue queue;
        ShortestPathTree tree;
        shortest_paths_to(c.graph, {{c.goal}}, queue, tree);
        const auto n = static_cast<double>(c.graph.size());
        series.mean.push_back(work(queue) / (static_cast<double>(c.graph.edges()) + n * std::log2(n)));
    }
    return series;
}

report::LineChart counts_chart() {
    using Fibonacci = FibonacciHeap<OperationCounters>;
    using Ring = RingQueue<Fibonacci, OperationCounters>;
    const std::vector<std::size_t> sizes = {100, 1000, 10000, 100000};
    const auto own = [](const auto& queue) { return work_of(queue.counters()); };
    report::LineChart chart;
    chart.title = "Heap operations over m + n log2 n, where decreases abound";
    chart.x_label = "states, powers of ten";
    chart.y_label = "operations / (m + n log2 n)";
    chart.series.push_back(counted<DaryHeap<2, OperationCounters>>("binary heap", sizes, own));
    chart.series.push_back(counted<DaryHeap<4, OperationCounters>>("4-ary heap", sizes, own));
    chart.series.push_back(counted<Fibonacci>("Fibonacci heap", sizes, own));
    chart.series.push_back(counted<Ring>("ring over a Fibonacci heap", sizes, [](const Ring& queue) {
        return work_of(queue.counters()) + work_of(queue.inner().counters());
    }));
    return chart;
}

report::LineChart times_chart(const std::string& family) {
    report::LineChart chart;
    chart.title = "Time of a solve, family: " + family;
    chart.x_label = "states, powers of ten";
    chart.y_label = "ns per state and edge";
    chart.logarithmic = true;
    const std::pair<const char*, const char*> shown[] = {{"auto", "AutoQueue"},
                                                         {"ring<Fibonacci>", "ring over Fibonacci"},
                                                         {"Fibonacci", "Fibonacci heap"},
                                                         {"Boost rows", "Boost.Graph, compressed rows"},
                                                         {"LEMON binary", "LEMON, binary heap"},
                                                         {"BFS", "breadth-first search"}};
    for (const auto& [name, label] : shown) {
        report::Series series;
        series.name = label;
        std::vector<std::size_t> sizes;
        for (const Result& result : results) {
            if (result.family != family || result.n > 2000000) continue;
            sizes.push_back(result.n);
            series.mean.push_back(result.of(name));
        }
        series.x = decades(sizes);
        if (!series.mean.empty() && !std::isnan(series.mean.front())) chart.series.push_back(std::move(series));
    }
    return chart;
}

struct Options {
    std::size_t largest = 1000000;
    std::string counts_svg;
    std::string times_svg;
};

/// Takes our options out of the list.
Options take_options(int& argc, char** argv) {
    Options options;
    const auto value = [](const std::string& argument, const std::string& name) -> std::optional<std::string> {
        if (argument.rfind(name + "=", 0) != 0) return std::nullopt;
        return argument.substr(name.size() + 1);
    };
    int kept = 1;
    for (int i = 1; i < argc; ++i) {
        if (const auto largest = value(argv[i], "--largest")) {
            options.largest = std::strtoull(largest->c_str(), nullptr, 10);
        } else if (const auto counts = value(argv[i], "--counts-svg")) {
            options.counts_svg = *counts;
        } else if (const auto times = value(argv[i], "--times-svg")) {
            options.times_svg = *times;
        } else {
            argv[kept++] = argv[i];
        }
    }
    argc = kept;
    if (options.largest < 1000 || options.largest > 4000000) {
        throw std::invalid_argument("--largest must lie between 1000 and 4000000");
    }
    for (const std::string* file : {&options.counts_svg, &options.times_svg}) {
        if (!file->empty()) report::require_writable(*file);
    }
    return options;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const Options options = take_options(argc, argv);
        add_cases(options.largest);
        benchmark::Initialize(&argc, argv);
        if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
        benchmark::RunSpecifiedBenchmarks();
        benchmark::Shutdown();
        if (!results.empty()) {
            print_times();
            print_ratios();
        }
        if (!options.times_svg.empty()) {
            report::write_file(options.times_svg, line_chart(times_chart("grid")).document());
        }
        if (!options.counts_svg.empty()) {
            report::write_file(options.counts_svg, line_chart(counts_chart()).document());
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_shortest_paths: %s\n", error.what());
        return 2;
    }
}

// Found (g++ 12 -O2, two shared and busy cores; ratios of medians, geometric mean and worst, range over two runs):
//
//                                                              mean        worst    asked
//     auto / Boost.Graph, compressed rows                   0.37-0.38       0.64     0.40
//     auto / Boost.Graph, both ways and reverse_graph       0.20-0.22    0.37-0.39   0.20
//     auto / LEMON, binary heap                                0.33      0.47-0.50   0.40
//     auto / BFS, n >= 1e5                                  2.45-2.47    3.61-3.71   4
//     ring<Fibonacci> / Fibonacci                              0.45      0.86-0.89   0.60
//     Fibonacci / LEMON's                                   0.75-0.77    0.94-1.02   0.85
//     Fibonacci / Boost.Heap's                              0.79-0.81    0.97-1.03   0.85
//
// All answers agreed to the last bit. A grid of a million states took 0.062 to 0.081 us a state. The gain over
// Boost.Graph is largest where memory is waited for (0.17 to 0.20 on a random graph of a million states) and least at a
// thousand states. Missed: over six decades auto is 1.7 to 2.0 times as slow as our 4-ary heap and Boost.Graph's, the
// price of a Fibonacci heap; the mean against the list both ways lies on its bound.
