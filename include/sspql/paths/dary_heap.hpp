// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <sspql/core/assert.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/paths/queue.hpp>

namespace sspql {

/// Queue: an implicit heap of arity D with an index from vertex to place. push and decrease O(log_D n), pop
/// O(D log_D n); no allocation after prepare. Keys lie beside their vertices (16 bytes an item), so that a comparison
/// needs no second look-up. `counters()` holds what Counters counted.
template <std::size_t D = 4, class Counters = NoCounters>
class DaryHeap : private Counters {
    static_assert(D >= 2, "sspql: a heap needs an arity of at least 2");

public:
    /// Empty, with room for vertices 0 .. n-1; the bounds on costs do not matter.
    void prepare(std::size_t n, double /*least_cost*/ = 0.0, double /*greatest_cost*/ = 0.0) {
        if (place_.size() < n) place_.resize(n);
        items_.clear();
        items_.reserve(n);
    }

    /// Room to grow up to n vertices, all queued, without allocating; what is queued stays.
    void reserve(std::size_t n) {
        place_.reserve(n);
        items_.reserve(n);
    }

    /// Room for vertices 0 .. n-1; what is queued stays.
    void grow(std::size_t n) {
        if (place_.size() < n) place_.resize(n);
    }

    /// Whether nothing is queued.
    [[nodiscard]] bool empty() const noexcept { return items_.empty(); }
    /// How many vertices are queued.
    [[nodiscard]] std::size_t size() const noexcept { return items_.size(); }

    /// Queues a vertex that is not queued. O(log_D n).
    void push(std::uint32_t vertex, double key) {
        Counters::count_push();
        items_.push_back({key, vertex});
        rise(items_.size() - 1, {key, vertex});
    }

    /// Lowers the key of a queued vertex. O(log_D n).
    void decrease(std::uint32_t vertex, double key) {
        SSPQL_ASSERT(key <= items_[place_[vertex]].key, "keys only decrease");
        Counters::count_decrease();
        rise(place_[vertex], {key, vertex});
    }

    /// Takes out a vertex of least key. O(D log_D n). Precondition (asserted): not empty.
    std::uint32_t pop() {
        SSPQL_ASSERT(!empty(), "pop from an empty queue");
        Counters::count_pop();
        const std::uint32_t vertex = items_.front().vertex;
        const Item last = items_.back();
        items_.pop_back();
        if (!items_.empty()) sink(last);
        return vertex;
    }

    /// Calls f(vertex, key) for all that are queued, in no particular order.
    template <class F>
    void for_each(const F& f) const {
        for (const Item& item : items_) f(item.vertex, item.key);
    }

    /// What was counted.
    [[nodiscard]] const Counters& counters() const noexcept { return *this; }

private:
    friend SerializationAccess;

    struct Item {
        double key;
        std::uint32_t vertex;

        template <class Archive>
        void serialize(Archive& archive) {
            archive(key, vertex);
        }
    };

    /// The order within the heap included: it decides which of equal keys comes first. Reading needs room (grow) for
    /// the vertices.
    template <class Archive>
    void serialize(Archive& archive) {
        archive(items_);
        if constexpr (Archive::loading) {
            std::vector<bool> queued(place_.size(), false);
            for (std::size_t i = 0; i < items_.size(); ++i) {
                const Item& item = items_[i];
                archive.require(item.vertex < queued.size() && !queued[item.vertex] && item.key == item.key &&
                                    !(item.key < items_[i == 0 ? 0 : (i - 1) / D].key),
                                "a queue is out of order");
                queued[item.vertex] = true;
                place_[item.vertex] = static_cast<std::uint32_t>(i);
            }
        }
    }


    void put(std::size_t i, const Item& item) {
        Counters::count_move();
        items_[i] = item;
        place_[item.vertex] = static_cast<std::uint32_t>(i);
    }

    void rise(std::size_t i, Item item) {
        while (i > 0) {
            const std::size_t parent = (i - 1) / D;
            Counters::count_comparison();
            if (!(item.key < items_[parent].key)) break;
            put(i, items_[parent]);
            i = parent;
        }
        put(i, item);
    }

    void sink(Item item) {
        const std::size_t n = items_.size();
        std::size_t i = 0;
        for (;;) {
            const std::size_t first = i * D + 1;
            if (first >= n) break;
            const std::size_t end = first + D < n ? first + D : n;
            std::size_t least = first;
            for (std::size_t child = first + 1; child < end; ++child) {
                Counters::count_comparison();
                if (items_[child].key < items_[least].key) least = child;
            }
            Counters::count_comparison();
            if (!(items_[least].key < item.key)) break;
            put(i, items_[least]);
            i = least;
        }
        put(i, item);
    }

    std::vector<Item> items_;
    std::vector<std::uint32_t> place_;
};

}  // namespace sspql
