// SPDX-License-Identifier: MIT
// SspValues beside eq. 5's hand-worked values in tests/paper: sizes, masks, growth, and a brute-force comparison.
#include <sspql/paths/ssp_values.hpp>

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/paths/cost_publisher.hpp>
#include <sspql/paths/reverse_graph.hpp>
#include <sspql/spaces/legal_actions.hpp>

using sspql::action_id;
using sspql::ActionId;
using sspql::AllActions;
using sspql::CountCell;
using sspql::no_action;
using sspql::no_state;
using sspql::Random;
using sspql::ShortestPathTree;
using sspql::SspValues;
using sspql::state_id;
using sspql::StateId;
using sspql::TransitionCounts;

namespace {

constexpr ActionId a0{0}, a1{1};
constexpr StateId s0{0}, s1{1};

/// Allows even actions only.
struct EvenActions {
    struct Even {
        [[nodiscard]] bool contains(ActionId a) const { return index(a) % 2 == 0; }
    };
    [[nodiscard]] Even allowed(StateId) const { return {}; }
};

template <class LegalActions>
void expect_brute_force(const TransitionCounts<CountCell>& counts, const ShortestPathTree& tree,
                        const LegalActions& legal) {
    SspValues values;
    values.assign(counts, tree, legal);
    for (std::size_t s = 0; s < counts.states(); ++s) {
        ActionId best = no_action;
        double most = 0.0;
        for (std::size_t a = 0; a < counts.actions() && tree.next[s] != no_state; ++a) {
            if (!legal.allowed(state_id(s)).contains(action_id(a))) continue;
            const double p = probability(counts, state_id(s), action_id(a), tree.next[s]);
            if (p > most) {
                most = p;
                best = action_id(a);
            }
        }
        ASSERT_EQ(values.action(state_id(s)), best) << "state " << s;
        for (std::size_t a = 0; a < counts.actions(); ++a) {
            const double expected = action_id(a) == best ? std::exp(-entropy(counts, state_id(s), best)) : 0.0;
            ASSERT_EQ(values(state_id(s), action_id(a)), expected) << "state " << s << ", action " << a;
        }
    }
}

}  // namespace

TEST(SspValues, AreZeroBeforeTheFirstAssign) {
    const SspValues values;
    EXPECT_EQ(values(s0, a0), 0.0);
    EXPECT_EQ(values.action(s0), no_action);
}

TEST(SspValues, ForgetWithClearAndAreZeroForStatesAddedSince) {
    TransitionCounts<CountCell> counts(2, 2);
    counts.record(s0, a1, s1);
    ShortestPathTree tree;
    tree.distance = {1.0, 0.0};
    tree.next = {s1, no_state};
    SspValues values;
    values.assign(counts, tree, AllActions{});
    EXPECT_EQ(values(s0, a1), 1.0);
    EXPECT_EQ(values.action(s0), a1);
    EXPECT_EQ(values(s1, a1), 0.0) << "the goal itself";
    EXPECT_EQ(values(state_id(2), a1), 0.0);
    EXPECT_EQ(values.action(state_id(2)), no_action);
    values.clear();
    EXPECT_EQ(values(s0, a1), 0.0);
}

TEST(SspValues, StandAsOfTheLastAssign) {
    TransitionCounts<CountCell> counts(2, 1);
    counts.record(s0, a0, s1);
    ShortestPathTree tree;
    tree.distance = {1.0, 0.0};
    tree.next = {s1, no_state};
    SspValues values;
    values.assign(counts, tree, AllActions{});
    counts.record(s0, a0, s0);
    EXPECT_EQ(values(s0, a0), 1.0);
    values.assign(counts, tree, AllActions{});
    EXPECT_DOUBLE_EQ(values(s0, a0), 0.5) << "H = ln 2 by now";
}

TEST(SspValues, AreThoseOfBruteForce) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const std::size_t n = 2 + random.below(30);
        const std::size_t actions = 1 + random.below(14);
        TransitionCounts<CountCell> counts(n, actions);
        for (std::size_t i = 0; i < 8 * n; ++i) {
            const StateId s = state_id(random.below(n));
            const ActionId a = action_id(random.below(actions));
            counts.record(s, a, state_id(random.below(n)));
        }
        sspql::CostPublisher<>().publish(counts);
        sspql::ReverseGraph graph;
        graph.assign(counts);
        const ShortestPathTree tree = shortest_paths_to(graph, {{state_id(random.below(n))}});
        expect_brute_force(counts, tree, AllActions{});
        expect_brute_force(counts, tree, EvenActions{});
        if (HasFailure()) return;
    }
}
