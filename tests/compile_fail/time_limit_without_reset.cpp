// expect: sspql: this Environment lacks `environment.reset(std::uint64_t seed) -> Observation`
// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

struct Corridor {
    int at = 0;
    sspql::Step<int> step(int move) { return {at += move, 0.0, at == 7, false}; }
};

int main() {
    sspql::TimeLimit limited(Corridor{}, 100);
    sspql::Agent robot(sspql::EnumState<int>(8), sspql::ActionTable<int>{-1, 1});
    (void)sspql::run_episode(limited, robot, 1);
}
