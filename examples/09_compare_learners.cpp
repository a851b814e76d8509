// g++ -std=c++17 -O2 -I include -I /usr/include/eigen3 examples/09_compare_learners.cpp -o compare && ./compare
// Which learner needs the fewest steps? Many seeds, the same worlds for all, means with their standard errors, and z:
// by how many standard errors of the difference a learner is off the first. More tasks and learners: grid_experiment.
#include <cstdio>
#include <sspql/env/tabular_environment.hpp>
#include <sspql/env/windy.hpp>
#include <sspql/learn/adaptive_sspql.hpp>
#include <sspql/learn/agent.hpp>
#include <sspql/learn/prioritized_sweeping.hpp>
#include <sspql/learn/q_learning.hpp>
#include <sspql/run/episode.hpp>
#include <sspql/run/statistics.hpp>
#include <sspql/spaces/enum_state.hpp>
#include <vector>

constexpr std::size_t seeds = 50, episodes = 30;

template <class Params>
std::vector<double> steps_of(const Params& params) {
    std::vector<double> totals;  // steps of all episodes, by seed
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        sspql::WindyParams windy;
        windy.moves = sspql::WindyMoves::king;
        windy.gusts = 1.0 / 3.0;
        sspql::TabularEnvironment world(sspql::windy_table(windy));
        const sspql::EnumState<sspql::StateId> states(world.size());
        sspql::Agent agent(states, sspql::EnumActions<sspql::ActionId>(8), params, seed);
        double total = 0.0;
        for (const auto& episode : sspql::run_episodes(world, agent, episodes, 1000 * seed))
            total += double(episode.steps);
        totals.push_back(total);
    }
    return totals;
}

void tell(const char* name, const std::vector<double>& steps, const std::vector<double>& reference) {
    const sspql::Summary ours = sspql::summarize(steps), theirs = sspql::summarize(reference);
    std::printf("%-22s %6.0f +- %3.0f  %5.2f  %6.1f\n", name, ours.mean, ours.error, ours.mean / theirs.mean,
                sspql::z_score(ours, theirs));
}

int main() {
    std::printf("windy grid world with king's moves and gusts: steps of %zu episodes, %zu seeds\n", episodes, seeds);
    std::printf("%-22s %13s  ratio       z\n", "", "steps");
    const std::vector<double> values = steps_of(sspql::QLearningParams<>{});
    tell("Q-learning", values, values);
    tell("prioritized sweeping", steps_of(sspql::PrioritizedSweepingParams<>{}), values);
    tell("the adaptive planner", steps_of(sspql::AdaptiveParams<>{}), values);
}
