// expect: sspql: this ActionPolicy lacks `Command decode(sspql::ActionId) const`
// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

struct Moves {
    std::size_t size() const { return 2; }
};

int main() {
    sspql::Agent robot(sspql::EnumState<int>(8), Moves{});
    const auto move = robot.begin(3);
    (void)robot.step(0.0, 3);
    robot.end(1.0, 3, true);
    (void)robot.best(3);
    (void)move;
}
