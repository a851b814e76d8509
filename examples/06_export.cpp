// g++ -std=c++17 -O2 -I include -I /usr/include/eigen3 examples/06_export.cpp -o export && ./export
// What a robot learnt, for other programs: q.npy and counts.npy for NumPy, graph.dot for GraphViz, policy.csv for
// spreadsheets, steps.csv to learn from again. Writes to the directory given, or to the current one.
#include <array>
#include <cstdio>
#include <exception>
#include <sspql/io/dot.hpp>
#include <sspql/io/logged.hpp>
#include <sspql/io/npy.hpp>
#include <sspql/io/policy_csv.hpp>
#include <sspql/io/replay.hpp>
#include <sspql/sspql.hpp>
#include <string>

using sspql::Move;

const char* const rooms =
    "S..#......\n"
    "...#.####.\n"
    ".......#..\n"
    "##.###.#..\n"
    "...#...#.#\n"
    "...#......\n"
    ".....#..#G\n";

struct Moves : sspql::EnumActions<Move> {
    Moves() : EnumActions(4) {}
    std::string describe(sspql::ActionId a) const { return std::array{"up", "down", "left", "right"}[index(a)]; }
};

int main(int argc, char** argv) try {
    const std::string directory = argc > 1 ? std::string(argv[1]) + "/" : "";
    const sspql::GridMap map = sspql::GridMap::parse(rooms);
    sspql::GridWorldParams slippery;
    slippery.slip = 0.15;  // so often a move goes astray, to one side or the other
    slippery.slip_kind = sspql::SlipKind::perpendicular;
    sspql::GridWorld world(map, slippery);

    sspql::Agent robot(sspql::EnumState<sspql::StateId>(map.size()), Moves(), sspql::paper());
    {
        std::remove((directory + "steps.csv").c_str());  // else the log would be continued
        sspql::StepLog log(directory + "steps.csv");
        sspql::Logged logged(robot, log);
        for (std::uint64_t k = 1; k <= 60; ++k) sspql::run_episode(world, logged, k);
        log.close();  // tells what could not be written
    }

    sspql::save_npy(directory + "q.npy", robot.learner().q());
    sspql::save_npy(directory + "counts.npy", robot.learner().counts());
    sspql::save_policy_csv(directory + "policy.csv", robot);

    sspql::DotOptions picture;
    picture.title = "60 episodes in three rooms, 15 % of the moves slip";
    picture.probabilities = false;
    picture.position = [&](sspql::StateId s) {
        return std::array<double, 2>{static_cast<double>(map.column(s)), -static_cast<double>(map.row(s))};
    };
    sspql::save_dot(directory + "graph.dot", robot.learner(), picture);

    sspql::Sspql<> pupil(map.size(), 4);  // learns from the log alone
    const sspql::StepLogContent log = sspql::replay(directory + "steps.csv", pupil);
    std::printf("%llu steps in %llu episodes logged and learnt again, ", static_cast<unsigned long long>(log.steps),
                static_cast<unsigned long long>(log.episodes));
    std::printf("Q is %s\n", pupil.q().matrix() == robot.learner().q().matrix() ? "the same" : "another");
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
