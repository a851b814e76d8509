// SPDX-License-Identifier: MIT A tree kept up to date by PathSolver is the one found from scratch, bit for bit,
// whatever was recorded, erased, grown or given as a goal in between; and with a tolerance its paths keep their bound.
#ifdef SSPQL_HAS_RAPIDCHECK
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstddef>
#include <cstring>
#include <ostream>
#include <type_traits>
#include <vector>

#include <sspql/model/transition_counts.hpp>
#include <sspql/paths/auto_queue.hpp>
#include <sspql/paths/cost.hpp>
#include <sspql/paths/dary_heap.hpp>
#include <sspql/paths/fibonacci_heap.hpp>
#include <sspql/paths/path_solver.hpp>
#include <sspql/paths/reverse_graph.hpp>
#include <sspql/paths/shortest_paths.hpp>

namespace {

using namespace sspql;

constexpr std::size_t most_states = 40;
constexpr std::size_t actions = 3;

/// One thing that may happen between two solves. All ids are taken modulo what there is.
struct Event {
    int kind = 0;  // 0-5 a record, 6 a fading, 7 another state, 8 other goals, 9 to 11 a solve
    unsigned s = 0;
    unsigned a = 0;
    unsigned next = 0;
    int weight = 0;
};

std::ostream& operator<<(std::ostream& out, const Event& e) {
    return out << '{' << e.kind << ", " << e.s << ", " << e.a << ", " << e.next << ", " << e.weight << '}';
}

rc::Gen<Event> event() {
    return rc::gen::build<Event>(rc::gen::set(&Event::kind, rc::gen::inRange(0, 12)),
                                 rc::gen::set(&Event::s, rc::gen::inRange(0u, 40u)),
                                 rc::gen::set(&Event::a, rc::gen::inRange(0u, 3u)),
                                 rc::gen::set(&Event::next, rc::gen::inRange(0u, 40u)),
                                 rc::gen::set(&Event::weight, rc::gen::inRange(0, 8)));
}

/// Weights for every corner: all the same, ties of sums, costs that distances absorb, costs below the floor.
const std::vector<std::vector<double>> weight_sets = {
    {1.0}, {0.5, 1.0, 1.0, 1.5}, {1.0, 1.0, 2.0, 3.25, 1e-3}, {1.0, 2.0, 1e17, 1.0}, {1.0, 1e-30, 1e15, 1.0}};

struct Tally {
    std::size_t updates = 0;
    std::size_t unchanged = 0;
    std::size_t repaired = 0;
    std::size_t searched = 0;
    std::size_t erased = 0;
};

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// Applies the events, and compares after each solve.
template <class Cell, class Cost, class Queue>
void keep_up(const std::vector<Event>& events, const std::vector<double>& weights, double tolerance, Tally& tally) {
    TransitionCounts<Cell> counts(most_states / 2, actions);
    PathSolver<Cost, SumOverActions, Queue> solver(Cost{}, SumOverActions{}, tolerance);
    std::vector<Goal> goals{{state_id(0), 0.0}};
    // A learnt corridor with side exits to begin with, so that there is a tree to repair.
    for (std::size_t s = 1; s < most_states / 2; ++s) {
        counts.record(state_id(s), action_id(0), state_id(s - 1));
        counts.record(state_id(s), action_id(1), state_id(s / 2));
    }
    ReverseGraph graph;
    ShortestPathTree fresh;
    FibonacciHeap<> queue;
    for (const Event& e : events) {
        const std::size_t n = counts.states();
        const StateId s = state_id(e.s % n);
        const StateId next = state_id(e.next % n);
        const std::size_t weight = static_cast<std::size_t>(e.weight);
        if (e.kind <= 5) {
            counts.record(s, action_id(e.a), next, false, 0.0, weights[weight % weights.size()]);
        } else if (e.kind == 6) {
            const std::size_t before = counts.pairs();
            if constexpr (std::is_same_v<Cell, FadingCell>) counts.fade(s, action_id(e.a), 0.4, 0.6);
            tally.erased += before - counts.pairs();
        } else if (e.kind == 7) {
            if (e.weight == 0 && n < most_states) counts.grow(n + 1);
        } else if (e.kind == 8) {
            if (e.weight != 0) continue;
            goals = {{s, 0.0}};
            if (e.a == 1) goals.push_back({next, 0.25 * (e.next % 9)});
            if (e.a == 2) goals.insert(goals.end(), {{next, 0.0}, {s, 0.5}});
        }
        ++tally.updates;
        if (e.kind < 9) continue;
        const Solved solved = solver.solve(counts, goals);
        tally.unchanged += solved == Solved::unchanged ? 1 : 0;
        tally.repaired += solved == Solved::repaired ? 1 : 0;
        tally.searched += solved == Solved::searched ? 1 : 0;
        graph.assign(counts);
        shortest_paths_to(graph, goals, queue, fresh);
        RC_ASSERT(same_bits(solver.tree().distance, fresh.distance));
        for (std::size_t i = 0; i < fresh.size(); ++i) {
            const StateId best = fresh.next[i];
            const bool absorbed = best != no_state && fresh.distance[index(best)] == fresh.distance[i];
            RC_ASSERT(solver.tree().next[i] == best || absorbed);  // where d + c == d, the queue decides
            std::size_t length = 0;
            for (StateId at = state_id(i); solver.tree().next[index(at)] != no_state; ++length) {
                RC_ASSERT(length < fresh.size());
                at = solver.tree().next[index(at)];
            }
        }
        for (std::size_t u = 0; u < counts.states(); ++u) {
            counts.for_each_successor(state_id(u), [&](const auto& edge) {
                const double cost = Cost{}(edge.weight(), SumOverActions{}(counts, state_id(u), edge));
                RC_ASSERT(edge.label() >= cost * (1.0 - tolerance) * (1.0 - 1e-15));
                RC_ASSERT(edge.label() <= cost * (1.0 + tolerance) * (1.0 + 1e-15));
            });
        }
    }
}

template <class Cell, class Cost, class Queue>
Tally check(const char* what, double tolerance = 0.0) {
    Tally tally;
    const bool ok = rc::check(what, [&] {
        const auto weights = *rc::gen::elementOf(weight_sets);
        const auto events = *rc::gen::scale(20.0, rc::gen::container<std::vector<Event>>(event()));
        keep_up<Cell, Cost, Queue>(events, weights, tolerance, tally);
    });
    EXPECT_TRUE(ok);
    EXPECT_GE(tally.updates, 30000u);
    EXPECT_GE(tally.unchanged + tally.repaired + tally.searched, 10000u);
    EXPECT_GE(tally.repaired, 1000u);
    EXPECT_GE(tally.searched, 500u);
    EXPECT_GE(tally.unchanged, 100u);
    return tally;
}

}  // namespace

TEST(RepairProperty, FadingAndErasures) {
    EXPECT_GE((check<FadingCell, RiskWeighted, AutoQueue<>>("fading cells, automatic queue").erased), 200u);
    EXPECT_GE((check<FadingCell, RiskWeighted, FibonacciHeap<>>("fading cells, Fibonacci heap").erased), 200u);
}

TEST(RepairProperty, CountsThatOnlyGrow) {
    check<CountCell, RiskWeighted, AutoQueue<>>("counts, automatic queue");
    check<CountCell, LogRisk, DaryHeap<4>>("counts, costs that may be below the floor, 4-ary heap");
}

TEST(RepairProperty, TiesEverywhere) {
    check<FadingCell, HopCount, AutoQueue<>>("every edge costs 1, automatic queue");
    check<FadingCell, HopCount, DaryHeap<2>>("every edge costs 1, binary heap");
}

TEST(RepairProperty, Tolerances) {
    check<FadingCell, RiskWeighted, AutoQueue<>>("tolerance 1 %", 0.01);
    check<CountCell, RiskWeighted, DaryHeap<4>>("tolerance 30 %", 0.3);
}

// Paths that are shortest by the labels cost at most (1 + eps) / (1 - eps) times the optimum under the true costs.
TEST(RepairProperty, PathsWithATolerance) {
    EXPECT_TRUE(rc::check("the bound of CostPublisher", [] {
        const double eps = *rc::gen::element(0.01, 0.05, 0.3, 0.5);
        const auto events = *rc::gen::scale(4.0, rc::gen::container<std::vector<Event>>(event()));
        TransitionCounts<FadingCell> counts(most_states, actions);
        TransitionCounts<FadingCell> exact(most_states, actions);
        PathSolver<RiskWeighted, SumOverActions, AutoQueue<>> tolerant(RiskWeighted{}, {}, eps);
        PathSolver<RiskWeighted, SumOverActions, AutoQueue<>> optimal;
        const std::vector<Goal> goals{{state_id(0), 0.0}};
        for (const Event& e : events) {
            for (auto* c : {&counts, &exact}) {
                if (e.kind == 6) c->fade(state_id(e.s), action_id(e.a), 0.4, 0.6);
                if (e.kind < 6) {
                    c->record(state_id(e.s), action_id(e.a), state_id(e.next % 8), false, 0.0, 1.0 + e.weight);
                }
            }
            if (e.kind < 9) continue;
            tolerant.solve(counts, goals);
            optimal.solve(exact, goals);
            for (std::size_t s = 0; s < most_states; ++s) {
                double walked = 0.0;
                for (StateId at = state_id(s); tolerant.tree().next[index(at)] != no_state;) {
                    const StateId to = tolerant.tree().next[index(at)];
                    exact.for_each_successor(at, [&](const auto& edge) {
                        if (edge.state() == to) walked += edge.label();
                    });
                    at = to;
                }
                RC_ASSERT(tolerant.tree().reaches_goal(state_id(s)) == optimal.tree().reaches_goal(state_id(s)));
                if (!optimal.tree().reaches_goal(state_id(s))) continue;
                RC_ASSERT(walked <= optimal.tree().distance[s] * ((1.0 + eps) / (1.0 - eps)) * (1.0 + 1e-12));
            }
        }
    }));
}
#endif
