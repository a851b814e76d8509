// expect: sspql: this Agent lacks `Command begin(const Observation&)` for this Environment's observation
// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

struct Corridor {
    int at = 0;
    int reset(std::uint64_t) { return at = 0; }
    sspql::Step<int> step(int move) { return {at += move, 0.0, at == 7, false}; }
};
struct Reflex {
    int act(int observation) { return observation < 7 ? 1 : 0; }
};

int main() {
    Corridor corridor;
    Reflex reflex;
    (void)sspql::run_episode(corridor, reflex, 1);
}
