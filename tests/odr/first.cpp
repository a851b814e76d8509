// SPDX-License-Identifier: MIT
// Two translation units that include everything: a function that is not inline would be defined twice.
#include <sspql/sspql.hpp>

#include "all_headers.hpp"

std::uint64_t bits_of_the_other(std::uint64_t seed);

int main() { return sspql::Random(1).bits() == bits_of_the_other(1) ? 0 : 1; }
