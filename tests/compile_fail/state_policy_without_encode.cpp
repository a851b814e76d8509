// expect: sspql: this StatePolicy lacks `sspql::StateId encode(const Observation&)` for the observation it was given
// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

struct Corridor {
    std::size_t size() const { return 8; }
};

int main() {
    sspql::Agent robot(Corridor{}, sspql::ActionTable<int>{-1, 1});
    int move = robot.begin(3);
    move = robot.step(0.0, 3 + move);
    robot.end(1.0, 3 + move, true);
    return robot.best(3);
}
