// SPDX-License-Identifier: MIT
#include <sspql/learn/adaptive/goal_distances.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

namespace sspql_adaptive_goal_distances_test {

using namespace sspql;

namespace {

constexpr double unknown = GoalDistances::unknown;
constexpr ActionId a0{0}, a1{1};

double steps(double) { return 1.0; }
double costs(double mean_reward) { return std::max(1.0, -mean_reward); }

template <class StepCost>
void search(GoalDistances& distances, GoalDistances::Counts& counts, const std::vector<Goal>& seeds,
            const StepCost& step_cost) {
    distances.refresh(counts, step_cost);
    distances.start(seeds);
    StepBudget budget = StepBudget::unlimited();
    ASSERT_TRUE(distances.advance(counts, budget));
}

/// 0 -> 1 -> 2 -> 3, two tries each, of which half get there; 3 knows the way out.
GoalDistances::Counts chain() {
    GoalDistances::Counts counts(4, 2);
    for (std::size_t s = 0; s < 3; ++s) {
        counts.record(state_id(s), a0, state_id(s + 1), false, -3.0);
        counts.record(state_id(s), a0, state_id(s), false, -3.0);
    }
    return counts;
}

}  // namespace

TEST(GoalDistances, AreExpectedTries) {
    auto counts = chain();
    GoalDistances distances(4);
    for (std::size_t s = 0; s < 4; ++s) EXPECT_EQ(distances.distance(state_id(s)), unknown);
    search(distances, counts, {{state_id(3), 0.5}}, steps);
    for (std::size_t s = 0; s < 4; ++s) {
        EXPECT_DOUBLE_EQ(distances.distance(state_id(s)), 0.5 + 2.0 * static_cast<double>(3 - s)) << s;
    }
    EXPECT_TRUE(counts.dirty().empty());
}

TEST(GoalDistances, WeighStepsByWhatTheyCost) {
    auto counts = chain();
    GoalDistances distances(4);
    search(distances, counts, {{state_id(3), 0.0}}, costs);
    EXPECT_DOUBLE_EQ(distances.distance(state_id(0)), 18.0) << "three steps, two tries, 3 each";
    // Another scale: nothing is dirty, labels have to be made anew.
    search(distances, counts, {{state_id(3), 0.0}}, steps);
    EXPECT_DOUBLE_EQ(distances.distance(state_id(0)), 18.0);
    for (std::size_t s = 0; s < 4; ++s) distances.relabel(counts, state_id(s), steps);
    search(distances, counts, {{state_id(3), 0.0}}, steps);
    EXPECT_DOUBLE_EQ(distances.distance(state_id(0)), 6.0);
}

TEST(GoalDistances, TakeTheBestActionAndTheBestSeed) {
    auto counts = chain();
    counts.record(state_id(0), a1, state_id(1));  // always
    GoalDistances distances(4);
    search(distances, counts, {{state_id(3), 10.0}, {state_id(1), 9.0}, {state_id(3), 4.0}}, steps);
    EXPECT_DOUBLE_EQ(distances.distance(state_id(3)), 4.0) << "the smaller one of two";
    EXPECT_DOUBLE_EQ(distances.distance(state_id(1)), 8.0) << "going on is better than its own seed";
    EXPECT_DOUBLE_EQ(distances.distance(state_id(0)), 9.0);
}

TEST(GoalDistances, EndsAndWhatIsHardlySeenAreNoWays) {
    GoalDistances::Counts counts(4, 2);
    counts.record(state_id(0), a0, state_id(3), true, 1.0);
    for (int k = 0; k < 10; ++k) counts.record(state_id(1), a0, k == 0 ? state_id(3) : state_id(2));
    GoalDistances distances(4);
    search(distances, counts, {{state_id(3), 0.0}}, steps);
    EXPECT_EQ(distances.distance(state_id(0)), unknown) << "an episode's end";
    EXPECT_DOUBLE_EQ(distances.distance(state_id(1)), 10.0);
    counts.fade(state_id(1), a0, 0.49, 0.01);
    search(distances, counts, {{state_id(3), 0.0}}, steps);
    EXPECT_EQ(distances.distance(state_id(1)), unknown) << "0.49 of a time";
}

TEST(GoalDistances, WithoutSeedsNothingIsKnown) {
    auto counts = chain();
    GoalDistances distances(4);
    search(distances, counts, {{state_id(3), 0.0}}, steps);
    search(distances, counts, {}, steps);
    for (std::size_t s = 0; s < 4; ++s) EXPECT_EQ(distances.distance(state_id(s)), unknown);
}

TEST(GoalDistances, AnUnfinishedSearchChangesNothing) {
    auto counts = chain();
    GoalDistances distances(4);
    search(distances, counts, {{state_id(3), 0.0}}, steps);
    distances.refresh(counts, steps);
    distances.start({{state_id(2), 0.0}});
    EXPECT_TRUE(distances.searching());
    StepBudget one(1, 1);
    one.earn();
    EXPECT_FALSE(distances.advance(counts, one));
    EXPECT_DOUBLE_EQ(distances.distance(state_id(3)), 0.0) << "as of the last search";
    EXPECT_DOUBLE_EQ(distances.distance(state_id(0)), 6.0);
    counts.record(state_id(0), a1, state_id(2));  // waits
    EXPECT_EQ(distances.refresh(counts, steps), 0u);
    StepBudget rest = StepBudget::unlimited();
    EXPECT_TRUE(distances.advance(counts, rest));
    EXPECT_FALSE(distances.searching());
    EXPECT_DOUBLE_EQ(distances.distance(state_id(0)), 4.0);
    EXPECT_EQ(distances.distance(state_id(3)), unknown);
    search(distances, counts, {{state_id(2), 0.0}}, steps);
    EXPECT_DOUBLE_EQ(distances.distance(state_id(0)), 1.0) << "now it counts";
}

TEST(GoalDistances, GuessesHoldUntilASearchKnowsBetter) {
    auto counts = chain();
    GoalDistances distances(4);
    distances.set_distance(state_id(0), 42.0);
    EXPECT_EQ(distances.distance(state_id(0)), 42.0);
    distances.grow(5);
    EXPECT_EQ(distances.distance(state_id(4)), unknown);
    EXPECT_EQ(distances.distance(state_id(0)), 42.0);
    counts.grow(5);
    search(distances, counts, {{state_id(3), 0.0}}, steps);
    EXPECT_DOUBLE_EQ(distances.distance(state_id(0)), 6.0);
    EXPECT_EQ(distances.distance(state_id(4)), unknown);
}

}  // namespace sspql_adaptive_goal_distances_test
