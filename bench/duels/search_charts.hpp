// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <sspql/paths/dary_heap.hpp>
#include <sspql/paths/fibonacci_heap.hpp>
#include <sspql/paths/queue.hpp>
#include <sspql/paths/ring_queue.hpp>
#include <sspql/paths/shortest_paths.hpp>

#include "duels/search_results.hpp"
#include "paths/search_families.hpp"
#include "report/line_chart.hpp"

/// \file
/// The charts of docs/complexity.md.

namespace sspql::duels {

/// The x of a chart: powers of ten of the number of states.
inline std::vector<double> decades(const std::vector<std::size_t>& sizes) {
    std::vector<double> x;
    for (const std::size_t n : sizes) x.push_back(std::round(std::log10(static_cast<double>(n))));
    return x;
}

inline double work_of(const OperationCounters& counts) { return static_cast<double>(counts.work()); }

/// Work over m + n log2 n on the adversarial family.
template <class Queue, class Work>
report::Series counted(const char* name, const std::vector<std::size_t>& sizes, const Work& work) {
    report::Series series;
    series.name = name;
    series.x = decades(sizes);
    for (const std::size_t size : sizes) {
        const sspql_test::SearchCase c = sspql_test::adversarial_case(size, 64);
        Queue queue;
        ShortestPathTree tree;
        shortest_paths_to(c.graph, {{c.goal}}, queue, tree);
        const auto n = static_cast<double>(c.graph.size());
        series.mean.push_back(work(queue) / (static_cast<double>(c.graph.edges()) + n * std::log2(n)));
    }
    return series;
}

inline report::LineChart counts_chart() {
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

inline report::LineChart times_chart(const std::vector<SearchResult>& results, const std::string& family) {
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
        for (const SearchResult& result : results) {
            if (result.family != family || result.n > 2000000) continue;
            sizes.push_back(result.n);
            series.mean.push_back(result.of(name));
        }
        series.x = decades(sizes);
        if (!series.mean.empty() && !std::isnan(series.mean.front())) chart.series.push_back(std::move(series));
    }
    return chart;
}

}  // namespace sspql::duels
