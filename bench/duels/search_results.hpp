// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

/// \file
/// What came out of races of searches, and the tables of it.

namespace sspql::duels {

/// Medians of one case, in ns per (n + m), by contender.
struct SearchResult {
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

/// Geometric mean and greatest of a ratio over some results.
struct Ratio {
    double mean = std::nan("");
    double greatest = 0.0;
};

template <class Wanted>
Ratio ratio(const std::vector<SearchResult>& results, const std::string& ours, const std::string& rival,
            const Wanted& wanted) {
    double sum = 0.0;
    double greatest = 0.0;
    std::size_t count = 0;
    for (const SearchResult& result : results) {
        const double r = result.of(ours) / result.of(rival);
        if (!wanted(result) || !(r > 0.0)) continue;
        sum += std::log(r);
        greatest = std::max(greatest, r);
        ++count;
    }
    if (count == 0) return {};
    return {std::exp(sum / static_cast<double>(count)), greatest};
}

inline void print_times(const std::vector<SearchResult>& results) {
    std::fprintf(stderr, "\nns per (n + m), medians\n");
    for (const auto& [name, ns] : results.front().time) std::fprintf(stderr, "  %s\n", name.c_str());
    for (const SearchResult& result : results) {
        std::fprintf(stderr, "%-15s %8zu", result.family.c_str(), result.n);
        for (const auto& [name, ns] : result.time) std::fprintf(stderr, " %7.2f", ns);
        std::fprintf(stderr, "\n");
    }
}

inline void print_ratios(const std::vector<SearchResult>& results) {
    const auto usual = [](const SearchResult& r) { return r.grid_or_random; };
    const auto large = [](const SearchResult& r) { return r.grid_or_random && r.n >= 90000; };
    const auto all = [](const SearchResult&) { return true; };
    struct Line {
        const char* ours;
        const char* rival;
        const char* over;
        Ratio ratio;
        double asked;
    };
    const char* const usually = "grids and random graphs";
    const Line lines[] = {
        {"auto", "Boost rows", usually, ratio(results, "auto", "Boost rows", usual), 0.40},
        {"auto", "Boost both ways", usually, ratio(results, "auto", "Boost both ways", usual), 0.20},
        {"auto", "LEMON binary", usually, ratio(results, "auto", "LEMON binary", usual), 0.40},
        {"auto", "BFS", "the same, n >= 1e5", ratio(results, "auto", "BFS", large), 4.0},
        {"ring<Fibonacci>", "Fibonacci", "all families", ratio(results, "ring<Fibonacci>", "Fibonacci", all), 0.60},
        {"Fibonacci", "LEMON Fibonacci", "all families", ratio(results, "Fibonacci", "LEMON Fibonacci", all), 0.85},
        {"Fibonacci", "Boost rows, Boost.Heap Fibonacci", "all families",
         ratio(results, "Fibonacci", "Boost rows, Boost.Heap Fibonacci", all), 0.85},
    };
    std::fprintf(stderr, "\n%-52s %-25s %6s %8s %6s\n", "ratio of medians", "over", "mean", "greatest", "asked");
    for (const Line& line : lines) {
        const std::string name = std::string(line.ours) + " / " + line.rival;
        std::fprintf(stderr, "%-52s %-25s %6.2f %8.2f %6.2f\n", name.c_str(), line.over, line.ratio.mean,
                     line.ratio.greatest, line.asked);
    }
    for (const SearchResult& result : results) {
        if (result.family != "grid" || result.n < 1000000) continue;
        std::fprintf(stderr, "grid of %zu states, auto: %.3f us a state (asked: 0.12)\n", result.n,
                     1e-3 * result.of("auto") * result.per_state);
    }
}

}  // namespace sspql::duels
