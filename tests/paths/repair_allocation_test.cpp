// SPDX-License-Identifier: MIT
// Solving again and again allocates nothing.
#include <sspql/paths/ssp_planner.hpp>

#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/paths/dary_heap.hpp>
#include <sspql/paths/fibonacci_heap.hpp>
#include <sspql/spaces/legal_actions.hpp>

#include "counting_new.hpp"
#include "paths/learnt_grid.hpp"

using namespace sspql;
using namespace sspql::testing;
using sspql_test::allocations;

namespace {

constexpr std::size_t side = 30;
const AllActions legal;

template <class Queue>
class RepairAllocation : public ::testing::Test {};
using Queues = ::testing::Types<FibonacciHeap<>, DaryHeap<4>>;

/// Records at a few places, the same ones each time, so that no new edge needs memory in the counts.
void record_some(TransitionCounts<CountCell>& counts, Random& random) {
    for (int i = 0; i < 20; ++i) {
        const std::size_t s = random.below(side * side);
        const std::size_t a = random.below(4);
        counts.record(state_id(s), action_id(a), state_id(moved(side, s, a)));
    }
}

}  // namespace

TYPED_TEST_SUITE(RepairAllocation, Queues, );

TYPED_TEST(RepairAllocation, WholeSolvesAllocateNothingOnceWarm) {
    auto counts = learnt_grid<CountCell>(side, 20);
    SspPlanner<RiskWeighted, SumOverActions, TypeParam> planner;
    const std::vector<Goal> goals{{state_id(434), 0.0}};
    Random random(1);
    std::size_t before = 0;
    for (int round = 0; round < 300; ++round) {
        if (round == 100) before = allocations;
        for (int i = 0; i < (round < 100 ? 3 : 1); ++i) record_some(counts, random);
        planner.update(counts, goals, legal);
    }
    EXPECT_EQ(allocations - before, 0u);
}

TYPED_TEST(RepairAllocation, InstalmentsAllocateNothingAfterReserve) {
    auto counts = learnt_grid<CountCell>(side, 20);
    const std::vector<Goal> goals{{state_id(434), 0.0}};
    SspPlanner<RiskWeighted, SumOverActions, TypeParam> planner;
    planner.reserve(side * side, counts.pairs());
    StepBudget budget(100, 100);
    Random random(2);
    planner.start(counts, goals);
    std::size_t finished = 0;
    std::size_t before = allocations;
    for (int step = 0; step < 20000; ++step) {
        record_some(counts, random);
        budget.earn();
        if (!planner.advance(counts, legal, budget)) continue;
        if (++finished == 2) before = allocations;  // each tree has searched once: the queue has seen its like
        planner.start(counts, goals);
    }
    EXPECT_GT(finished, 50u);
    EXPECT_EQ(allocations - before, 0u);
}
