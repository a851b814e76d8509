// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

#include "all_headers.hpp"

std::uint64_t bits_of_the_other(std::uint64_t seed);

std::uint64_t bits_of_the_other(std::uint64_t seed) { return sspql::Random(seed).bits(); }
