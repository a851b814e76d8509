// SPDX-License-Identifier: MIT
#include <sspql/learn/learner.hpp>

#include <stdexcept>
#include <string>

#include "learn/learner_testing.hpp"

using namespace sspql;
using namespace sspql::testing;

namespace {

template <class L>
typename L::Params changed(void (*change)(typename L::Params&)) {
    typename L::Params params;
    change(params);
    return params;
}

template <class L>
bool accepts(void (*change)(typename L::Params&)) {
    try {
        L learner(4, 2, changed<L>(change));
        return true;
    } catch (const std::invalid_argument&) {
        return false;
    }
}

}  // namespace

template <class L>
class LearnerRefusals : public ::testing::Test {
protected:
    /// A learner that has learnt something and is on its way.
    void SetUp() override {
        Room room{6, 0.1};
        for (int k = 0; k < 5; ++k) (void)walk(learner_, room, Room::at(0, 0), Room::at(4, 4));
        (void)learner_.begin(Room::at(1, 1));
    }
    L learner_{Room::states, Room::actions, typename L::Params(), 6};
};
TYPED_TEST_SUITE(LearnerRefusals, AllLearners, LearnerNames);

TYPED_TEST(LearnerRefusals, BadRewardsChangeNothing) {
    auto& learner = this->learner_;
    const auto before = fingerprint(learner);
    for (const double bad : bad_rewards) {
        EXPECT_THROW((void)learner.step(bad, state_id(1)), std::invalid_argument);
        EXPECT_THROW(learner.end(bad, state_id(1), true), std::invalid_argument);
        EXPECT_THROW(learner.observe(state_id(0), action_id(0), bad, state_id(1), true), std::invalid_argument);
    }
    EXPECT_EQ(fingerprint(learner), before);
}

TYPED_TEST(LearnerRefusals, BadWeightsChangeNothing) {
    auto& learner = this->learner_;
    const auto before = fingerprint(learner);
    for (const double bad : bad_weights) {
        EXPECT_THROW((void)learner.step(0.0, state_id(1), bad), std::invalid_argument) << bad;
        EXPECT_THROW(learner.end(0.0, state_id(1), true, bad), std::invalid_argument) << bad;
        EXPECT_THROW(learner.observe(state_id(0), action_id(0), 0.0, state_id(1), true, bad), std::invalid_argument);
    }
    EXPECT_EQ(fingerprint(learner), before);
    EXPECT_NO_THROW((void)learner.step(0.0, state_id(1), 1e-30));
    EXPECT_NO_THROW((void)learner.step(0.0, state_id(2), 1e30));
}

TYPED_TEST(LearnerRefusals, IdsOutsideChangeNothing) {
    auto& learner = this->learner_;
    const auto before = fingerprint(learner);
    for (const StateId bad : {state_id(Room::states), state_id(1000000), no_state}) {
        EXPECT_THROW((void)learner.step(0.0, bad), std::invalid_argument);
        EXPECT_THROW(learner.end(0.0, bad, true), std::invalid_argument);
        EXPECT_THROW(learner.observe(bad, action_id(0), 0.0, state_id(1), true), std::invalid_argument);
        EXPECT_THROW(learner.observe(state_id(1), action_id(0), 0.0, bad, true), std::invalid_argument);
        EXPECT_THROW((void)learner.best(bad), std::invalid_argument);
        EXPECT_THROW((void)learner.terms(bad, action_id(0)), std::invalid_argument);
        EXPECT_THROW(learner.set_goals({{bad}}), std::invalid_argument);
        EXPECT_THROW(learner.set_legal_actions(bad, ActionSet::all(Room::actions)), std::invalid_argument);
        EXPECT_THROW(learner.teach(bad, action_id(0)), std::invalid_argument);
    }
    for (const ActionId bad : {action_id(Room::actions), no_action}) {
        EXPECT_THROW(learner.observe(state_id(0), bad, 0.0, state_id(1), true), std::invalid_argument);
        EXPECT_THROW((void)learner.terms(state_id(0), bad), std::invalid_argument);
        EXPECT_THROW(learner.replace_action(bad), std::invalid_argument);
        EXPECT_THROW(learner.teach(state_id(0), bad), std::invalid_argument);
    }
    EXPECT_EQ(fingerprint(learner), before);
}

TYPED_TEST(LearnerRefusals, TheRightCallCanFollow) {
    auto& learner = this->learner_;
    TypeParam twin = learner;
    EXPECT_THROW((void)learner.step(not_a_number, state_id(1)), std::invalid_argument);
    EXPECT_THROW((void)learner.step(0.0, state_id(Room::states)), std::invalid_argument);
    EXPECT_EQ(learner.step(0.25, state_id(1)), twin.step(0.25, state_id(1)));
    EXPECT_THROW(learner.end(0.0, no_state, true), std::invalid_argument);
    learner.end(1.0, state_id(2), true);
    twin.end(1.0, state_id(2), true);
    EXPECT_EQ(fingerprint(learner), fingerprint(twin));
}

TYPED_TEST(LearnerRefusals, TextsNameWhatIsWrong) {
    auto& learner = this->learner_;
    const auto text = [](auto&& call) -> std::string {
        try {
            call();
        } catch (const std::exception& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_EQ(text([&] { (void)learner.step(not_a_number, state_id(0)); }), "reward must be finite, got nan");
    EXPECT_EQ(text([&] { (void)learner.step(0.0, state_id(25)); }),
              "next state must be below the number of states 25, got 25");
    EXPECT_EQ(text([&] { (void)learner.step(0.0, state_id(0), 0.0); }), "weight must lie in [1e-30, 1e+30], got 0");
    EXPECT_EQ(text([&] { (void)learner.begin(state_id(0)); }), "begin() during an episode: end() or abort() it first");
    learner.abort();
    EXPECT_EQ(text([&] { (void)learner.step(0.0, state_id(0)); }), "step() before begin()");
    EXPECT_EQ(text([&] { learner.end(0.0, state_id(0), true); }), "end() before begin()");
}

template <class L>
class ValueLearnerRefusals : public ::testing::Test {};
TYPED_TEST_SUITE(ValueLearnerRefusals, ValueLearners, LearnerNames);

TYPED_TEST(ValueLearnerRefusals, ParametersOutOfRange) {
    using L = TypeParam;
    EXPECT_TRUE(accepts<L>([](auto& p) { p.gamma = 0.999; }));
    EXPECT_TRUE(accepts<L>([](auto& p) { p.alpha = VisitDecay{0.5}; }));
    EXPECT_FALSE(accepts<L>([](auto& p) { p.gamma = 1.001; }));
    EXPECT_FALSE(accepts<L>([](auto& p) { p.gamma = not_a_number; }));
    EXPECT_FALSE(accepts<L>([](auto& p) { p.alpha = 1.5; }));
    EXPECT_FALSE(accepts<L>([](auto& p) { p.alpha = ExponentialDecay{2.0, 0.1, 0.0}; }));
    EXPECT_FALSE(accepts<L>([](auto& p) { p.initial_q = infinity; }));
    EXPECT_FALSE(accepts<L>([](auto& p) { p.w_exp = -0.1; }));
    EXPECT_THROW(L(0, 2), std::invalid_argument);
    EXPECT_THROW(L(2, 0), std::invalid_argument);
}
