// g++ -std=c++17 -O2 -I include -I /usr/include/eigen3 examples/11_mountain_car.cpp -o mountain_car && ./mountain_car
// A continuous observation, end to end: a car too weak for the hill must learn to swing. Position and velocity are cut
// into 16 x 16 cells; a command is held for 4 ticks, so that it mostly leads to another cell.
#include <cstdio>
#include <sspql/env/mountain_car.hpp>
#include <sspql/env/time_limit.hpp>
#include <sspql/learn/agent.hpp>
#include <sspql/run/episode.hpp>
#include <sspql/spaces/action_policy.hpp>

int main() {
    sspql::MountainCarParams params;
    params.ticks = 4;
    sspql::TimeLimit car(sspql::MountainCar(params), 2500);

    sspql::UniformGrid<2> cells = sspql::MountainCar::grid(16);  // {{{-1.2, 0.5, 16}, {-0.07, 0.07, 16}}}
    sspql::Agent driver(cells, sspql::EnumActions<sspql::Throttle>(3));
    for (std::uint64_t k = 1; k <= 100; ++k) {
        const std::size_t steps = sspql::run_episode(car, driver, k).steps;
        if (k <= 10 || k % 10 == 0)
            std::printf("episode %llu: %zu ticks\n", static_cast<unsigned long long>(k), 4 * steps);
    }

    std::printf(
        "what it learnt, position to the right, velocity upwards: < back, > forward, | none, ' ' never there\n");
    const auto& learner = driver.learner();
    for (std::size_t v = 16; v-- > 0;) {
        for (std::size_t x = 0; x < 16; ++x) {
            const sspql::StateId s = sspql::state_id(16 * x + v);
            std::putchar(learner.counts().out_degree(s) == 0 ? ' ' : "<|>"[index(learner.best(s))]);
        }
        std::putchar('\n');
    }
}
