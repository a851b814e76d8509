// g++ -std=c++17 -O2 -I include -I /usr/include/eigen3 examples/07_resume.cpp -o resume && ./resume robot.sspql
// A robot whose own loop owns the time, and that may be switched off at any moment. Only legal commands are chosen.
// After every episode it saves what it learnt and how far it got; started again it goes on from there, to the bit: kill
// it (kill -9) as often as you like, its last line is always the same.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <sspql/io/checkpoint.hpp>
#include <sspql/learn/agent.hpp>
#include <sspql/spaces/hashed_state.hpp>
#include <string>
#include <utility>

using Cell = std::array<int, 2>;
const sspql::ActionTable<Cell> moves{{1, 0}, {-1, 0}, {0, 1}, {0, -1}};

struct Robot {  // in a room of 20 x 20 cells, the charger in the far corner; one move in ten goes astray
    Cell at{0, 0};
    sspql::Random chance;
    bool inside(Cell cell) const { return cell[0] >= 0 && cell[0] < 20 && cell[1] >= 0 && cell[1] < 20; }
    Cell moved(Cell move) const { return {at[0] + move[0], at[1] + move[1]}; }
    void drive(Cell move) {
        if (chance.chance(0.1)) std::swap(move[0], move[1]);
        if (inside(moved(move))) at = moved(move);
    }
    bool home() const { return at == Cell{19, 19}; }
    sspql::ActionSet legal() const {  // its bumpers say where it must not go
        auto set = sspql::ActionSet::all(4);
        for (std::size_t a = 0; a < 4; ++a) {
            if (!inside(moved(moves.decode(sspql::action_id(a))))) set.erase(sspql::action_id(a));
        }
        return set;
    }
};

struct CellHash {
    std::size_t operator()(const Cell& cell) const { return static_cast<std::size_t>(cell[0] * 31 + cell[1]); }
};

struct Diary {  // saved in the same file as what was learnt: the two are never out of step
    std::uint64_t episodes = 0, steps = 0;
    template <class Archive>
    void serialize(Archive& archive) {
        archive(episodes, steps);
    }
};

int main(int argc, char** argv) try {
    const std::string path = argc > 1 ? argv[1] : "robot.sspql";
    const std::uint64_t last = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 40;

    // The number of cells is not known beforehand: they are discovered, and saved with the rest.
    sspql::Agent brain(sspql::HashedState<Cell, CellHash>{}, moves);
    Diary diary;
    if (argc > 1 && std::filesystem::exists(path)) sspql::load(path, brain, diary);
    if (diary.episodes > 0)
        std::printf("going on after %llu episodes\n", static_cast<unsigned long long>(diary.episodes));

    while (diary.episodes < last) {
        Robot robot{{0, 0}, sspql::Random(++diary.episodes)};
        Cell move = brain.begin(robot.at, robot.legal());
        for (;;) {
            robot.drive(move);  // takes as long as it takes: nobody but this loop calls the brain
            ++diary.steps;
            if (robot.home()) break;
            move = brain.step(0.0, robot.at, robot.legal());
        }
        brain.end(1.0, robot.at, true);  // after an emergency stop: brain.abort()
        sspql::save(brain, path, diary);
    }
    std::printf("%llu episodes, %llu steps, %zu cells\n", static_cast<unsigned long long>(diary.episodes),
                static_cast<unsigned long long>(diary.steps), brain.states().size());
} catch (const std::exception& error) {
    std::fprintf(stderr, "resume: %s\n", error.what());
    return 2;
}
