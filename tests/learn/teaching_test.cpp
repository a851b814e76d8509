// SPDX-License-Identifier: MIT
// What a trainer saves, as docs/teaching.md says: the house of examples/03_a_trainer.cpp, one step in ten astray, an
// episode cut at 5000 steps, seeds 1 to 20.
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/env/grid_world.hpp>
#include <sspql/env/time_limit.hpp>
#include <sspql/learn/agent.hpp>
#include <sspql/learn/exact_values.hpp>
#include <sspql/learn/prioritized_sweeping.hpp>
#include <sspql/learn/q_learning.hpp>
#include <sspql/learn/sspql.hpp>
#include <sspql/run/episode.hpp>
#include <sspql/spaces/enum_state.hpp>

namespace sspql_teaching_test {

using namespace sspql;

namespace {

GridWorld house() {
    return GridWorld(GridMap::parse("S...........\n"
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
                                    "...........G\n"),
                     {0.1});
}

struct Hint {
    std::size_t row, column;
    Move right, wrong;
};
constexpr Hint hints[] = {{2, 8, Move::down, Move::up},    {3, 8, Move::down, Move::up},
                          {6, 3, Move::down, Move::up},    {7, 3, Move::down, Move::up},
                          {8, 3, Move::right, Move::left}, {11, 9, Move::right, Move::left}};

template <class Learner>
void hint(Learner& learner, bool right, double strength) {
    const GridMap map = house().map();
    for (const Hint& h : hints) {
        learner.teach(map.state(h.row, h.column), action_id(static_cast<std::size_t>(right ? h.right : h.wrong)),
                      strength);
    }
}

/// The optimal policy walks to the goal once. \returns its steps.
template <class Learner>
std::size_t show_the_way(Learner& learner, std::uint64_t seed) {
    GridWorld world = house();
    static const TransitionTable table = world.table();
    static const std::vector<ActionId> driver = greedy_policy(table, optimal_values(table, 0.95), 0.95);
    std::size_t steps = 0;
    for (Step<StateId> step{world.reset(seed)}; !step.terminated; ++steps) {
        const StateId from = step.observation;
        const ActionId a = driver[index(from)];
        step = world.step(static_cast<Move>(index(a)));
        learner.demonstrate({from, a, step.reward, step.observation, step.terminated});
    }
    return steps;
}

/// Mean steps of the first `episodes` episodes together, after a lesson(learner, seed).
template <class Params, class Lesson>
double steps(const Params& params, std::size_t episodes, const Lesson& lesson) {
    constexpr std::uint64_t seeds = 20;
    double sum = 0.0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        TimeLimit world(house(), 5000);
        Agent robot(EnumState<StateId>(world.environment().size()), EnumActions<Move>(4), params, seed);
        lesson(robot.learner(), seed);
        for (const EpisodeResult& episode : run_episodes(world, robot, episodes, 1000 * seed + 1)) {
            sum += static_cast<double>(episode.steps) / seeds;
        }
    }
    return sum;
}

const auto nothing = [](auto&, std::uint64_t) {};
const auto six_hints = [](auto& learner, std::uint64_t) { hint(learner, true, 1.0); };
const auto six_soft_hints = [](auto& learner, std::uint64_t) { hint(learner, true, 0.1); };
const auto six_wrong_hints = [](auto& learner, std::uint64_t) { hint(learner, false, 1.0); };
const auto six_soft_wrong_hints = [](auto& learner, std::uint64_t) { hint(learner, false, 0.1); };
const auto the_way = [](auto& learner, std::uint64_t seed) { (void)show_the_way(learner, 1000 * seed); };

}  // namespace

template <class Params>
class Trainer : public ::testing::Test {};
using Trained = ::testing::Types<QLearningParams<>, PrioritizedSweepingParams<>, SspqlParams<>>;
TYPED_TEST_SUITE(Trainer, Trained);

TYPED_TEST(Trainer, SixHintsSaveHalfOfTheFirstFiveEpisodes) {
    const double alone = steps(TypeParam{}, 5, nothing);
    EXPECT_LE(steps(TypeParam{}, 5, six_hints), 0.55 * alone);
    EXPECT_LE(steps(TypeParam{}, 5, six_soft_hints), 0.65 * alone);
}

TYPED_TEST(Trainer, SixHintsSaveTwoThirdsOfTheFirstEpisode) {
    EXPECT_LE(steps(TypeParam{}, 1, six_hints), 0.4 * steps(TypeParam{}, 1, nothing));
}

TYPED_TEST(Trainer, TheWayShownOnceSavesThreeQuartersOfTheFirstFiveEpisodes) {
    EXPECT_LE(steps(TypeParam{}, 5, the_way), 0.25 * steps(TypeParam{}, 5, nothing));
    EXPECT_LE(steps(TypeParam{}, 1, the_way), 150.0);
}

TYPED_TEST(Trainer, WrongHintsCostStepsAndSoftOnesFewer) {
    const double alone = steps(TypeParam{}, 5, nothing);
    const double soft = steps(TypeParam{}, 5, six_soft_wrong_hints);
    const double full = steps(TypeParam{}, 5, six_wrong_hints);
    EXPECT_GT(full, 1.3 * alone);
    EXPECT_LT(soft, 0.9 * full);
}

// Each wrong hint is followed some twenty times, then it is weaker than eq. 8's noise: nobody is caught for good.
TYPED_TEST(Trainer, WrongHintsFade) {
    TimeLimit world(house(), 5000);
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        Agent robot(EnumState<StateId>(world.environment().size()), EnumActions<Move>(4), TypeParam{}, seed);
        hint(robot.learner(), false, 1.0);
        const auto episodes = run_episodes(world, robot, 30, 1000 * seed + 1);
        std::size_t cut = 0;
        for (std::size_t k = 20; k < 30; ++k) cut += episodes[k].terminated ? 0 : 1;
        EXPECT_LE(cut, 1u) << "seed " << seed;
        const StateId door = world.environment().map().state(2, 8);
        EXPECT_LT(robot.learner().terms(door, action_id(0)).hint, 0.01) << "seed " << seed;
    }
}

}  // namespace sspql_teaching_test
