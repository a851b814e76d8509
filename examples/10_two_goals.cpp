// g++ -std=c++17 -O2 -I include -I /usr/include/eigen3 examples/10_two_goals.cpp -o two_goals && ./two_goals
// Two goals of different worth: a charger A that is slow and a charger B that is fast. A goal's offset says how many
// steps further the robot would go for the other one. What was learnt about the house stays when the offsets change.
#include <iostream>
#include <sspql/env/grid_world.hpp>
#include <sspql/learn/agent.hpp>
#include <sspql/run/episode.hpp>
#include <sspql/spaces/enum_state.hpp>
#include <string>

const sspql::GridMap house = sspql::GridMap::parse(
    "G.........#......\n"
    "..........#......\n"
    "..........#......\n"
    ".................\n"
    "..........#......\n"
    "..........#.....G\n");

// From each cell: the charger at which the best actions known arrive.
template <class Robot>
void print_map(Robot& robot) {
    const sspql::GridWorld world(house);
    const sspql::TransitionTable table = world.table();
    for (std::size_t s = 0; s < house.size(); ++s) {
        sspql::StateId at = sspql::state_id(s);
        std::size_t steps = 0;
        while (table.has_actions(at) && ++steps < house.size()) {
            at = table.outcomes(at, robot.learner().best(at))[0].next;
        }
        const sspql::GridCell cell = house.cell(sspql::state_id(s));
        std::cout << (cell == sspql::GridCell::wall ? '#' : table.has_actions(at) ? '?' : index(at) == 0 ? 'A' : 'B');
        if (house.column(sspql::state_id(s)) + 1 == house.columns()) std::cout << '\n';
    }
}

int main() {
    const sspql::StateId slow = house.state(0, 0), fast = house.state(5, 16);
    sspql::GridWorld world(house);  // every cell but the chargers is a start
    sspql::Agent robot(sspql::EnumState<sspql::StateId>(house.size()), sspql::EnumActions<sspql::Move>(4));
    static_cast<void>(sspql::run_episodes(world, robot, 150, 1));  // either charger pays 1: it goes to the nearer one
    std::cout << "learnt from rewards, both alike\n";
    print_map(robot);

    for (const double offset : {0.0, 6.0, 14.0}) {
        robot.learner().set_goals({{slow, offset}, {fast, 0.0}});
        static_cast<void>(sspql::run_episodes(world, robot, 30, 1000));
        std::cout << "A is worth " << offset << " steps less\n";
        print_map(robot);
    }
}
