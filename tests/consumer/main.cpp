// SPDX-License-Identifier: MIT
// A robot in a corridor of ten cells: prints the steps of its episodes; exits with 1 if it has not learnt the way.
#include <cstdio>

#include <sspql/sspql.hpp>

int main() {
    sspql::AdaptiveSspql<> robot(10, 2, {}, 1);
    int steps = 0;
    for (int episode = 0; episode < 10; ++episode) {
        std::uint32_t cell = 0;
        sspql::ActionId action = robot.begin(sspql::StateId{cell});
        for (steps = 1;; ++steps) {
            if (action == sspql::ActionId{1}) ++cell;
            if (action == sspql::ActionId{0} && cell > 0) --cell;
            if (cell == 9 || steps == 1000) break;
            action = robot.step(0.0, sspql::StateId{cell});
        }
        robot.end(cell == 9 ? 1.0 : 0.0, sspql::StateId{cell}, cell == 9);
        std::printf("%d ", steps);
    }
    std::printf("steps with sspql %s\n", SSPQL_VERSION);
    return steps == 9 ? 0 : 1;
}
