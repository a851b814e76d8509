// SPDX-License-Identifier: MIT
#pragma once

// What no search can beat by much: touching each edge once, in the order of a search and in the order of memory.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/paths/reverse_graph.hpp>

#include "rivals/contender.hpp"

namespace sspql::rivals {

/// Breadth-first search from the goal: steps instead of costs, so no queue but an array.
class BreadthFirst : public Contender {
public:
    BreadthFirst(const ReverseGraph& graph, StateId goal) : Contender("BFS"), graph_(graph), goal_(goal) {
        queue_.reserve(graph.size());
    }

    void run() override {
        level_.assign(graph_.size(), unseen);
        queue_.clear();
        level_[index(goal_)] = 0;
        queue_.push_back(goal_);
        for (std::size_t i = 0; i < queue_.size(); ++i) {
            const StateId v = queue_[i];
            const std::uint32_t next = level_[index(v)] + 1;
            graph_.for_each_predecessor(v, [&](StateId u, double) {
                if (level_[index(u)] != unseen) return;
                level_[index(u)] = next;
                queue_.push_back(u);
            });
        }
    }

    [[nodiscard]] double distance(std::size_t state) const override { return level_[state]; }
    [[nodiscard]] bool finds_distances() const override { return false; }

private:
    static constexpr std::uint32_t unseen = 0xFFFFFFFFu;

    const ReverseGraph& graph_;
    StateId goal_;
    std::vector<std::uint32_t> level_;
    std::vector<StateId> queue_;
};

/// One pass over all edges in memory's order.
class OnePass : public Contender {
public:
    explicit OnePass(const ReverseGraph& graph) : Contender("one pass"), graph_(graph) {}

    void run() override {
        double sum = 0.0;
        for (std::size_t v = 0; v < graph_.size(); ++v) {
            graph_.for_each_predecessor(state_id(v),
                                        [&](StateId u, double cost) { sum += cost * static_cast<double>(index(u)); });
        }
        sum_ = sum;
    }

    [[nodiscard]] double distance(std::size_t) const override { return sum_; }
    [[nodiscard]] bool finds_distances() const override { return false; }

private:
    const ReverseGraph& graph_;
    double sum_ = 0.0;
};

}  // namespace sspql::rivals
