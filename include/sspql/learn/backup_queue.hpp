// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/paths/dary_heap.hpp>

namespace sspql {

/// The (s,a) whose values are most out of date, in an indexed heap: every (s,a) is queued at most once, with the largest
/// priority it was given. O(log n); memory 12 bytes an (s,a).
class BackupQueue {
public:
    struct Pair {
        StateId state{};
        ActionId action{};
    };

    BackupQueue(std::size_t states, std::size_t actions) : actions_(actions) { grow(states); }

    void grow(std::size_t states) {
        heap_.grow(states * actions_);
        if (priority_.size() < states * actions_) priority_.resize(states * actions_, 0.0);
    }

    /// Up to this many states nothing is allocated, however many (s,a) are queued.
    void reserve(std::size_t states) {
        heap_.reserve(states * actions_);
        priority_.reserve(states * actions_);
    }

    /// Queues (s,a), or raises it, to a priority > 0.
    void raise(StateId s, ActionId a, double priority) {
        const std::size_t at = index(s) * actions_ + index(a);
        if (!(priority > priority_[at])) return;
        const bool queued = priority_[at] > 0.0;
        priority_[at] = priority;
        if (queued) {
            heap_.decrease(static_cast<std::uint32_t>(at), -priority);
        } else {
            heap_.push(static_cast<std::uint32_t>(at), -priority);
        }
    }

    [[nodiscard]] bool empty() const noexcept { return heap_.empty(); }
    [[nodiscard]] std::size_t size() const noexcept { return heap_.size(); }

    /// The pair of the largest priority. Not empty.
    Pair pop() {
        const std::size_t at = heap_.pop();
        priority_[at] = 0.0;
        return {state_id(at / actions_), action_id(at % actions_)};
    }

    /// O(number of (s,a)), at memory speed.
    void clear() {
        std::fill(priority_.begin(), priority_.end(), 0.0);
        heap_.prepare(0);
    }

private:
    std::size_t actions_;
    DaryHeap<4> heap_;
    std::vector<double> priority_;
};

}  // namespace sspql
