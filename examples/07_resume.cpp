// g++ -std=c++17 -O2 -I include -I /usr/include/eigen3 examples/07_resume.cpp -o resume && ./resume robot.sspql
// A robot that may be switched off at any moment. After every episode it saves what it learnt and how far it got; started
// again it goes on from there, to the bit: kill it (kill -9) as often as you like, its last line is always the same.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <sspql/sspql.hpp>

using Cell = std::array<int, 2>;
struct Room {  // 20 x 20 cells, the charger in the far corner; one move in ten goes astray
    Cell at{};
    sspql::Random chance{0};
    Cell reset(std::uint64_t seed) { return chance = sspql::Random(seed), at = {0, 0}; }
    sspql::Step<Cell> step(Cell move) {
        if (chance.chance(0.1)) std::swap(move[0], move[1]);
        at = {std::clamp(at[0] + move[0], 0, 19), std::clamp(at[1] + move[1], 0, 19)};
        const bool home = at == Cell{19, 19};
        return {at, home ? 1.0 : 0.0, home, false};  // observation, reward, terminated, truncated
    }
};

struct CellHash {
    std::size_t operator()(const Cell& cell) const { return static_cast<std::size_t>(cell[0] * 31 + cell[1]); }
};

struct Diary {  // saved in the same file as what was learnt: the two are never out of step
    std::uint64_t episodes = 0;
    std::uint64_t steps = 0;
    template <class Archive>
    void serialize(Archive& archive) {
        archive(episodes, steps);
    }
};

int main(int argc, char** argv) try {
    const std::string path = argc > 1 ? argv[1] : "robot.sspql";
    const std::uint64_t last = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 40;

    Room room;
    // The number of cells is not known beforehand: they are discovered, and saved with the rest.
    sspql::Agent robot(sspql::HashedState<Cell, CellHash>{}, sspql::ActionTable<Cell>{{1, 0}, {-1, 0}, {0, 1}, {0, -1}});
    Diary diary;
    if (argc > 1 && std::filesystem::exists(path)) sspql::load(path, robot, diary);
    if (diary.episodes > 0) std::printf("going on after %llu episodes\n", static_cast<unsigned long long>(diary.episodes));

    while (diary.episodes < last) {
        diary.steps += sspql::run_episode(room, robot, ++diary.episodes).steps;
        sspql::save(robot, path, diary);
    }
    std::printf("%llu episodes, %llu steps, %zu cells\n", static_cast<unsigned long long>(diary.episodes),
                static_cast<unsigned long long>(diary.steps), robot.states().size());
} catch (const std::exception& error) {
    std::fprintf(stderr, "resume: %s\n", error.what());
    return 2;
}
