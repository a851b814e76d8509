// SPDX-License-Identifier: MIT
// AdaptiveSspql beyond what holds for every learner: untried actions, masks, hints, what it tells of itself.
#include <sspql/learn/adaptive_sspql.hpp>

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <stdexcept>
#include <vector>

#include "learn/learner_testing.hpp"

namespace sspql_adaptive_sspql_test {

using namespace sspql;
using namespace sspql::testing;

namespace {

constexpr ActionId a0{0}, a1{1};
constexpr double unknown = GoalDistances::unknown;

/// Actions of 12 episodes through a room with slips, where the goal pays `goal` and every other step `step`.
std::vector<ActionId> life(double goal, double step) {
    AdaptiveSspql<> learner(Room::states, Room::actions, {}, 7);
    Room room(7, 0.2);
    std::vector<ActionId> chosen;
    for (int k = 0; k < 12; ++k) {
        StateId s = Room::at(0, 0);
        chosen.push_back(learner.begin(s));
        for (int n = 0; n < 300; ++n) {
            s = room.step(s, learner.action());
            if (s == Room::at(4, 4)) break;
            chosen.push_back(learner.step(step, s));
        }
        learner.end(s == Room::at(4, 4) ? goal : step, s, s == Room::at(4, 4));
    }
    return chosen;
}

}  // namespace

TEST(AdaptiveSspql, FindsTheShortestWayThroughARoom) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        AdaptiveSspql<> learner(Room::states, Room::actions, {}, seed);
        Room room(seed);
        for (int k = 0; k < 15; ++k) (void)walk(learner, room, Room::at(0, 0), Room::at(4, 4));
        EXPECT_LE(walk(learner, room, Room::at(0, 0), Room::at(4, 4)).size(), 9u) << "seed " << seed << "; 8 at best";
    }
}

TEST(AdaptiveSspql, UntriedActionsOfAnUnknownWorldAreWorthTheGoal) {
    AdaptiveSspql<> learner(3, 2);
    for (std::size_t s = 0; s < 3; ++s) {
        EXPECT_EQ(learner.state_value(state_id(s)), 1.0);
        EXPECT_EQ(learner.terms(state_id(s), a0).sum(), 1.0) << "seen or not";
        EXPECT_EQ(learner.path_length(state_id(s)), unknown);
    }
    EXPECT_EQ(learner.q()(state_id(0), a0), 0.0);
    for (const StateId bad : {state_id(3), no_state}) {
        EXPECT_THROW((void)learner.state_value(bad), std::invalid_argument);
        EXPECT_THROW((void)learner.path_length(bad), std::invalid_argument);
    }
}

TEST(AdaptiveSspql, ValuesOfAChainByHand) {
    AdaptiveParams<> params;
    params.gamma = 0.9;
    params.trust.kappa_least = 0.5;  // nothing is noisy here: this is the pseudo-count
    params.trust.kappa_few = 0.0;
    AdaptiveSspql<> learner(3, 1, params);
    learner.observe(state_id(1), a0, 1.0, state_id(2), true);  // a goal in one step: c and levels start from it
    const double here = learner.scale().level(1.0).here;
    for (int k = 0; k < 2; ++k) learner.observe(state_id(1), a0, 1.0, state_id(2), true);
    const double q1 = (3.0 + 0.5 * here) / 3.5;
    EXPECT_NEAR(learner.q()(state_id(1), a0), q1, 1e-12) << "three times 1, half a time hope";
    learner.observe(state_id(0), a0, 0.0, state_id(1), false);
    const double hope = learner.scale().level(learner.path_length(state_id(0))).here;
    EXPECT_NEAR(learner.q()(state_id(0), a0), (0.9 * q1 + 0.5 * hope) / 1.5, 1e-12);
    EXPECT_EQ(learner.state_value(state_id(0)), learner.q()(state_id(0), a0));
    EXPECT_EQ(learner.terms(state_id(0), a0).q, learner.q()(state_id(0), a0));
    EXPECT_EQ(learner.terms(state_id(0), a0).n, 1.0);
}

TEST(AdaptiveSspql, StayingIsSolvedExactly) {
    AdaptiveParams<> params;
    params.gamma = 0.9;
    params.trust.kappa_least = 1e-9;
    params.trust.kappa_noise = 0.0;
    AdaptiveSspql<> learner(2, 1, params);
    for (int k = 0; k < 8; ++k) {  // half of the tries stay
        learner.observe(state_id(0), a0, 0.0, state_id(0), false);
        learner.observe(state_id(0), a0, 1.0, state_id(1), true);
    }
    EXPECT_NEAR(learner.q()(state_id(0), a0), 0.5 / (1.0 - 0.9 * 0.5), 1e-6);
}

TEST(AdaptiveSspql, OnlyLegalUntriedActionsAttract) {
    AdaptiveSspql<> learner(4, 2);
    for (std::size_t s = 0; s < 4; ++s) learner.set_legal_actions(state_id(s), ActionSet::of(2, {a0}));
    for (int k = 0; k < 30; ++k) {
        learner.observe(state_id(3), a0, 1.0, state_id(3), true);
        learner.observe(state_id(1), a0, 0.0, state_id(2), true);  // a dead end
        learner.observe(state_id(0), a0, 0.0, state_id(1), false);
    }
    EXPECT_LT(learner.state_value(state_id(1)), 0.01) << "its untried action is illegal";
    EXPECT_LT(learner.state_value(state_id(0)), 0.01);
    learner.set_legal_actions(state_id(1), ActionSet::all(2));
    EXPECT_GT(learner.state_value(state_id(1)), 0.5) << "now there is hope";
    learner.observe(state_id(3), a0, 1.0, state_id(3), true);  // any step gives time to plan
    EXPECT_GT(learner.state_value(state_id(0)), 0.5) << "which is passed on";
    EXPECT_EQ(learner.begin(state_id(1)), a1);
    learner.abort();
    learner.set_legal_actions(state_id(1), ActionSet::of(2, {a0}));
    EXPECT_LT(learner.state_value(state_id(1)), 0.01);
    EXPECT_EQ(learner.begin(state_id(1)), a0);
    learner.abort();
    learner.observe(state_id(3), a0, 1.0, state_id(3), true);
    EXPECT_LT(learner.state_value(state_id(0)), 0.02) << "and taken back";
}

TEST(AdaptiveSspql, ATriedActionThatBecomesIllegalCountsNoMore) {
    AdaptiveSspql<> learner(3, 2);
    for (int k = 0; k < 30; ++k) {
        learner.observe(state_id(0), a0, 0.0, state_id(1), true);
        learner.observe(state_id(0), a1, 1.0, state_id(2), true);
    }
    EXPECT_EQ(learner.best(state_id(0)), a1);
    EXPECT_GT(learner.state_value(state_id(0)), 0.9);
    learner.set_legal_actions(state_id(0), ActionSet::of(2, {a0}));
    EXPECT_EQ(learner.best(state_id(0)), a0);
    EXPECT_LT(learner.state_value(state_id(0)), 0.1);
    learner.set_legal_actions(state_id(0), ActionSet::all(2));
    EXPECT_GT(learner.state_value(state_id(0)), 0.9) << "what was learnt stays";
}

TEST(AdaptiveSspql, HintsAreFollowedAndFade) {
    AdaptiveSspql<> learner(Room::states, Room::actions, {}, 3);
    Room room(3);
    for (int k = 0; k < 15; ++k) (void)walk(learner, room, Room::at(0, 0), Room::at(4, 4));
    learner.teach(Room::at(0, 0), a1);  // into the wall
    EXPECT_EQ(walk(learner, room, Room::at(0, 0), Room::at(4, 4))[0], a1);
    for (int k = 0; k < 15; ++k) (void)walk(learner, room, Room::at(0, 0), Room::at(4, 4));
    EXPECT_NE(walk(learner, room, Room::at(0, 0), Room::at(4, 4))[0], a1) << "it knows better by now";
    learner.teach(Room::at(1, 1), a0, -1.0);
    EXPECT_NE(learner.begin(Room::at(1, 1)), a0) << "a warning";
}

TEST(AdaptiveSspql, ADemonstratedWayIsWalkedAtOnce) {
    AdaptiveSspql<> learner(Room::states, Room::actions, {}, 4);
    StateId s = Room::at(0, 0);
    for (const std::size_t a : std::initializer_list<std::size_t>{0, 2, 0, 2, 0, 2, 0, 2}) {
        const StateId next = Room::moved(s, action_id(a));
        const bool home = next == Room::at(4, 4);
        learner.demonstrate({s, action_id(a), home ? 1.0 : 0.0, next, home});
        s = next;
    }
    Room room(4);
    EXPECT_EQ(walk(learner, room, Room::at(0, 0), Room::at(4, 4)).size(), 8u);
}

TEST(AdaptiveSspql, AnAbortedEpisodeCostsNothing) {
    AdaptiveSspql<> learner(Room::states, Room::actions, {}, 5);
    (void)learner.begin(state_id(0));
    for (std::size_t k = 0; k < 100; ++k) (void)learner.step(0.0, state_id(k % 5));
    learner.abort();
    (void)learner.begin(state_id(0));
    for (std::size_t k = 1; k < 4; ++k) (void)learner.step(0.0, state_id(k));
    learner.end(1.0, state_id(4), true);
    EXPECT_NEAR(learner.status().typical_cost, 3.0, 1e-9) << "three steps before the one that paid";
}

TEST(AdaptiveSspql, OneStateAndOneActionAreEnough) {
    for (const double reward : {1.0, 0.0, -1.0}) {
        AdaptiveSspql<> learner(1, 1, {}, 1);
        for (int k = 0; k < 100; ++k) {
            EXPECT_EQ(learner.begin(state_id(0)), a0);
            for (int i = 0; i < 10; ++i) EXPECT_EQ(learner.step(reward, state_id(0)), a0);
            learner.end(reward, state_id(0), k % 2 == 0);
        }
        EXPECT_EQ(learner.best(state_id(0)), a0);
        EXPECT_LE(std::fabs(learner.q()(state_id(0), a0)), 100.0) << "1 / (1 - gamma)";
        EXPECT_TRUE(std::isfinite(learner.terms(state_id(0), a0).sum()));
    }
}

// Nothing in it has a scale of its own but the value of an unknown world, which ends with the first goal.
TEST(AdaptiveSspql, TheScaleOfRewardsDoesNotMatter) {
    EXPECT_EQ(life(1.0, 0.0), life(1024.0, 0.0));
    EXPECT_EQ(life(1.0, 0.0), life(0x1p-20, 0.0));
    EXPECT_EQ(life(-1.0, -1.0), life(-1024.0, -1024.0));
    EXPECT_EQ(life(-1.0, -1.0), life(-0x1p-20, -0x1p-20));
}

TEST(AdaptiveSspql, TellsItsStatus) {
    AdaptiveSspql<> learner(Room::states, Room::actions, {}, 6);
    Room room(6);
    EXPECT_EQ(learner.status().steps, 0u);
    EXPECT_FALSE(learner.status().goal_known);
    std::size_t steps = 0;
    for (int k = 0; k < 10; ++k) steps += walk(learner, room, Room::at(0, 0), Room::at(4, 4)).size();
    const AdaptiveStatus status = learner.status();
    EXPECT_EQ(status.steps, steps);
    EXPECT_TRUE(status.goal_known);
    EXPECT_EQ(status.alarms, 0u);
    EXPECT_EQ(status.noise, 0.0);
    EXPECT_LE(status.states_known, Room::states);
    EXPECT_GE(status.states_known, 9u);
    EXPECT_LE(status.pairs_tried, steps);
    EXPECT_GE(status.typical_cost, 7.0 - 1e-9);
    EXPECT_LE(status.typical_cost, 30.0);
    EXPECT_EQ(status.edge_touches, learner.model_operations());
}

TEST(AdaptiveSspql, RefusesParametersOutOfRange) {
    const auto with = [](auto change) {
        AdaptiveParams<> params;
        change(params);
        return AdaptiveSspql<>(2, 2, params);
    };
    EXPECT_NO_THROW(with([](auto& p) { p.gamma = 0.5; }));
    EXPECT_THROW(with([](auto& p) { p.gamma = 1.0; }), std::invalid_argument) << "way must cost";
    EXPECT_THROW(with([](auto& p) { p.gamma = not_a_number; }), std::invalid_argument);
    EXPECT_THROW(with([](auto& p) { p.threshold = 0.0; }), std::invalid_argument);
    EXPECT_THROW(with([](auto& p) { p.path_budget = -1.0; }), std::invalid_argument);
    EXPECT_THROW(with([](auto& p) { p.slice = 0; }), std::invalid_argument);
    EXPECT_THROW(with([](auto& p) { p.slice = StepBudget::most + 1; }), std::invalid_argument);
    EXPECT_NO_THROW(with([](auto& p) { p.slice = StepBudget::most; }));
    EXPECT_THROW(with([](auto& p) { p.bonus = infinity; }), std::invalid_argument);
    EXPECT_THROW(with([](auto& p) { p.retrace = 1.5; }), std::invalid_argument);
    EXPECT_THROW(with([](auto& p) { p.optimism.limit = 2.0; }), std::invalid_argument);
    EXPECT_THROW(with([](auto& p) { p.trust.kappa_least = 0.0; }), std::invalid_argument);
    EXPECT_THROW(with([](auto& p) { p.change.fast = 2.0; }), std::invalid_argument);
    EXPECT_THROW(AdaptiveSspql<>(0, 2), std::invalid_argument);
    EXPECT_THROW(AdaptiveSspql<>(2, 0), std::invalid_argument);
    EXPECT_THROW(AdaptiveSspql<>(2, 65536), std::invalid_argument);
}

}  // namespace sspql_adaptive_sspql_test
