// SPDX-License-Identifier: MIT
// What makes a tree of shortest paths right, for generated graphs, goals and cost policies.
#ifdef SSPQL_HAS_RAPIDCHECK
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

#include <sspql/model/transition_counts.hpp>
#include <sspql/paths/cost_publisher.hpp>
#include <sspql/paths/dary_heap.hpp>
#include <sspql/paths/reverse_graph.hpp>
#include <sspql/paths/shortest_paths.hpp>
#include <sspql/paths/ssp_values.hpp>
#include <sspql/spaces/legal_actions.hpp>

namespace {

using sspql::Goal;
using sspql::no_state;
using sspql::ReverseGraph;
using sspql::ShortestPathTree;
using sspql::state_id;
using sspql::StateId;

constexpr int states = 25;
constexpr double infinity = std::numeric_limits<double>::infinity();

StateId as_state(int i) { return state_id(static_cast<std::size_t>(i)); }

/// Costs from 0 (raised to the floor) through ties to very large ones (that absorb the others).
ReverseGraph graph() {
    const auto cost = rc::gen::element(0.0, 0.5, 1.0, 1.0, 2.0, 3.25, 1e6, 1e20);
    const auto edges =
        *rc::gen::scale(3.0, rc::gen::container<std::vector<std::tuple<int, int, double>>>(
                                 rc::gen::tuple(rc::gen::inRange(0, states), rc::gen::inRange(0, states), cost)));
    std::vector<sspql::CostEdge> list;
    for (const auto& [from, to, c] : edges) list.push_back({as_state(from), as_state(to), c});
    return ReverseGraph::from_edges(states, list);
}

std::vector<Goal> goals() {
    const auto drawn = *rc::gen::container<std::vector<std::pair<int, double>>>(
        rc::gen::pair(rc::gen::inRange(0, states), rc::gen::element(0.0, 0.0, 1.0, 2.5)));
    std::vector<Goal> list;
    for (const auto& [state, offset] : drawn) list.push_back({as_state(state), offset});
    return list;
}

}  // namespace

RC_GTEST_PROP(TreeProperty, NoEdgeLeadsNearer, ()) {
    const ReverseGraph g = graph();
    const ShortestPathTree tree = shortest_paths_to(g, goals());
    for (std::size_t v = 0; v < g.size(); ++v) {
        g.for_each_predecessor(state_id(v), [&](StateId u, double cost) {
            RC_ASSERT(tree.distance[index(u)] <= tree.distance[v] + cost);
        });
    }
}

RC_GTEST_PROP(TreeProperty, ADistanceIsACostPlusTheNextDistanceOrAnOffset, ()) {
    const ReverseGraph g = graph();
    const std::vector<Goal> list = goals();
    const ShortestPathTree tree = shortest_paths_to(g, list);
    for (std::size_t s = 0; s < g.size(); ++s) {
        bool explained = tree.distance[s] == infinity && tree.next[s] == no_state;
        for (const Goal& goal : list) {
            RC_ASSERT(index(goal.state) != s || tree.distance[s] <= goal.offset);
            explained =
                explained || (index(goal.state) == s && tree.distance[s] == goal.offset && tree.next[s] == no_state);
        }
        if (tree.next[s] != no_state) {
            g.for_each_predecessor(tree.next[s], [&](StateId u, double cost) {
                explained =
                    explained || (index(u) == s && tree.distance[s] == tree.distance[index(tree.next[s])] + cost);
            });
        }
        RC_ASSERT(explained);
    }
}

RC_GTEST_PROP(TreeProperty, EveryPathEndsAtAGoal, ()) {
    const ReverseGraph g = graph();
    const std::vector<Goal> list = goals();
    const ShortestPathTree tree = shortest_paths_to(g, list);
    for (std::size_t s = 0; s < g.size(); ++s) {
        std::size_t length = 0;
        StateId at = state_id(s);
        while (tree.next[index(at)] != no_state) {
            RC_ASSERT(++length < g.size());
            RC_ASSERT(tree.distance[index(tree.next[index(at)])] <= tree.distance[index(at)]);
            at = tree.next[index(at)];
        }
        bool goal = !tree.reaches_goal(state_id(s));
        for (const Goal& candidate : list) goal = goal || candidate.state == at;
        RC_ASSERT(goal);
    }
}

RC_GTEST_PROP(TreeProperty, DistancesDoNotDependOnTheQueue, ()) {
    const ReverseGraph g = graph();
    const std::vector<Goal> list = goals();
    ShortestPathTree other;
    sspql::DaryHeap<3> queue;
    shortest_paths_to(g, list, queue, other);
    RC_ASSERT(shortest_paths_to(g, list).distance == other.distance);
}

RC_GTEST_PROP(TreeProperty, SspValuesLieInZeroToOneOnOneActionAState, ()) {
    sspql::TransitionCounts<sspql::CountCell> counts(states, 3);
    using Step = std::tuple<int, int, int>;
    const auto steps =
        *rc::gen::scale(3.0, rc::gen::container<std::vector<Step>>(rc::gen::tuple(
                                 rc::gen::inRange(0, states), rc::gen::inRange(0, 3), rc::gen::inRange(0, states))));
    for (const auto& [s, a, next] : steps) {
        counts.record(as_state(s), sspql::action_id(static_cast<std::size_t>(a)), as_state(next));
    }
    sspql::CostPublisher<>().publish(counts);
    ReverseGraph g;
    g.assign(counts);
    const ShortestPathTree tree = shortest_paths_to(g, {{as_state(0)}});
    sspql::SspValues values;
    values.assign(counts, tree, sspql::AllActions{});
    for (std::size_t s = 0; s < states; ++s) {
        int positive = 0;
        for (std::size_t a = 0; a < 3; ++a) {
            const double value = values(state_id(s), sspql::action_id(a));
            RC_ASSERT(value >= 0.0);
            RC_ASSERT(value <= 1.0);
            positive += value > 0.0 ? 1 : 0;
        }
        RC_ASSERT(positive == (tree.next[s] != no_state ? 1 : 0));
    }
}
#endif
