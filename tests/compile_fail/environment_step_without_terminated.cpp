// expect: sspql: `environment.step(command)` must return the members observation, reward, terminated and truncated (sspql::Step<Observation> has them)
// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

struct GymStep {
    int observation;
    double reward;
    bool done;
    bool truncated;
};
struct Corridor {
    int at = 0;
    int reset(std::uint64_t) { return at = 0; }
    GymStep step(int move) { return {at += move, 0.0, at == 7, false}; }
};

int main() {
    Corridor corridor;
    sspql::Agent robot(sspql::EnumState<int>(8), sspql::ActionTable<int>{-1, 1});
    (void)sspql::run_episode(corridor, robot, 1);
    (void)sspql::run_episodes(corridor, robot, 10, 1);
}
