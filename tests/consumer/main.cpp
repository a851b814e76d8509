// SPDX-License-Identifier: MIT
#include <cstdio>

#include <sspql/sspql.hpp>

int main() {
    sspql::Random random(1);
    std::printf("sspql %s drew %zu\n", SSPQL_VERSION, random.below(6));
}
