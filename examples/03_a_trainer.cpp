// g++ -std=c++17 -O2 -I include -I /usr/include/eigen3 examples/03_a_trainer.cpp -o a_trainer && ./a_trainer
// A trainer saves the robot time: a few hints, or the way shown once. Prints the table of docs/teaching.md.
#include <cstdio>
#include <numeric>
#include <sspql/env/grid_world.hpp>
#include <sspql/learn/exact_values.hpp>
#include <sspql/sspql.hpp>
#include <vector>

using sspql::Move;
const sspql::GridMap house = sspql::GridMap::parse(
    "S...........\n"
    "............\n"
    "............\n"
    "########.###\n"
    "............\n"
    "............\n"
    "............\n"
    "###.########\n"
    "............\n"
    "............\n"
    "............\n"
    "...........G\n");
const struct {  // through both doors, and along the last wall to the goal
    std::size_t row, column;
    Move right, wrong;
} hints[] = {{2, 8, Move::down, Move::up}, {3, 8, Move::down, Move::up},    {6, 3, Move::down, Move::up},
             {7, 3, Move::down, Move::up}, {8, 3, Move::right, Move::left}, {11, 9, Move::right, Move::left}};

const struct {
    const char* name;
    double strength;  // of the hints; 0: none
    bool right, shown;
} lessons[] = {{"nothing", 0, false, false},       {"6 hints", 1, true, false},
               {"6 soft hints", 0.1, true, false}, {"the way, once", 0, false, true},
               {"6 wrong hints", 1, false, false}, {"6 soft wrong hints", 0.1, false, false}};

// Somebody who knows the house drives the robot to the goal; the robot looks on.
template <class Robot>
void show_the_way(Robot& robot, sspql::GridWorld world, std::uint64_t seed) {
    const sspql::TransitionTable table = world.table();
    const auto driver = sspql::greedy_policy(table, sspql::optimal_values(table, 0.95), 0.95);
    for (sspql::Step<sspql::StateId> step{world.reset(seed)}; !step.terminated;) {
        const sspql::StateId from = step.observation;
        const sspql::ActionId a = driver[sspql::index(from)];
        step = world.step(Move(sspql::index(a)));
        robot.learner().demonstrate({from, a, step.reward, step.observation, step.terminated});
    }
}

template <class Params>
void measure(const char* name, const Params& params) {
    constexpr int seeds = 50;
    for (const auto& lesson : lessons) {
        std::vector<double> mean(30, 0.0);  // steps of each episode
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            sspql::TimeLimit world(sspql::GridWorld(house, {0.1}), 5000);  // one step in ten goes astray
            const sspql::EnumState<sspql::StateId> states(house.size());
            sspql::Agent robot(states, sspql::EnumActions<Move>(4), params, seed);
            if (lesson.shown) show_the_way(robot, world.environment(), 1000 * seed);
            for (const auto& hint : hints) {
                if (lesson.strength == 0) continue;
                const auto action = sspql::action_id(std::size_t(lesson.right ? hint.right : hint.wrong));
                robot.learner().teach(house.state(hint.row, hint.column), action, lesson.strength);
            }
            const auto episodes = sspql::run_episodes(world, robot, 30, 1000 * seed + 1);
            for (std::size_t k = 0; k < 30; ++k) mean[k] += double(episodes[k].steps) / seeds;
        }
        const auto sum = [&](int from, int to) { return std::accumulate(&mean[0] + from, &mean[0] + to, 0.0); };
        std::printf("| %s | %s | %.0f | %.0f | %.0f | %.0f |\n", name, lesson.name, sum(0, 1), sum(0, 5), sum(0, 30),
                    sum(25, 30) / 5);
    }
}

int main() {
    std::puts("| learner | was told | episode 1 | first 5 | first 30 | one of the last 5 |\n|---|---|---|---|---|---|");
    measure("Q-learning", sspql::QLearningParams<>{});
    measure("prioritized sweeping", sspql::PrioritizedSweepingParams<>{});
    measure("SSPQL", sspql::SspqlParams<>{});
}
