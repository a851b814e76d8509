// SPDX-License-Identifier: MIT
#include <sspql/learn/last_outcomes.hpp>

#include <cstddef>

#include <gtest/gtest.h>

namespace sspql_last_outcomes_test {

using namespace sspql;

namespace {

constexpr StateId s0{0}, s1{1}, s9{9};
constexpr ActionId a0{0}, a1{1};

}  // namespace

TEST(LastOutcomes, AreEmptyAtFirst) {
    const LastOutcomes outcomes(2);
    EXPECT_EQ(outcomes.size(), 0u);
    EXPECT_EQ(outcomes.find(s0, a0), nullptr);
    EXPECT_EQ(outcomes.find(s9, a1), nullptr);
}

TEST(LastOutcomes, KeepEachPairOnceInTheOrderOfItsFirstTry) {
    LastOutcomes outcomes(2);
    outcomes.observe({s9, a1, 1.0, s0, false, 1.0});
    outcomes.observe({s0, a0, 2.0, s1, false, 1.0});
    outcomes.observe({s9, a1, 3.0, s9, true, 2.0});
    ASSERT_EQ(outcomes.size(), 2u);
    EXPECT_EQ(outcomes.tried(0).state, s9);
    EXPECT_EQ(outcomes.tried(0).action, a1);
    EXPECT_EQ(outcomes.tried(1).state, s0);
    EXPECT_EQ(outcomes.find(s9, a1), &outcomes.tried(0));
    EXPECT_EQ(outcomes.find(s0, a0), &outcomes.tried(1));
}

TEST(LastOutcomes, TellWhatHappenedLast) {
    LastOutcomes outcomes(2);
    outcomes.observe({s0, a0, 1.0, s1, false, 1.0});
    outcomes.observe({s0, a0, 3.0, s9, true, 2.5});
    const Transition* last = outcomes.find(s0, a0);
    ASSERT_NE(last, nullptr);
    EXPECT_EQ(last->reward, 3.0);
    EXPECT_EQ(last->next, s9);
    EXPECT_TRUE(last->terminated);
    EXPECT_EQ(last->weight, 2.5);
    EXPECT_EQ(outcomes.find(s0, a1), nullptr) << "the other action";
    EXPECT_EQ(outcomes.find(s1, a0), nullptr) << "the next state over";
}

TEST(LastOutcomes, ReserveChangesNothingButTheMemory) {
    LastOutcomes outcomes(2);
    outcomes.reserve(10);
    EXPECT_EQ(outcomes.size(), 0u);
    const Transition* first = nullptr;
    for (std::size_t s = 0; s < 10; ++s) {
        for (const ActionId a : {a0, a1}) outcomes.observe({state_id(s), a, 0.0, s0, false, 1.0});
        if (s == 0) first = &outcomes.tried(0);
    }
    EXPECT_EQ(outcomes.size(), 20u);
    EXPECT_EQ(&outcomes.tried(0), first) << "nothing was moved on the way there";
}

}  // namespace sspql_last_outcomes_test
