// SPDX-License-Identifier: MIT
// Table 1's columns as presets, and `q_only` against QLearning, bit for bit.
#include <sspql/learn/q_learning.hpp>
#include <sspql/learn/sspql.hpp>

#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/spaces/action_set.hpp>

using sspql::action_id;
using sspql::ActionId;
using sspql::ActionSet;
using sspql::QLearning;
using sspql::Random;
using sspql::Sspql;
using sspql::SspqlParams;
using sspql::state_id;
using sspql::StateId;

namespace {

/// Two learners that must do the same, in one random world.
class SideBySide {
public:
    static constexpr std::size_t states = 40, actions = 5;

    explicit SideBySide(std::uint64_t seed)
        : world_(seed, sspql::RandomStream::environment),
          sspql_(states, actions, SspqlParams<>::q_only(), seed),
          q_(states, actions, {}, seed) {}

    void step() {
        const double what = world_.uniform();
        if (what < 0.001) {
            both([](auto& learner) { learner.abort(); });
        } else if (what < 0.002) {
            const StateId goal = state_id(world_.below(states));
            both([&](auto& learner) { learner.set_goals({{goal, 0.0}}); });
        } else if (what < 0.01) {
            const StateId s = state_id(world_.below(states));
            ActionSet mask = ActionSet::all(actions);
            mask.erase(action_id(world_.below(actions)));
            both([&](auto& learner) { learner.set_legal_actions(s, mask); });
        } else if (what < 0.03) {
            const StateId s = state_id(world_.below(states));
            const ActionId a = action_id(world_.below(actions));
            const StateId next = state_id(world_.below(states));
            both([&](auto& learner) { learner.observe(s, a, 0.25, next, false); });
        } else if (!q_.running()) {
            const StateId s = state_id(world_.below(states));
            ASSERT_EQ(sspql_.begin(s), q_.begin(s));
        } else {
            act();
        }
    }

    void expect_same_values() const {
        ASSERT_TRUE((sspql_.q().matrix().array() == q_.q().matrix().array()).all());
        for (std::size_t s = 0; s < states; ++s) ASSERT_EQ(sspql_.best(state_id(s)), q_.best(state_id(s)));
    }

private:
    template <class F>
    void both(F&& f) {
        f(sspql_);
        f(q_);
    }

    void act() {
        const std::size_t straight = (index(q_.state()) * 7 + index(q_.action()) * 3 + 1) % states;
        const StateId next = state_id(world_.chance(0.8) ? straight : world_.below(states));
        const bool terminated = index(next) % 13 == 0;
        const double reward = terminated ? 1.0 : (world_.chance(0.1) ? world_.uniform(-0.2, 0.2) : 0.0);
        if (terminated || world_.chance(0.01)) {
            both([&](auto& learner) { learner.end(reward, next, terminated); });
        } else {
            ASSERT_EQ(sspql_.step(reward, next, 2.5), q_.step(reward, next, 2.5));
        }
    }

    Random world_;
    Sspql<> sspql_;
    QLearning<> q_;
};

}  // namespace

TEST(PresetQOnly, ActsLikeQLearningToTheBit) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        SideBySide pair(seed);
        for (int i = 0; i < 5000; ++i) {
            pair.step();
            if (HasFatalFailure()) return;
        }
        pair.expect_same_values();
    }
}

TEST(Presets, HaveThePapersParameters) {
    const SspqlParams<> paper = SspqlParams<>::with_bonus();
    EXPECT_EQ(paper.gamma, 0.8);
    EXPECT_EQ(paper.alpha(0), 0.8);
    EXPECT_EQ(paper.alpha(1000), 0.8);
    EXPECT_EQ(paper.initial_q, 0.0);
    EXPECT_EQ(paper.w_q, 1.0);
    EXPECT_EQ(paper.w_ssp, 1.0);
    EXPECT_EQ(paper.ssp_decay(2), 0.25);
    EXPECT_EQ(paper.w_exp, 0.1);
    EXPECT_EQ(paper.bonus.eta(), 1.5);
    EXPECT_EQ(paper.cost.lambda(), 2.0);
    EXPECT_EQ(paper.selector.noise(), 0.01);
}

TEST(Presets, DifferInTheirWeightsOnly) {
    struct Expected {
        SspqlParams<> params;
        double w_q, w_ssp, w_exp, decayed;
    };
    for (const Expected& expected : {Expected{SspqlParams<>::with_bonus(), 1.0, 1.0, 0.1, 0.01},
                                     Expected{SspqlParams<>::without_bonus(), 1.0, 1.0, 0.0, 0.01},
                                     Expected{SspqlParams<>::ssp_only(), 0.0, 1.0, 0.0, 0.01},
                                     Expected{SspqlParams<>::q_only(), 1.0, 0.0, 0.0, 0.01},
                                     Expected{SspqlParams<>::constant_weight(), 1.0, 1.0, 0.0, 1.0}}) {
        EXPECT_EQ(expected.params.w_q, expected.w_q);
        EXPECT_EQ(expected.params.w_ssp, expected.w_ssp);
        EXPECT_EQ(expected.params.w_exp, expected.w_exp);
        EXPECT_DOUBLE_EQ(expected.params.ssp_decay(10), expected.decayed);
        EXPECT_EQ(expected.params.gamma, 0.8);
        EXPECT_EQ(expected.params.cost.lambda(), 2.0);
    }
}

// `ssp` chooses by paths alone: whatever Q says of the other action.
TEST(PresetSspOnly, IgnoresQ) {
    Sspql<> learner(3, 2, SspqlParams<>::ssp_only());
    learner.observe(StateId{0}, ActionId{1}, 100.0, StateId{1}, false);
    learner.observe(StateId{0}, ActionId{0}, 1.0, StateId{2}, true);
    EXPECT_GT(learner.q()(StateId{0}, ActionId{1}), learner.q()(StateId{0}, ActionId{0}));
    EXPECT_EQ(learner.terms(StateId{0}, ActionId{1}).sum(), 0.0);
    EXPECT_EQ(learner.best(StateId{0}), ActionId{0});
}

TEST(PresetQOnly, SolvesNothing) {
    Sspql<> learner(3, 2, SspqlParams<>::q_only());
    learner.observe(StateId{0}, ActionId{0}, 1.0, StateId{2}, true);
    EXPECT_EQ(learner.tree().size(), 0u);
    EXPECT_EQ(learner.terms(StateId{0}, ActionId{0}).ssp, 0.0);
}
