// SPDX-License-Identifier: MIT
// What a learner allocates once it has its memory: nothing.
#include <sspql/learn/learner.hpp>

#include <cstddef>

#include "counting_new.hpp"
#include "learn/learner_testing.hpp"

using namespace sspql;
using namespace sspql::testing;
using sspql_test::allocations;

template <class L>
class LearnerAllocation : public ::testing::Test {};
TYPED_TEST_SUITE(LearnerAllocation, AllLearners, LearnerNames);

/// Bytes of the counts of a learner that has them: these take zeros from calloc, which nobody counts here.
template <class L>
auto model_bytes(const L& learner, int) -> decltype(learner.counts().bytes()) {
    return learner.counts().bytes();
}
template <class L>
std::size_t model_bytes(const L&, long) {
    return 0;
}

TYPED_TEST(LearnerAllocation, StepsAllocateNothingAfterReserve) {
    constexpr std::size_t states = 500;
    TypeParam learner(StateCount::growing(), 4, {}, 1);
    learner.reserve(states);
    const std::size_t bytes = model_bytes(learner, 0);
    Random world(1);
    for (int episode = 0; episode < 5; ++episode) {
        const std::size_t before = allocations;
        (void)learner.begin(state_id(0));
        for (int k = 0; k < 600; ++k) {
            const std::size_t s = index(learner.state());  // goes to s + 1, itself or s / 2
            const std::size_t next = world.chance(0.98) ? s + 1 : world.chance(0.5) ? s : s / 2;
            if (next == states) break;
            (void)learner.step(world.uniform(), state_id(next));
        }
        EXPECT_EQ(allocations - before, 0u) << "episode " << episode;
        EXPECT_EQ(model_bytes(learner, 0), bytes) << "episode " << episode;
        learner.end(0.0, state_id(0), false);
    }
    EXPECT_GT(learner.states(), 100u);
}

TYPED_TEST(LearnerAllocation, LookingAllocatesNothing) {
    TypeParam learner(10, 4);
    const std::size_t before = allocations;
    for (std::size_t s = 0; s < 10; ++s) {
        (void)learner.best(state_id(s));
        (void)learner.terms(state_id(s), action_id(1)).sum();
    }
    EXPECT_EQ(allocations, before);
}

// The planner's searches and its plans for told goals included.
TEST(AdaptiveAllocation, NeitherStepsNorEndsNorGoalsAllocateAfterReserve) {
    AdaptiveParams<> params;
    params.trust.tau = 10.0;
    AdaptiveSspql<> learner(StateCount::growing(), Room::actions, params, 1);
    learner.reserve(Room::states);
    for (std::size_t s = 0; s < Room::states; ++s) learner.grow(s + 1);
    const std::vector<Goal> nowhere;
    Room room(1, 0.2);
    Room changed(1, 0.0);
    const std::size_t before = allocations;
    for (int episode = 0; episode < 300; ++episode) {
        StateId s = Room::at(0, 0);
        (void)learner.begin(s);
        for (int k = 0; k < 200 && s != Room::at(4, 4); ++k) {
            if (k > 0) (void)learner.step(0.0, s);
            s = (episode / 50 % 2 == 0 ? room : changed).step(s, learner.action());
        }
        learner.end(s == Room::at(4, 4) ? 1.0 : 0.0, s, s == Room::at(4, 4));
    }
    EXPECT_EQ(allocations - before, 0u);
    EXPECT_GT(learner.status().steps, 2400u);
}
