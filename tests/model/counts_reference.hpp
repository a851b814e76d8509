// SPDX-License-Identifier: MIT
#pragma once

// What TransitionCounts must say, kept in the plainest way: a map of maps.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <sspql/core/ids.hpp>
#include <sspql/model/transition_counts.hpp>

namespace sspql_test {

class CountsReference {
public:
    struct Entry {
        double n = 0.0;
        double reward = 0.0;
        bool terminal = false;
    };
    struct Pair {
        std::map<std::size_t, Entry> actions;
        double weight = 1.0;
        double label = std::nan("");

        [[nodiscard]] double n() const {
            double sum = 0.0;
            for (const auto& [a, entry] : actions) sum += entry.n;
            return sum;
        }
    };

    void record(std::size_t s, std::size_t a, std::size_t next, bool terminal, double reward, double weight) {
        Pair& pair = pairs_[{s, next}];
        Entry& entry = pair.actions[a];
        entry.n += 1.0;
        entry.reward += reward;
        entry.terminal = terminal;
        const double n = pair.n();
        pair.weight = n <= 1.0 ? weight : (pair.weight * (n - 1.0) + weight) / n;
        dirty_.insert(s);
    }

    void fade(std::size_t s, std::size_t a, double factor, double least) {
        for (auto at = pairs_.begin(); at != pairs_.end();) {
            auto& actions = at->second.actions;
            if (at->first.first == s && actions.count(a) != 0) {
                actions[a].n *= factor;
                actions[a].reward *= factor;
                if (actions[a].n < least) actions.erase(a);
            }
            erasures_ += actions.empty() ? 1 : 0;
            at = actions.empty() ? pairs_.erase(at) : std::next(at);
        }
        dirty_.insert(s);
    }

    void label(std::size_t s, std::size_t next, double value) { pairs_.at({s, next}).label = value; }
    void clear_dirty() { dirty_.clear(); }

    [[nodiscard]] const std::map<std::pair<std::size_t, std::size_t>, Pair>& pairs() const { return pairs_; }

    [[nodiscard]] double n(std::size_t s, std::size_t a) const {
        double sum = 0.0;
        for (const auto& [key, pair] : pairs_) {
            const auto found = pair.actions.find(a);
            if (key.first == s && found != pair.actions.end()) sum += found->second.n;
        }
        return sum;
    }

    /// Everything the counts can be asked, by every road there is to it.
    template <class Cell>
    void expect_same(const sspql::TransitionCounts<Cell>& counts) const {
        using sspql::action_id;
        using sspql::state_id;
        EXPECT_EQ(counts.pairs(), pairs_.size());
        EXPECT_EQ(counts.erasures(), erasures_);
        std::map<std::pair<std::size_t, std::size_t>, double> totals;
        std::map<std::size_t, std::size_t> in, out;
        for (const auto& [key, pair] : pairs_) {
            ++out[key.first];
            ++in[key.second];
            for (const auto& [a, entry] : pair.actions) totals[{key.first, a}] += entry.n;
        }
        std::size_t forward = 0, backward = 0;
        for (std::size_t s = 0; s < counts.states(); ++s) {
            EXPECT_EQ(counts.out_degree(state_id(s)), out[s]) << "state " << s;
            EXPECT_EQ(counts.in_degree(state_id(s)), in[s]) << "state " << s;
            for (std::size_t a = 0; a < counts.actions(); ++a) {
                const double expected = totals[{s, a}];
                EXPECT_NEAR(static_cast<double>(counts.n(state_id(s), action_id(a))), expected, 1e-12 * (1 + expected));
            }
            counts.for_each_successor(state_id(s), [&](const auto& successor) {
                ++forward;
                const auto found = pairs_.find({s, index(successor.state())});
                ASSERT_NE(found, pairs_.end()) << s << " -> " << index(successor.state());
                expect_same_pair(counts, state_id(s), successor, found->second);
            });
            expect_same_outcomes(counts, state_id(s));
            std::size_t edges = 0;
            counts.for_each_edge_into(state_id(s), [&](sspql::StateId u, const auto& edge) {
                ++edges;
                EXPECT_EQ(index(edge.state()), s);
                const auto found = pairs_.find({index(u), s});
                ASSERT_NE(found, pairs_.end()) << index(u) << " -> " << s;
                expect_same_pair(counts, u, edge, found->second);
            });
            EXPECT_EQ(edges, in[s]);
            counts.for_each_predecessor(state_id(s), [&](sspql::StateId u, double label) {
                ++backward;
                const auto found = pairs_.find({index(u), s});
                ASSERT_NE(found, pairs_.end()) << index(u) << " -> " << s;
                expect_same_label(label, found->second.label);
            });
        }
        EXPECT_EQ(forward, pairs_.size());
        EXPECT_EQ(backward, pairs_.size());
        std::set<std::size_t> dirty;
        for (const sspql::StateId s : counts.dirty()) EXPECT_TRUE(dirty.insert(index(s)).second) << "twice in the list";
        EXPECT_EQ(dirty, dirty_);
    }

private:
    static void expect_same_label(double label, double expected) {
        if (std::isnan(expected)) {
            EXPECT_TRUE(std::isnan(label)) << "a label nobody wrote";
        } else {
            EXPECT_EQ(label, expected);
        }
    }

    /// for_each_outcome says of every (s,a) what for_each_successor says, in its order.
    template <class Counts>
    static void expect_same_outcomes(const Counts& counts, sspql::StateId s) {
        for (std::size_t a = 0; a < counts.actions(); ++a) {
            using Cell = std::decay_t<decltype(*counts.cell(s, sspql::action_id(a), s))>;
            std::vector<std::pair<sspql::StateId, const Cell*>> outcomes;
            counts.for_each_outcome(s, sspql::action_id(a), [&](sspql::StateId next, const Cell& cell) {
                outcomes.emplace_back(next, &cell);
            });
            std::size_t place = 0;
            counts.for_each_n(s, sspql::action_id(a), [&](auto n) {
                ASSERT_LT(place, counts.out_degree(s));
                EXPECT_EQ(n, counts.successor(s, place++).n(sspql::action_id(a)));
            });
            EXPECT_EQ(place, counts.out_degree(s));
            std::size_t i = 0;
            counts.for_each_successor(s, [&](const auto& successor) {
                if (successor.cell(sspql::action_id(a)) == nullptr) return;
                ASSERT_LT(i, outcomes.size());
                EXPECT_EQ(outcomes[i].first, successor.state());
                EXPECT_EQ(outcomes[i].second, successor.cell(sspql::action_id(a)));
                ++i;
            });
            EXPECT_EQ(i, outcomes.size());
        }
    }

    template <class Counts, class Successor>
    static void expect_same_pair(const Counts& counts, sspql::StateId s, const Successor& successor, const Pair& pair) {
        EXPECT_NEAR(successor.weight(), pair.weight, 1e-9 * pair.weight);
        expect_same_label(successor.label(), pair.label);
        std::set<std::size_t> seen;
        successor.for_each_action([&](sspql::ActionId a, const auto& cell) {
            EXPECT_TRUE(seen.insert(index(a)).second);
            EXPECT_EQ(static_cast<double>(cell.count()), static_cast<double>(successor.n(a)));
        });
        EXPECT_EQ(seen.size(), pair.actions.size());
        for (std::size_t a = 0; a < counts.actions(); ++a) {
            const sspql::ActionId action = sspql::action_id(a);
            const auto* cell = counts.cell(s, action, successor.state());
            const auto found = pair.actions.find(a);
            ASSERT_EQ(cell != nullptr, found != pair.actions.end());
            const double n = cell == nullptr ? 0.0 : found->second.n;
            EXPECT_EQ(static_cast<double>(successor.n(action)), n);
            EXPECT_EQ(static_cast<double>(counts.n(s, action, successor.state())), n);
            if (cell == nullptr) continue;
            EXPECT_EQ(cell->terminal(), found->second.terminal);
            if constexpr (std::decay_t<decltype(*cell)>::keeps_rewards) {
                EXPECT_NEAR(cell->reward_sum, found->second.reward, 1e-9);
            }
        }
    }

    std::map<std::pair<std::size_t, std::size_t>, Pair> pairs_;
    std::set<std::size_t> dirty_;
    std::uint64_t erasures_ = 0;
};

}  // namespace sspql_test
