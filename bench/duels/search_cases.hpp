// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "paths/search_families.hpp"

namespace sspql::duels {

inline constexpr double factor_55 = 1.74;  // decades

/// A family of graphs on which searches race.
struct Family {
    const char* name;
    sspql_test::SearchCase (*make)(std::size_t n);
    std::size_t largest;  // in a default run
    bool grid_or_random;  // those the summary is about
};

inline const Family families[] = {
    {"grid", [](std::size_t n) { return sspql_test::grid_case(n, false); }, 1000000, true},
    {"shuffled grid", [](std::size_t n) { return sspql_test::shuffled(sspql_test::grid_case(n, false)); }, 1000000,
     true},
    {"random 4", [](std::size_t n) { return sspql_test::random_case(n, 4, factor_55); }, 1000000, true},
    {"random 16", [](std::size_t n) { return sspql_test::random_case(n, 16, factor_55); }, 100000, true},
    {"star", [](std::size_t n) { return sspql_test::star_case(n); }, 100000, false},
    {"adversarial 64", [](std::size_t n) { return sspql_test::adversarial_case(n, 64); }, 10000, false},
    {"six decades", [](std::size_t n) { return sspql_test::random_case(n, 4, 6.0); }, 100000, false},
};

}  // namespace sspql::duels
