// SPDX-License-Identifier: MIT
// What Python must do to the bit, done in C++. `python_parity DIRECTORY` lets three learners loose in the maze of
// maze.py; for each it prints a line, "NAME STEPS STEPS ...", and writes a checkpoint, Q and the counts to DIRECTORY.
// With a second argument it loads NAME.python.sspql from there, goes on, and prints the same.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
#include <string>

#include <sspql/core/ids.hpp>
#include <sspql/env/environment.hpp>
#include <sspql/io/checkpoint.hpp>
#include <sspql/io/npy.hpp>
#include <sspql/learn/adaptive_sspql.hpp>
#include <sspql/learn/q_learning.hpp>
#include <sspql/learn/sspql.hpp>
#include <sspql/run/episode.hpp>

namespace {

using sspql::ActionId;
using sspql::StateId;

class Maze {
public:
    StateId reset(std::uint64_t seed) {
        chance_ = seed;
        row_ = column_ = 0;
        return state();
    }
    sspql::Step<StateId> step(ActionId a) {
        std::size_t move = sspql::index(a);
        if (draw(100) < 10) move = draw(4);
        constexpr std::array<int, 4> down{-1, 1, 0, 0};
        constexpr std::array<int, 4> right{0, 0, -1, 1};
        const int row = row_ + down[move];
        const int column = column_ + right[move];
        if (row >= 0 && row < 7 && column >= 0 && column < 7 && at(row, column) != '#') {
            row_ = row;
            column_ = column;
        }
        const bool home = row_ == 6 && column_ == 6;
        return {state(), home ? 1.0 : 0.0, home, false};
    }

private:
    static char at(int row, int column) {
        constexpr std::array<const char*, 7> map{"S..#...", ".#.#.#.", ".#...#.", ".###.#.",
                                                 "...#.#.", ".#...#.", "...#..G"};
        return map[static_cast<std::size_t>(row)][column];
    }
    [[nodiscard]] StateId state() const { return sspql::state_id(static_cast<std::size_t>(7 * row_ + column_)); }
    std::size_t draw(std::uint64_t n) {
        chance_ = chance_ * 6364136223846793005u + 1442695040888963407u;
        return static_cast<std::size_t>((chance_ >> 33) % n);
    }

    std::uint64_t chance_ = 0;
    int row_ = 0;
    int column_ = 0;
};

template <class Learner>
void run(const std::string& directory, const std::string& name, bool go_on, typename Learner::Params params = {}) {
    Maze maze;
    Learner learner(49, 4, params, 7);
    if (go_on) sspql::load(directory + "/" + name + ".python.sspql", learner);
    std::cout << name;
    for (const auto& episode : sspql::run_episodes(maze, learner, 20, go_on ? 200 : 100))
        std::cout << ' ' << episode.steps;
    std::cout << '\n';
    sspql::save(learner, directory + "/" + name + ".sspql");
    sspql::save_npy(directory + "/" + name + ".q.npy", learner.q());
    if constexpr (!std::is_same_v<Learner, sspql::QLearning<>>) {
        sspql::save_npy(directory + "/" + name + ".counts.npy", learner.counts());
    }
}

}  // namespace

int main(int argc, char** argv) try {
    const std::string directory = argc > 1 ? argv[1] : ".";
    const bool go_on = argc > 2;
    run<sspql::AdaptiveSspql<>>(directory, "AdaptiveSspql", go_on);
    run<sspql::Sspql<>>(directory, "Sspql", go_on, sspql::SspqlParams<>::without_bonus());
    sspql::QLearningParams<> params;
    params.alpha = sspql::VisitDecay{0.5};
    params.gamma = 0.95;
    run<sspql::QLearning<>>(directory, "QLearning", go_on, params);
} catch (const std::exception& error) {
    std::cerr << "python_parity: " << error.what() << '\n';
    return 2;
}
