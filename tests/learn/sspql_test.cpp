// SPDX-License-Identifier: MIT
#include <sspql/learn/sspql.hpp>

#include <cmath>
#include <stdexcept>
#include <variant>

#include "learn/learner_testing.hpp"

namespace sspql_sspql_test {

using namespace sspql;
using namespace sspql::testing;

TEST(Sspql, WithQAloneItIsQLearningToTheBit) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        QLearning<> q(Room::states, Room::actions, {}, seed);
        Sspql<> sspql(Room::states, Room::actions, SspqlParams<>::q_only(), seed);
        Room room(seed, 0.1);
        Room same(seed, 0.1);
        for (int k = 0; k < 20; ++k) {
            ASSERT_EQ(walk(q, room, Room::at(0, 0), Room::at(4, 4)), walk(sspql, same, Room::at(0, 0), Room::at(4, 4)))
                << "seed " << seed << ", episode " << k;
        }
        EXPECT_EQ(q.q().matrix(), sspql.q().matrix());
    }
}

TEST(Sspql, PresetsAreThoseOfTable1) {
    const SspqlParams<> paper = SspqlParams<>::with_bonus();
    EXPECT_EQ(paper.gamma, 0.8);
    EXPECT_EQ(paper.alpha(7), 0.8);
    EXPECT_EQ(paper.initial_q, 0.0);
    EXPECT_EQ(paper.w_q, 1.0);
    EXPECT_EQ(paper.w_ssp, 1.0);
    EXPECT_EQ(paper.ssp_decay(3), std::pow(3.0, -2.0));
    EXPECT_EQ(paper.w_exp, 0.1);
    EXPECT_EQ(paper.bonus.eta(), 1.5);
    EXPECT_EQ(paper.cost.lambda(), 2.0);
    EXPECT_EQ(paper.selector.noise(), 0.01);
    EXPECT_EQ(SspqlParams<>::without_bonus().w_exp, 0.0);
    EXPECT_EQ(SspqlParams<>::ssp_only().w_q, 0.0);
    EXPECT_EQ(SspqlParams<>::ssp_only().w_exp, 0.0);
    EXPECT_EQ(SspqlParams<>::q_only().w_ssp, 0.0);
    EXPECT_EQ(SspqlParams<>::constant_weight().ssp_decay(1000), 1.0);
}

TEST(Sspql, ShortestPathIsSeenAfterOneEpisode) {
    Sspql<> learner(Room::states, Room::actions, SspqlParams<>::without_bonus(), 3);
    Room room(3);
    const std::size_t first = walk(learner, room, Room::at(0, 0), Room::at(4, 4)).size();
    EXPECT_TRUE(learner.tree().reaches_goal(Room::at(0, 0)));
    const std::size_t second = walk(learner, room, Room::at(0, 0), Room::at(4, 4)).size();
    EXPECT_LE(second, first);
    EXPECT_LE(second, learner.tree().path(Room::at(0, 0)).size() * 3);
}

TEST(Sspql, TermsFollowTheirEquations) {
    SspqlParams<> params;
    params.w_ssp = 0.5;
    Sspql<> learner(3, 2, params);
    for (int k = 0; k < 3; ++k) learner.observe(state_id(0), action_id(1), 0.0, state_id(1), false);
    learner.observe(state_id(0), action_id(1), 0.0, state_id(0), false);
    learner.observe(state_id(1), action_id(0), 1.0, state_id(2), true);
    const ActionTerms terms = learner.terms(state_id(0), action_id(1));
    const double entropy = -(0.75 * std::log(0.75) + 0.25 * std::log(0.25));
    EXPECT_DOUBLE_EQ(terms.ssp, 0.5 * std::pow(4.0, -2.0) * std::exp(-entropy));
    EXPECT_DOUBLE_EQ(terms.exploration, 0.1 * std::pow(5.0, -1.5));
    EXPECT_EQ(terms.q, learner.q()(state_id(0), action_id(1)));
    EXPECT_EQ(terms.n, 4.0);
    EXPECT_EQ(learner.terms(state_id(0), action_id(0)).ssp, 0.0) << "off the path";
    const ActionTerms sure = learner.terms(state_id(1), action_id(0));
    EXPECT_DOUBLE_EQ(sure.ssp, 0.5) << "one visit, no entropy";
}

TEST(Sspql, PathsAreRenewedAtTheEndOfAnEpisodeOrWhenTold) {
    Sspql<> learner(4, 2);
    learner.observe(state_id(0), action_id(0), 0.0, state_id(1), false);
    (void)learner.begin(state_id(1));
    learner.end(1.0, state_id(2), true);
    const ActionId a = learner.best(state_id(1));
    EXPECT_GT(learner.terms(state_id(1), a).ssp, 0.0);
    learner.observe(state_id(3), action_id(1), 0.0, state_id(0), false);
    EXPECT_EQ(learner.terms(state_id(3), action_id(1)).ssp, 0.0);
    learner.update_paths();
    EXPECT_EQ(learner.terms(state_id(3), action_id(1)).ssp, 1.0);
}

TEST(Sspql, WithoutWeightOfItsPathsItPlansNothing) {
    Sspql<> learner(Room::states, Room::actions, SspqlParams<>::q_only(), 3);
    Room room(3);
    const std::size_t steps = walk(learner, room, Room::at(0, 0), Room::at(4, 4)).size();
    EXPECT_EQ(learner.tree().size(), 0u);
    EXPECT_EQ(learner.model_operations(), steps) << "a record each step";
}

TEST(Sspql, HazardsAreNoGoals) {
    Sspql<> learner(4, 2);
    learner.observe(state_id(0), action_id(0), -1.0, state_id(2), true);
    EXPECT_TRUE(learner.goals().empty());
    learner.observe(state_id(0), action_id(1), 1.0, state_id(3), true);
    ASSERT_EQ(learner.goals().size(), 1u);
    EXPECT_EQ(learner.goals()[0].state, state_id(3));
    EXPECT_EQ(learner.best(state_id(0)), action_id(1));
}

TEST(Sspql, StepWeightsLengthenPaths) {
    Sspql<> learner(4, 2);
    learner.observe(state_id(0), action_id(0), 0.0, state_id(1), false, 5.0);  // slow
    learner.observe(state_id(0), action_id(1), 0.0, state_id(2), false, 0.5);
    learner.observe(state_id(1), action_id(0), 1.0, state_id(3), true);
    learner.observe(state_id(2), action_id(0), 1.0, state_id(3), true);
    EXPECT_EQ(learner.tree().next[0], state_id(2));
    EXPECT_DOUBLE_EQ(learner.tree().distance[0], 1.5 * std::exp(-2.0));
}

TEST(Sspql, RefusesWeightsOutOfRange) {
    const auto accepts = [](auto change) {
        SspqlParams<> params;
        change(params);
        try {
            Sspql<> learner(4, 2, params);
            return true;
        } catch (const std::invalid_argument&) {
            return false;
        }
    };
    EXPECT_TRUE(accepts([](auto& p) { p.w_q = 0.0; }));
    EXPECT_FALSE(accepts([](auto& p) { p.w_q = -1.0; }));
    EXPECT_FALSE(accepts([](auto& p) { p.w_q = not_a_number; }));
    EXPECT_FALSE(accepts([](auto& p) { p.w_ssp = -1.0; }));
    EXPECT_FALSE(accepts([](auto& p) { p.w_ssp = infinity; }));
    EXPECT_FALSE(accepts([](auto& p) { p.ssp_decay = 1.5; }));
    EXPECT_FALSE(accepts([](auto& p) { p.ssp_decay = ExponentialDecay{2.0, 0.1, 0.0}; }));
}

}  // namespace sspql_sspql_test
