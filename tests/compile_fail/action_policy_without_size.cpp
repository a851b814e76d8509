// expect: sspql: this ActionPolicy lacks `std::size_t size() const`
// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

struct Moves {
    int decode(sspql::ActionId a) const { return a == sspql::action_id(0) ? -1 : 1; }
};

int main() {
    sspql::Agent robot(sspql::EnumState<int>(8), Moves{});
    int move = robot.begin(3);
    move = robot.step(0.0, 3 + move);
    robot.end(1.0, 3 + move, true);
    return robot.best(3);
}
