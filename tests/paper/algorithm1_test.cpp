// SPDX-License-Identifier: MIT
// Algorithm 1, the function SSP(V, E, w, goal), on a model small enough to work out by hand.
//
//   observed                                   P(s'|s,a)            P(s'|s) (eq. 3)       EC = e^{-2P} (eq. 2)
//   0 -a0-> 1 three times, 2 once              3/4, 1/4             1: 3/4                e^{-1.5} = 0.223130
//   0 -a1-> 2 three times, 0 once              3/4, 1/4             2: 1/4 + 3/4 = 1      e^{-2}   = 0.135335
//                                                                   0: 1/4                e^{-0.5} = 0.606531
//   1 -a0-> 4 once, 1 once                     1/2, 1/2             4: 1/2                e^{-1}   = 0.367879
//                                                                   1: 1/2                e^{-1}   = 0.367879
//   2 -a0-> 3 once                             1                    3: 1 + 1/2 = 3/2      e^{-3}   = 0.049787
//   2 -a1-> 3 once, 0 once                     1/2, 1/2             0: 1/2                e^{-1}   = 0.367879
//   3 -a0-> 4 once                             1                    4: 1                  e^{-2}   = 0.135335
//
//   0 ----> 1 ----> 4      distances to the goal 4:
//   |               ^      d(3) = 0.135335
//   '-> 2 ----> 3 --'      d(2) = 0.049787 + 0.135335 = 0.185122
//                          d(1) = 0.367879
//                          d(0) = min(0.223130 + 0.367879, 0.135335 + 0.185122) = min(0.591010, 0.320457), by way of 2
//   5: never seen
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/learn/sspql.hpp>
#include <sspql/model/transition_counts.hpp>
#include <sspql/paths/cost_publisher.hpp>
#include <sspql/paths/reverse_graph.hpp>
#include <sspql/paths/shortest_paths.hpp>
#include <sspql/paths/ssp_values.hpp>
#include <sspql/spaces/legal_actions.hpp>

using sspql::ActionId;
using sspql::CountCell;
using sspql::no_action;
using sspql::no_state;
using sspql::state_id;
using sspql::StateId;
using sspql::TransitionCounts;

namespace {

constexpr ActionId a0{0}, a1{1};
constexpr StateId s0{0}, s1{1}, s2{2}, s3{3}, s4{4}, s5{5};

struct Observed {
    int times;
    StateId s;
    ActionId a;
    StateId next;
};
const std::vector<Observed> observed{{3, s0, a0, s1}, {1, s0, a0, s2}, {3, s0, a1, s2}, {1, s0, a1, s0},
                                     {1, s1, a0, s4}, {1, s1, a0, s1}, {1, s2, a0, s3}, {1, s2, a1, s3},
                                     {1, s2, a1, s0}, {1, s3, a0, s4}};

TransitionCounts<CountCell> model() {
    TransitionCounts<CountCell> counts(6, 2);
    for (const Observed& o : observed) {
        for (int i = 0; i < o.times; ++i) counts.record(o.s, o.a, o.next, o.next == s4, o.next == s4 ? 1.0 : 0.0);
    }
    return counts;
}

template <class Values>
void expect_values(const Values& values) {
    // 0 goes on to 2, where a1 leads with 3/4 and a0 with 1/4; H(0,a1) is that of (3/4, 1/4).
    EXPECT_EQ(values.action(s0), a1);
    EXPECT_NEAR(values(s0, a1), 0.569877, 1e-6);
    EXPECT_EQ(values(s0, a0), 0.0);
    // 1 goes on to 4 by a0, one try of two: e^{-ln 2} = 1/2.
    EXPECT_EQ(values.action(s1), a0);
    EXPECT_DOUBLE_EQ(values(s1, a0), 0.5);
    // 2 goes on to 3, surely by a0 (a1: 1/2); 3 to 4, surely.
    EXPECT_EQ(values.action(s2), a0);
    EXPECT_EQ(values(s2, a0), 1.0);
    EXPECT_EQ(values(s2, a1), 0.0);
    EXPECT_EQ(values(s3, a0), 1.0);
    for (const StateId s : {s4, s5}) EXPECT_EQ(values.action(s), no_action);
}

}  // namespace

// Lines 4 to 8.
TEST(Algorithm1, UpdatesTheExpectedCostOfEveryEdge) {
    auto counts = model();
    EXPECT_EQ(sspql::CostPublisher<>().publish(counts), 8u);
    const std::map<std::pair<std::size_t, std::size_t>, double> expected{
        {{0, 1}, 0.223130}, {{0, 2}, 0.135335}, {{0, 0}, 0.606531}, {{1, 4}, 0.367879},
        {{1, 1}, 0.367879}, {{2, 3}, 0.049787}, {{2, 0}, 0.367879}, {{3, 4}, 0.135335}};
    for (std::size_t s = 0; s < 6; ++s) {
        counts.for_each_successor(state_id(s), [&](const auto& successor) {
            EXPECT_NEAR(successor.label(), expected.at({s, index(successor.state())}), 1e-6);
        });
    }
}

// Line 9.
TEST(Algorithm1, FindsTheShortestPathsFromAllStates) {
    auto counts = model();
    sspql::CostPublisher<>().publish(counts);
    sspql::ReverseGraph graph;
    graph.assign(counts);
    const sspql::ShortestPathTree tree = shortest_paths_to(graph, {{s4}});
    EXPECT_EQ(tree.next, (std::vector<StateId>{s2, s4, s3, s4, no_state, no_state}));
    EXPECT_NEAR(tree.distance[0], 0.320457, 1e-6);
    EXPECT_NEAR(tree.distance[1], 0.367879, 1e-6);
    EXPECT_NEAR(tree.distance[2], 0.185122, 1e-6);
    EXPECT_NEAR(tree.distance[3], 0.135335, 1e-6);
    EXPECT_EQ(tree.distance[4], 0.0);
    EXPECT_EQ(tree.distance[5], std::numeric_limits<double>::infinity());
    EXPECT_EQ(tree.path(s0), (std::vector<StateId>{s0, s2, s3, s4}));
}

// Lines 1 to 3 and 10 to 16.
TEST(Algorithm1, GivesTheTreeEdgesTheirValuesAndAllElseZero) {
    auto counts = model();
    sspql::CostPublisher<>().publish(counts);
    sspql::ReverseGraph graph;
    graph.assign(counts);
    sspql::SspValues values;
    values.assign(counts, shortest_paths_to(graph, {{s4}}), sspql::AllActions{});
    expect_values(values);
}

// The same, done by the learner that saw the same steps: 4 becomes the goal by its reward.
TEST(Algorithm1, IsWhatTheLearnerRuns) {
    sspql::Sspql<> learner(6, 2);
    for (const Observed& o : observed) {
        for (int i = 0; i < o.times; ++i) learner.observe(o.s, o.a, o.next == s4 ? 1.0 : 0.0, o.next, o.next == s4);
    }
    learner.update_paths();
    ASSERT_EQ(learner.goals().size(), 1u);
    EXPECT_EQ(learner.goals().front().state, s4);
    EXPECT_EQ(learner.tree().next, (std::vector<StateId>{s2, s4, s3, s4, no_state, no_state}));
    expect_values(learner.ssp_values());
}

// Another goal, the same model: nothing has to be learnt anew. To 0 from 2: e^{-1}; 1, 3 and 4 have no way.
TEST(Algorithm1, RunsForAnyGoal) {
    sspql::Sspql<> learner(6, 2);
    for (const Observed& o : observed) {
        for (int i = 0; i < o.times; ++i) learner.observe(o.s, o.a, 0.0, o.next, o.next == s4);
    }
    learner.set_goals({{s0, 0.0}});
    EXPECT_EQ(learner.tree().next, (std::vector<StateId>{no_state, no_state, s0, no_state, no_state, no_state}));
    EXPECT_NEAR(learner.tree().distance[2], 0.367879, 1e-6);
    EXPECT_DOUBLE_EQ(learner.ssp_values()(s2, a1), 0.5);
}
