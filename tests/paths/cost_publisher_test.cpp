// SPDX-License-Identifier: MIT
#include <sspql/paths/cost_publisher.hpp>

#include <cstdint>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/paths/cost.hpp>

using sspql::action_id;
using sspql::ActionId;
using sspql::BestAction;
using sspql::CostPublisher;
using sspql::CountCell;
using sspql::ExpectedTries;
using sspql::FadingCell;
using sspql::Random;
using sspql::RiskWeighted;
using sspql::state_id;
using sspql::StateId;
using sspql::SumOverActions;
using sspql::TransitionCounts;

namespace {

constexpr ActionId a0{0};
constexpr StateId s0{0}, s1{1}, s2{2};

template <class Counts>
double label(const Counts& counts, StateId s, StateId next) {
    double found = -1.0;
    counts.for_each_successor(s, [&](const auto& successor) {
        if (successor.state() == next) found = successor.label();
    });
    return found;
}

template <class Cell, class Cost, class Probability>
void expect_labels_right(const TransitionCounts<Cell>& counts, const Cost& cost, const Probability& probability) {
    for (std::size_t s = 0; s < counts.states(); ++s) {
        counts.for_each_successor(state_id(s), [&](const auto& successor) {
            const double expected = cost(successor.weight(), probability(counts, state_id(s), successor));
            EXPECT_EQ(successor.label(), expected) << s << " -> " << index(successor.state());
        });
    }
}

/// Records at random (and fades, where that can be), publishes now and then; then every label must be that of the
/// counts, and in-records must show the same.
template <class Cell, class Cost, class Probability>
void publish_between_random_records(std::uint64_t seed, std::size_t actions) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", actions " + std::to_string(actions));
    Random random(seed);
    constexpr std::size_t states = 60;
    TransitionCounts<Cell> counts(states, actions);
    const CostPublisher<Cost, Probability> publisher;
    for (int i = 0; i < 1500; ++i) {
        const StateId s = state_id(random.chance(0.4) ? 0 : random.below(states));
        const ActionId a = action_id(random.below(actions));
        const StateId next = state_id(random.chance(0.3) ? 0 : random.below(states));
        counts.record(s, a, next, false, 0.0, random.chance(0.3) ? random.uniform(0.5, 5.0) : 1.0);
        if constexpr (std::is_same_v<Cell, FadingCell>) {
            if (random.chance(0.05)) counts.fade(s, a, 0.4, 0.5);
        }
        if (!random.chance(0.02)) continue;
        publisher.publish(counts);
        EXPECT_TRUE(counts.dirty().empty());
        expect_labels_right(counts, Cost{}, Probability{});
        if (testing::Test::HasFailure()) return;
    }
    publisher.publish(counts);
    for (std::size_t v = 0; v < states; ++v) {
        counts.for_each_predecessor(state_id(v),
                                    [&](StateId u, double cost) { EXPECT_EQ(cost, label(counts, u, state_id(v))); });
    }
}

}  // namespace

// A mark on an edge of a clean state stays until that state is recorded again.
TEST(CostPublisher, RefreshesDirtyStatesOnly) {
    TransitionCounts<CountCell> counts(3, 1);
    const CostPublisher<> publisher;
    counts.record(s0, a0, s1);
    counts.record(s0, a0, s2);
    EXPECT_EQ(publisher.publish(counts), 2u) << "edges refreshed";
    EXPECT_EQ(publisher.publish(counts), 0u);
    counts.for_each_successor(s0, [&](const auto& successor) { counts.set_label(successor, 123.0); });
    counts.record(s2, a0, s1);
    EXPECT_EQ(publisher.publish(counts), 1u);
    EXPECT_EQ(label(counts, s0, s1), 123.0);
    EXPECT_EQ(label(counts, s2, s1), RiskWeighted()(1.0, 1.0));
    counts.record(s0, a0, s1);
    EXPECT_EQ(publisher.publish(counts), 2u) << "all edges of the state, its other outcomes became less likely";
    EXPECT_EQ(label(counts, s0, s1), RiskWeighted()(1.0, 2.0 / 3.0));
    EXPECT_EQ(label(counts, s0, s2), RiskWeighted()(1.0, 1.0 / 3.0));
}

TEST(CostPublisher, UsesItsPolicies) {
    TransitionCounts<CountCell> counts(3, 2);
    counts.record(s0, a0, s1, false, 0.0, 6.0);
    counts.record(s0, a0, s2, false, 0.0, 6.0);
    counts.record(s0, action_id(1), s1, false, 0.0, 6.0);
    counts.record(s0, action_id(1), s2, false, 0.0, 6.0);
    CostPublisher<ExpectedTries, BestAction>().publish(counts);
    EXPECT_EQ(label(counts, s0, s1), 12.0) << "best of 1/2 and 1/2";
    counts.record(s0, a0, s1, false, 0.0, 6.0);
    CostPublisher<RiskWeighted, BestAction> publisher(RiskWeighted(3.0));
    publisher.publish(counts);
    EXPECT_EQ(publisher.cost().lambda(), 3.0);
    EXPECT_EQ(label(counts, s0, s1), RiskWeighted(3.0)(6.0, 2.0 / 3.0));
}

TEST(CostPublisher, LabelsAreThoseOfTheCountsAfterRandomRecords) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        for (const std::size_t actions : {1u, 3u, 8u, 9u, 30u}) {
            publish_between_random_records<CountCell, RiskWeighted, SumOverActions>(seed, actions);
            publish_between_random_records<FadingCell, ExpectedTries, BestAction>(seed, actions);
        }
    }
}
