// g++ -std=c++17 -O2 -I include -I /usr/include/eigen3 examples/08_learn_from_a_log.cpp -o from_a_log && ./from_a_log
// Learning without the robot: somebody drove it about, every step was logged, and learners make of the log what they
// can. With a directory as argument the log is written there, else into the current one.
#include <cstdio>
#include <exception>
#include <sspql/env/grid_world.hpp>
#include <sspql/io/replay.hpp>
#include <sspql/io/step_log.hpp>
#include <sspql/learn/adaptive_sspql.hpp>
#include <sspql/learn/q_learning.hpp>
#include <string>

const sspql::GridMap yard = sspql::GridMap::parse(
    "S...#.....\n"
    "....#..#..\n"
    "....#..#..\n"
    ".......#..\n"
    "....#..#..\n"
    "....#..#.G\n");

// Ten drives of somebody who does not know the way and has all day.
void drive_about(const std::string& path) {
    std::remove(path.c_str());  // else the log would be continued
    sspql::StepLog log(path);
    sspql::GridWorld world(yard, {0.1});  // one step in ten goes astray
    sspql::Random hand(7);
    for (std::uint64_t drive = 1; drive <= 10; ++drive) {
        sspql::StateId from = world.reset(drive);
        for (bool there = false; !there;) {
            const auto action = sspql::action_id(hand.below(4));
            const auto step = world.step(sspql::Move(index(action)));
            log.write({from, action, step.reward, step.observation, step.terminated});
            from = step.observation;
            there = step.terminated;
        }
    }
    log.close();  // tells what could not be written
}

// What it would do now: 100 drives without learning, at most 300 steps each.
template <class Learner>
void test(const Learner& learner, const char* name) {
    int arrived = 0, steps = 0;
    for (std::uint64_t drive = 1; drive <= 100; ++drive) {
        sspql::GridWorld world(yard, {0.1});
        sspql::StateId at = world.reset(1000 + drive);
        for (int k = 1; k <= 300; ++k) {
            const auto step = world.step(sspql::Move(index(learner.best(at))));
            at = step.observation;
            if (!step.terminated) continue;
            ++arrived;
            steps += k;
            break;
        }
    }
    std::printf("%-34s arrives in %3d of 100 drives, after %.1f steps on average\n", name, arrived,
                arrived > 0 ? double(steps) / arrived : 0.0);
}

int main(int argc, char** argv) try {
    const std::string path = (argc > 1 ? std::string(argv[1]) + "/" : "") + "drives.csv";
    drive_about(path);

    sspql::AdaptiveSspql<> planner(yard.size(), 4);
    const sspql::StepLogContent content = sspql::replay(path, planner);
    std::printf("%llu drives by hand took %.1f steps on average\n", static_cast<unsigned long long>(content.episodes),
                double(content.steps) / double(content.episodes));
    test(planner, "the planner, from the log");

    sspql::QLearning<> values(yard.size(), 4);
    sspql::replay(path, values);
    test(values, "Q-learning, from the log");
    for (int k = 0; k < 9; ++k) sspql::replay(path, values);
    test(values, "Q-learning, the log ten times over");
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
}
