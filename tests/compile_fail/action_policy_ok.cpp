// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

struct Moves {
    std::size_t size() const { return 2; }
    int decode(sspql::ActionId a) const { return a == sspql::action_id(0) ? -1 : 1; }
};

int main() {
    sspql::Agent robot(sspql::EnumState<int>(8), Moves{});
    int move = robot.begin(3);
    move = robot.step(0.0, 3 + move);
    robot.end(1.0, 3 + move, true);
    return robot.best(3);
}
