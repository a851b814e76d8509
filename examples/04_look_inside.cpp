// g++ -std=c++17 -O2 -I include -I /usr/include/eigen3 examples/04_look_inside.cpp -o look_inside && ./look_inside
// The adaptive planner in a maze whose wall moves, and what it tells about itself. Quoted by docs/adaptive.md.
#include <array>
#include <cstdio>
#include <iostream>
#include <sspql/env/grid_maps.hpp>
#include <sspql/io/explain.hpp>
#include <sspql/sspql.hpp>
#include <string>

using sspql::Move;

int main() {
    sspql::ChangingGridWorld maze = sspql::grid_task("blocking-maze").changing_world();
    const sspql::EnumState<sspql::StateId> states(maze.size());
    const sspql::EnumActions<Move> moves(4);

    sspql::Agent robot(states, moves);                      // the adaptive planner, nothing to tune
    sspql::Agent published(states, moves, sspql::paper());  // the method of the paper

    sspql::AdaptiveParams<> careful;               // the same planner on a slow computer, which may
    careful.budget = sspql::StepBudget(20, 500);   // touch 20 edges a step, 500 if it has saved them,
    careful.slice = 1000;                          // and does big jobs in small pieces;
    careful.trust.tau = 100;                       // and where shortcuts open now and then
    sspql::Agent slow(states, moves, careful, 1);  // 1: the seed
    slow.learner().reserve(maze.size());           // from now on no step allocates

    std::size_t met = 0;  // the episode in which the wall is met
    for (std::size_t k = 1; met == 0 || k < met + 8; ++k) {
        const std::size_t steps = sspql::run_episode(maze, robot, k).steps;
        if (met == 0 && maze.changes_made() > 0) met = k;
        if (k <= 5 || (met != 0 && k >= met)) std::printf("episode %zu: %zu steps\n", k, steps);
    }

    const sspql::AdaptiveStatus status = robot.learner().status();
    std::printf("%llu alarms in %llu steps; %zu (s,a) tried in %zu states\n",
                static_cast<unsigned long long>(status.alarms), static_cast<unsigned long long>(status.steps),
                status.pairs_tried, status.states_known);
    std::printf("an episode takes %.0f steps; what was not tried may be %.1f from the goal\n", status.typical_cost,
                status.optimism);
    std::printf("%.1f edges touched per step, noise %.3f\n",
                static_cast<double>(status.edge_touches) / static_cast<double>(status.steps), status.noise);

    const sspql::StateId start = maze.reset(0);
    for (const Move move : {Move::up, Move::down, Move::left, Move::right}) {
        const sspql::ActionTerms why = robot.terms(start, sspql::action_id(static_cast<std::size_t>(move)));
        std::printf("  move %d: %.3f from the way, %.3f for seldom tried, tried %.0f times\n", static_cast<int>(move),
                    why.q, why.exploration, why.n);
    }
    std::printf("the goal is %.0f steps away\n", robot.learner().path_length(start));

    // The same, and where each action leads: a table to read at the bench. Cells are row,column from above.
    const sspql::GridMap& map = maze.world().map();
    sspql::ExplainOptions words;
    words.state = [&](sspql::StateId s) { return std::to_string(map.row(s)) + "," + std::to_string(map.column(s)); };
    words.action = [](sspql::ActionId a) { return std::array{"up", "down", "left", "right"}[index(a)]; };
    std::cout << '\n' << sspql::explain(robot, start, words);
}
