// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

struct Corridor {
    int at = 0;
    int reset(std::uint64_t) { return at = 0; }
    sspql::Step<int> step(int move) { return {at += move, 0.0, at == 7, false}; }
};
struct Reflex {
    auto begin(const int&) { return 1; }
    template <class Observation>
    auto step(double, const Observation& observation) {
        return observation < 7 ? 1 : 0;
    }
    void end(double, int, bool) {}
    void abort() {}
};

int main() {
    Corridor corridor;
    sspql::TimeLimit limited(corridor, 100);
    Reflex reflex;
    (void)sspql::run_episode(corridor, reflex, 1);
    (void)sspql::run_episode(limited, reflex, 1);
}
