// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/paths/dary_heap.hpp>

namespace sspql {

/// The (s,a) whose values are most out of date, in an indexed heap: every (s,a) is queued at most once, with the largest
/// priority it was given. O(log n); memory 12 bytes an (s,a).
class BackupQueue {
public:
    /// A (s,a).
    struct Pair {
        StateId state{};    ///< s
        ActionId action{};  ///< a
    };

    /// Nothing queued.
    BackupQueue(std::size_t states, std::size_t actions) : actions_(actions) { grow(states); }

    /// Room for the (s,a) of that many states; what is queued stays.
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

    /// Whether nothing is queued.
    [[nodiscard]] bool empty() const noexcept { return heap_.empty(); }
    /// How many (s,a) are queued.
    [[nodiscard]] std::size_t size() const noexcept { return heap_.size(); }

    /// The pair of the largest priority. Not empty.
    Pair pop() {
        const std::size_t at = heap_.pop();
        priority_[at] = 0.0;
        return {state_id(at / actions_), action_id(at % actions_)};
    }

    /// Calls f(StateId, ActionId) for all that are queued, in no particular order.
    template <class F>
    void for_each(const F& f) const {
        heap_.for_each([&](std::uint32_t at, double) { f(state_id(at / actions_), action_id(at % actions_)); });
    }

    /// Empties it. O(number of (s,a)), at memory speed.
    void clear() {
        std::fill(priority_.begin(), priority_.end(), 0.0);
        heap_.prepare(0);
    }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive) {
        archive(heap_);
        archive.fixed(priority_);
        if constexpr (Archive::loading) {
            std::size_t queued = 0;
            for (const double priority : priority_) {
                archive.require(priority >= 0.0, "a priority is negative");
                queued += priority > 0.0 ? 1u : 0u;
            }
            heap_.for_each([&](std::uint32_t vertex, double key) {
                archive.require(priority_[vertex] > 0.0 && key == -priority_[vertex], "a priority is wrong");
            });
            archive.require(queued == heap_.size(), "a queue is incomplete");
        }
    }

    std::size_t actions_;
    DaryHeap<4> heap_;
    std::vector<double> priority_;
};

}  // namespace sspql
