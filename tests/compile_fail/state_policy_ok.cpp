// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

struct Corridor {
    std::size_t size() const { return 8; }
    sspql::StateId encode(int cell) const { return sspql::state_id(static_cast<std::size_t>(cell)); }
};

int main() {
    sspql::Agent robot(Corridor{}, sspql::ActionTable<int>{-1, 1});
    int move = robot.begin(3);
    move = robot.step(0.0, 3 + move);
    robot.end(1.0, 3 + move, true);
    return robot.best(3);
}
