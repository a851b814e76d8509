// g++ -std=c++17 -O2 -I include -I /usr/include/eigen3 examples/01_first_steps.cpp -o first_steps && ./first_steps
#include <algorithm>
#include <array>
#include <iostream>
#include <sspql/sspql.hpp>

using Cell = std::array<int, 2>;
struct Room {  // 8 x 8 cells, the charger in the far corner; one move in ten goes astray
    Cell at{};
    sspql::Random chance{0};
    Cell reset(std::uint64_t seed) { return chance = sspql::Random(seed), at = {0, 0}; }
    sspql::Step<Cell> step(Cell move) {
        if (chance.chance(0.1)) std::swap(move[0], move[1]);
        at = {std::clamp(at[0] + move[0], 0, 7), std::clamp(at[1] + move[1], 0, 7)};
        const bool home = at == Cell{7, 7};
        return {at, home ? 1.0 : 0.0, home, false};  // observation, reward, terminated, truncated
    }
};

int main() {
    Room room;
    sspql::UniformGrid<2> states({{{0, 8, 8}, {0, 8, 8}}});
    sspql::ActionTable<Cell> actions{{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    const auto learn = [&](auto robot, const char* name) {
        for (const auto& episode : sspql::run_episodes(room, robot, 15, 1)) std::cout << episode.steps << ' ';
        std::cout << name << '\n';
    };
    learn(sspql::Agent(states, actions), "the adaptive planner");
    learn(sspql::Agent(states, actions, sspql::paper()), "SSPQL as published");
    learn(sspql::Agent(states, actions, sspql::QLearningParams<>{}), "Q-learning");
}
