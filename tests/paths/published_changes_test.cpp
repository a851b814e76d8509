// SPDX-License-Identifier: MIT
#include <sspql/paths/published_changes.hpp>

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/paths/cost_publisher.hpp>

using namespace sspql;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr ActionId a0{0};
constexpr StateId s0{0}, s1{1}, s2{2};

double label(const TransitionCounts<CountCell>& counts, StateId s, StateId next) {
    double found = -1.0;
    counts.for_each_successor(s, [&](const auto& edge) {
        if (edge.state() == next) found = edge.label();
    });
    return found;
}

}  // namespace

TEST(PublishedChanges, NamesTheEdgesThatChangedAndHow) {
    TransitionCounts<CountCell> counts(3, 1);
    const CostPublisher<> publisher;
    PublishedChanges changes;
    counts.record(s0, a0, s1);
    changes.begin();
    EXPECT_EQ(publisher.publish(counts, changes), 1u);
    EXPECT_EQ(changes.states(), std::vector<StateId>{s0});
    ASSERT_EQ(changes.edges().size(), 1u);
    EXPECT_EQ(changes.edges()[0].old_cost, infinity);
    EXPECT_TRUE(changes.edges()[0].improved());
    EXPECT_EQ(changes.added(), 1u);

    counts.record(s0, a0, s2);
    counts.record(s2, a0, s2);
    const double before = label(counts, s0, s1);
    changes.begin();
    publisher.publish(counts, changes);
    EXPECT_EQ(changes.states(), (std::vector<StateId>{s0, s2}));
    ASSERT_EQ(changes.edges().size(), 3u);
    const CostChange& worse = changes.edges()[0];
    EXPECT_EQ(worse.from, s0);
    EXPECT_EQ(worse.to, s1);
    EXPECT_EQ(worse.old_cost, before);
    EXPECT_EQ(worse.new_cost, label(counts, s0, s1));
    EXPECT_TRUE(worse.worsened());
    EXPECT_FALSE(worse.improved());
    EXPECT_EQ(changes.added(), 2u);
    EXPECT_EQ(changes.changed(), 3u);
    EXPECT_EQ(changes.touched(), 3u);
    EXPECT_EQ(changes.least(), label(counts, s2, s2));
    EXPECT_EQ(changes.greatest(), label(counts, s0, s1));
}

// A state seen again with the only outcome it ever had: the cost is what it was.
TEST(PublishedChanges, ACostThatStaysIsNoChange) {
    TransitionCounts<CountCell> counts(2, 1);
    PublishedChanges changes;
    counts.record(s0, a0, s1);
    CostPublisher<>().publish(counts);
    counts.record(s0, a0, s1);
    changes.begin();
    EXPECT_EQ(CostPublisher<>().publish(counts, changes), 1u);
    EXPECT_EQ(changes.states().size(), 1u);
    EXPECT_TRUE(changes.edges().empty());
    EXPECT_EQ(changes.changed(), 0u);
    EXPECT_EQ(changes.least(), infinity);
}

TEST(PublishedChanges, ListsEndWhereNobodyWouldReadThem) {
    TransitionCounts<CountCell> counts(10, 1);
    for (std::size_t s = 0; s < 9; ++s) counts.record(state_id(s), a0, state_id(s + 1));
    PublishedChanges changes;
    changes.begin(9);
    CostPublisher<>().publish(counts, changes);
    EXPECT_TRUE(changes.complete());
    EXPECT_EQ(changes.edges().size(), 9u);
    for (std::size_t s = 0; s < 9; ++s) counts.record(state_id(s), a0, s0);
    changes.begin(8);
    CostPublisher<>().publish(counts, changes);
    EXPECT_FALSE(changes.complete());
    EXPECT_TRUE(changes.edges().empty());
    EXPECT_TRUE(changes.states().empty());
    EXPECT_EQ(changes.changed(), 18u) << "counted all the same: each state has an edge to 0 now, and one it had";
    changes.begin(8);
    EXPECT_TRUE(changes.complete());
}

TEST(PublishedChanges, WithinTheToleranceALabelStays) {
    TransitionCounts<CountCell> counts(3, 1);
    const CostPublisher<> publisher(RiskWeighted{}, {}, 0.05);
    for (int i = 0; i < 50; ++i) counts.record(s0, a0, s1);
    counts.record(s0, a0, s2);
    publisher.publish(counts);
    const double published = label(counts, s0, s1);
    PublishedChanges changes;
    changes.begin();
    counts.record(s0, a0, s2);
    publisher.publish(counts, changes);
    EXPECT_EQ(label(counts, s0, s1), published) << "50/51 became 50/52";
    EXPECT_EQ(changes.touched(), 2u);
    EXPECT_EQ(changes.changed(), 0u);
    counts.record(s0, a0, s0);
    publisher.publish(counts, changes);
    EXPECT_EQ(changes.added(), 1u) << "a new edge needs a label, whatever the tolerance";
    for (int i = 0; i < 5; ++i) counts.record(s0, a0, s2);
    publisher.publish(counts, changes);
    EXPECT_EQ(label(counts, s0, s1), RiskWeighted()(1.0, 50.0 / 58.0)) << "off by more than 5 % in the end";
}

TEST(PublishedChanges, LabelsStayWithinTheTolerance) {
    for (const double tolerance : {0.01, 0.1, 0.5}) {
        TransitionCounts<CountCell> counts(30, 3);
        const CostPublisher<RiskWeighted> publisher(RiskWeighted(4.0), {}, tolerance);
        Random random(1);
        for (int i = 0; i < 3000; ++i) {
            counts.record(state_id(random.below(30)), action_id(random.below(3)), state_id(random.below(4)), false, 0.0,
                          random.uniform(0.5, 2.0));
            if (!random.chance(0.2)) continue;
            publisher.publish(counts);
            for (std::size_t s = 0; s < 30; ++s) {
                counts.for_each_successor(state_id(s), [&](const auto& edge) {
                    const double cost = RiskWeighted(4.0)(edge.weight(), SumOverActions{}(counts, state_id(s), edge));
                    ASSERT_GE(edge.label(), cost * (1.0 - tolerance) * (1.0 - 1e-15)) << i;
                    ASSERT_LE(edge.label(), cost * (1.0 + tolerance) * (1.0 + 1e-15)) << i;
                });
            }
        }
    }
}

TEST(PublishedChanges, RefusesTolerancesWithoutABound) {
    for (const double tolerance : {-0.01, 0.51, 1.0, infinity, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_THROW(CostPublisher<>(RiskWeighted{}, {}, tolerance), std::invalid_argument) << tolerance;
    }
    EXPECT_EQ(CostPublisher<>(RiskWeighted{}, {}, 0.5).tolerance(), 0.5);
    EXPECT_EQ(CostPublisher<>().tolerance(), 0.0);
}
