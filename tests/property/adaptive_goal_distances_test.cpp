// SPDX-License-Identifier: MIT
// GoalDistances on random models: the shortest paths over weight / P by two other ways, whatever the budget slices, and
// whatever is recorded while a search runs.
#include <sspql/learn/adaptive/goal_distances.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/core/random.hpp>
#include <sspql/paths/shortest_paths.hpp>

using namespace sspql;

namespace {

using Counts = GoalDistances::Counts;
constexpr double unknown = GoalDistances::unknown;

double step_cost(double mean_reward) { return std::max(1.0, -mean_reward); }

void record_some(Counts& counts, std::size_t times, Random& random) {
    for (std::size_t k = 0; k < times; ++k) {
        const StateId s = state_id(random.below(counts.states()));
        const ActionId a = action_id(random.below(counts.actions()));
        const StateId next = state_id(random.below(counts.states()));
        const bool terminal = random.chance(0.1);
        counts.record(s, a, next, terminal, random.uniform(-4.0, 1.0));
    }
}

void fade_some(Counts& counts, std::size_t times, Random& random) {
    for (std::size_t k = 0; k < times; ++k) {
        const StateId s = state_id(random.below(counts.states()));
        counts.fade(s, action_id(random.below(counts.actions())), random.uniform(), 0.2);
    }
}

std::vector<Goal> some_seeds(std::size_t states, Random& random) {
    std::vector<Goal> seeds(random.below(4));
    for (Goal& seed : seeds) {
        seed.state = state_id(random.below(states));
        seed.offset = random.uniform(0.0, 5.0);
    }
    return seeds;
}

/// PredecessorGraph of the counts, an edge costing weight / P of its best action: written down, not learnt from labels.
struct Graph {
    struct Edge {
        StateId from;
        double cost;
    };
    explicit Graph(const Counts& counts) : into(counts.states()) {
        for (std::size_t s = 0; s < counts.states(); ++s) {
            for (std::size_t next = 0; next < counts.states(); ++next) {
                double best = unknown;
                for (std::size_t i = 0; i < counts.actions(); ++i) {
                    const ActionId a = action_id(i);
                    const FadingCell* cell = counts.cell(state_id(s), a, state_id(next));
                    if (cell == nullptr || cell->terminal() || cell->n < 0.5) continue;
                    best = std::min(best, step_cost(cell->mean_reward()) * counts.n(state_id(s), a) / cell->n);
                }
                if (best < unknown && s != next) into[next].push_back({state_id(s), best});
            }
        }
    }
    [[nodiscard]] std::size_t size() const { return into.size(); }
    [[nodiscard]] double least_cost() const { return 1.0; }
    [[nodiscard]] double greatest_cost() const { return 1e6; }
    template <class F>
    void for_each_predecessor(StateId s, F&& f) const {
        for (const Edge& edge : into[index(s)]) f(edge.from, edge.cost);
    }
    std::vector<std::vector<Edge>> into;
};

/// Bellman and Ford: no queue, no order.
std::vector<double> by_relaxation(const Graph& graph, const std::vector<Goal>& seeds) {
    std::vector<double> distance(graph.size(), unknown);
    for (const Goal& seed : seeds) distance[index(seed.state)] = std::min(distance[index(seed.state)], seed.offset);
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t v = 0; v < graph.size(); ++v) {
            graph.for_each_predecessor(state_id(v), [&](StateId u, double cost) {
                if (!(distance[v] + cost < distance[index(u)])) return;
                distance[index(u)] = distance[v] + cost;
                changed = true;
            });
        }
    }
    return distance;
}

std::vector<double> found(const GoalDistances& distances, std::size_t states) {
    std::vector<double> all;
    for (std::size_t s = 0; s < states; ++s) all.push_back(distances.distance(state_id(s)));
    return all;
}

/// Advances in slices of `edges` until the search is finished; each call keeps to its slice and one state's edges.
template <class Between>
void finish_in_slices(GoalDistances& distances, const Counts& counts, std::uint64_t edges, const Between& between) {
    std::size_t most = 1;
    for (bool finished = false; !finished; between()) {
        for (std::size_t s = 0; s < counts.states(); ++s) most = std::max(most, counts.in_degree(state_id(s)) + 1);
        StepBudget budget(edges, edges);
        budget.earn();
        const std::size_t before = distances.work();
        finished = distances.advance(counts, budget);
        ASSERT_LT(distances.work() - before, edges + most);
    }
}

struct Model {
    explicit Model(std::uint64_t seed)
        : random(seed), counts(1 + random.below(30), 1 + random.below(10)), distances(counts.states()) {
        record_some(counts, random.below(6 * counts.states()), random);
        fade_some(counts, random.below(counts.states()), random);
        seeds = some_seeds(counts.states(), random);
    }
    Random random;
    Counts counts;
    GoalDistances distances;
    std::vector<Goal> seeds;
};

constexpr std::uint64_t cases = 400;

}  // namespace

TEST(GoalDistancesProperty, AreShortestPathsOverWeightByProbability) {
    std::size_t reached = 0;
    for (std::uint64_t seed = 1; seed <= cases; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Model m(seed);
        m.distances.refresh(m.counts, step_cost);
        m.distances.start(m.seeds);
        finish_in_slices(m.distances, m.counts, 1 + m.random.below(200), [] {});
        const Graph graph(m.counts);
        const std::vector<double> distances = found(m.distances, m.counts.states());
        ASSERT_EQ(distances, shortest_paths_to(graph, m.seeds).distance);
        ASSERT_EQ(distances, by_relaxation(graph, m.seeds));
        for (const double d : distances) reached += d < unknown ? 1u : 0u;
    }
    EXPECT_GE(reached, 5 * cases) << "too few states reach a seed to test anything";
}

TEST(GoalDistancesProperty, DoNotDependOnTheSlices) {
    for (std::uint64_t seed = 1; seed <= cases; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Model m(seed);
        m.distances.refresh(m.counts, step_cost);
        GoalDistances other = m.distances;
        m.distances.start(m.seeds);
        other.start(m.seeds);
        finish_in_slices(m.distances, m.counts, 1000000, [] {});
        finish_in_slices(other, m.counts, 1 + seed % 7, [] {});
        ASSERT_EQ(found(m.distances, m.counts.states()), found(other, m.counts.states()));
        ASSERT_EQ(m.distances.work(), other.work());
    }
}

TEST(GoalDistancesProperty, RecordsDuringASearchWaitForTheNext) {
    for (std::uint64_t seed = 1; seed <= cases; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Model m(seed);
        m.distances.refresh(m.counts, step_cost);
        m.distances.start(m.seeds);
        const std::vector<double> expected = by_relaxation(Graph(m.counts), m.seeds);
        finish_in_slices(m.distances, m.counts, 1 + m.random.below(20), [&] {
            if (m.random.chance(0.2)) {
                m.counts.grow(m.counts.states() + 1);
                m.distances.grow(m.counts.states());
            }
            record_some(m.counts, m.random.below(4), m.random);
            ASSERT_EQ(m.distances.refresh(m.counts, step_cost) != 0 && m.distances.searching(), false);
        });
        ASSERT_EQ(found(m.distances, expected.size()), expected);
        for (std::size_t s = expected.size(); s < m.counts.states(); ++s) {
            ASSERT_EQ(m.distances.distance(state_id(s)), unknown);
        }
    }
}

TEST(GoalDistancesProperty, WhateverHappensDuringASearchTheNextIsRight) {
    for (std::uint64_t seed = 1; seed <= cases; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Model m(seed);
        for (int round = 0; round < 4; ++round) {
            m.distances.refresh(m.counts, step_cost);
            m.distances.start(m.seeds);
            finish_in_slices(m.distances, m.counts, 1 + m.random.below(20), [&] {
                record_some(m.counts, m.random.below(4), m.random);
                fade_some(m.counts, m.random.below(4), m.random);
            });
            m.seeds = some_seeds(m.counts.states(), m.random);
        }
        m.distances.refresh(m.counts, step_cost);
        m.distances.start(m.seeds);
        finish_in_slices(m.distances, m.counts, 1000, [] {});
        ASSERT_EQ(found(m.distances, m.counts.states()), by_relaxation(Graph(m.counts), m.seeds));
    }
}
