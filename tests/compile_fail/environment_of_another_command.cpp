// expect: sspql: this Environment lacks `environment.step(const Command&) -> sspql::Step<Observation>`
// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

struct Wheels {
    double left_m_s, right_m_s;
};
struct Corridor {
    int at = 0;
    int reset(std::uint64_t) { return at = 0; }
    sspql::Step<int> step(const Wheels&) { return {++at, 0.0, at == 7, false}; }
};

int main() {
    Corridor corridor;
    sspql::Agent robot(sspql::EnumState<int>(8), sspql::ActionTable<int>{-1, 1});
    (void)sspql::run_episode(corridor, robot, 1);
    (void)sspql::run_episodes(corridor, robot, 10, 1);
}
