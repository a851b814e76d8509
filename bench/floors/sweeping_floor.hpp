// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "grid_task.hpp"

namespace sspql::floors {

/// A heap of (s,a) by priority, the largest first, with four children a node and an index that tells where each is.
class PairHeap {
public:
    explicit PairHeap(std::size_t pairs) : place_(pairs, absent) {}

    [[nodiscard]] bool empty() const { return heap_.empty(); }

    void raise(std::uint32_t pair, double priority) {
        std::uint32_t at = place_[pair];
        if (at == absent) {
            at = static_cast<std::uint32_t>(heap_.size());
            heap_.push_back({priority, pair});
        } else if (!(priority > heap_[at].priority)) {
            return;
        }
        while (at > 0) {
            const std::uint32_t parent = (at - 1) / 4;
            if (!(priority > heap_[parent].priority)) break;
            put(at, heap_[parent]);
            at = parent;
        }
        put(at, {priority, pair});
    }

    std::uint32_t pop() {
        const std::uint32_t top = heap_[0].pair;
        const Item item = heap_.back();
        place_[top] = absent;
        heap_.pop_back();
        if (heap_.empty()) return top;
        const auto size = static_cast<std::uint32_t>(heap_.size());
        std::uint32_t at = 0;
        for (std::uint32_t child = 1; child < size; child = 4 * at + 1) {
            std::uint32_t largest = child;
            const std::uint32_t end = std::min(child + 4, size);
            for (std::uint32_t i = child + 1; i < end; ++i) {
                if (heap_[i].priority > heap_[largest].priority) largest = i;
            }
            if (!(heap_[largest].priority > item.priority)) break;
            put(at, heap_[largest]);
            at = largest;
        }
        put(at, item);
        return top;
    }

private:
    struct Item {
        double priority;
        std::uint32_t pair;
    };
    static constexpr std::uint32_t absent = 0xFFFFFFFFu;

    void put(std::uint32_t at, const Item& item) {
        heap_[at] = item;
        place_[item.pair] = at;
    }

    std::vector<Item> heap_;
    std::vector<std::uint32_t> place_;
};

/// Prioritized sweeping: full backups of the most urgent (s,a), which raise the (u,b) that lead there.
class PrioritizedSweeping {
public:
    PrioritizedSweeping(std::size_t states, double gamma, double threshold)
        : q_(states),
          model_(states * actions),
          predecessors_(states),
          queue_(states * actions),
          gamma_(gamma),
          threshold_(threshold) {}

    void observe(const Step& t, std::size_t most_backups) {
        const std::uint32_t pair = t.state * actions + t.action;
        Outcomes& outcomes = model_[pair];
        const std::uint32_t known = outcomes.size;
        const std::uint32_t place = outcomes.add(t);
        if (place == known) predecessors_[t.next].push_back({pair, place});
        const double change = std::fabs(expected(outcomes) - q_[pair]);
        if (change > threshold_) queue_.raise(pair, change);
        for (std::size_t k = 0; k < most_backups && !queue_.empty(); ++k) sweep_one();
    }

    [[nodiscard]] std::uint64_t backups() const { return backups_; }
    [[nodiscard]] const Values& q() const { return q_; }

private:
    struct Predecessor {
        std::uint32_t pair;
        std::uint32_t place;  // among the pair's outcomes
    };

    [[nodiscard]] double expected(const Outcomes& outcomes) const {
        double sum = 0.0;
        for (std::uint32_t i = 0; i < outcomes.size; ++i) {
            const Outcome& outcome = outcomes.seen[i];
            sum += outcome.reward_sum;
            if (!outcome.terminal) sum += outcome.count * gamma_ * q_.max(outcome.next);
        }
        return sum / outcomes.count;
    }

    void sweep_one() {
        const std::uint32_t pair = queue_.pop();
        const std::uint32_t s = pair / actions;
        ++backups_;
        const double before = q_.max(s);
        q_[pair] = expected(model_[pair]);
        const double moved = gamma_ * std::fabs(q_.max(s) - before);
        if (!(moved > threshold_)) return;
        for (const Predecessor& p : predecessors_[s]) {
            const Outcomes& outcomes = model_[p.pair];
            const Outcome& outcome = outcomes.seen[p.place];
            if (outcome.terminal) continue;
            const double priority = moved * outcome.count / outcomes.count;
            if (priority > threshold_) queue_.raise(p.pair, priority);
        }
    }

    Values q_;
    std::vector<Outcomes> model_;
    std::vector<std::vector<Predecessor>> predecessors_;
    PairHeap queue_;
    double gamma_;
    double threshold_;
    std::uint64_t backups_ = 0;
};

}  // namespace sspql::floors
