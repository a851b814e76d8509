// SPDX-License-Identifier: MIT
#include <sspql/learn/q_learning.hpp>

#include "learn/learner_testing.hpp"

namespace sspql_q_learning_test {

using namespace sspql;
using namespace sspql::testing;

TEST(QLearning, DefaultsAreTheBaselineOfThePaper) {
    const QLearningParams<> params;
    EXPECT_EQ(params.gamma, 0.8);
    EXPECT_EQ(params.alpha(3), 0.8);
    EXPECT_EQ(params.initial_q, 0.0);
    EXPECT_EQ(params.w_exp, 0.0);
    EXPECT_EQ(params.bonus.eta(), 1.5);
    EXPECT_EQ(params.selector.noise(), 0.01);
}

TEST(QLearning, UpdatesByHand) {
    QLearning<> learner(3, 2);
    learner.observe(state_id(1), action_id(0), 1.0, state_id(2), true);
    EXPECT_DOUBLE_EQ(learner.q()(state_id(1), action_id(0)), 0.8);
    learner.observe(state_id(0), action_id(1), -0.1, state_id(1), false);
    EXPECT_DOUBLE_EQ(learner.q()(state_id(0), action_id(1)), 0.8 * (-0.1 + 0.8 * 0.8));
    learner.observe(state_id(0), action_id(1), -0.1, state_id(1), false);
    const double before = 0.8 * (-0.1 + 0.8 * 0.8);
    EXPECT_DOUBLE_EQ(learner.q()(state_id(0), action_id(1)), before + 0.8 * (-0.1 + 0.8 * 0.8 - before));
    EXPECT_EQ(learner.model_operations(), 0u);
}

TEST(QLearning, TheRateGoesByVisits) {
    QLearningParams<> params;
    params.alpha = VisitDecay{1.0};  // the mean of what was seen
    QLearning<> learner(2, 1, params);
    double sum = 0.0;
    for (int k = 1; k <= 50; ++k) {
        const double reward = k % 7;
        sum += reward;
        learner.observe(state_id(0), action_id(0), reward, state_id(1), true);
        EXPECT_NEAR(learner.q()(state_id(0), action_id(0)), sum / k, 1e-12);
    }
}

TEST(QLearning, AnExplorationBonusTriesEverythingOnce) {
    QLearningParams<> params;
    params.w_exp = 1.0;
    QLearning<> learner(1, 50, params, 3);
    (void)learner.begin(state_id(0));
    for (int k = 0; k < 49; ++k) (void)learner.step(0.0, state_id(0));
    learner.end(0.0, state_id(0), false);
    for (std::size_t a = 0; a < 50; ++a) EXPECT_EQ(learner.visits()(state_id(0), action_id(a)), 1u);
}

TEST(QLearning, ReservingChangesNothing) {
    QLearning<> reserved(Room::states, Room::actions, {}, 4);
    reserved.reserve(1000);
    QLearning<> plain(Room::states, Room::actions, {}, 4);
    Room room(4, 0.1);
    Room same(4, 0.1);
    for (int k = 0; k < 5; ++k) {
        EXPECT_EQ(walk(reserved, room, Room::at(0, 0), Room::at(4, 4)),
                  walk(plain, same, Room::at(0, 0), Room::at(4, 4)));
    }
}

}  // namespace sspql_q_learning_test
