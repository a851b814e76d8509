// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

struct OwnStep {
    int battery;
    int observation;
    float reward;
    bool terminated;
    bool truncated;
};
struct Corridor {
    int at = 0;
    int reset(std::uint64_t) { return at = 0; }
    OwnStep step(int move) { return {9, at += move, 0.0f, at == 7, false}; }
};

int main() {
    Corridor corridor;
    sspql::Agent robot(sspql::EnumState<int>(8), sspql::ActionTable<int>{-1, 1});
    (void)sspql::run_episode(corridor, robot, 1);
    (void)sspql::run_episodes(corridor, robot, 10, 1);
}
