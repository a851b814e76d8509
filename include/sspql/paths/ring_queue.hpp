// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <sspql/core/assert.hpp>
#include <sspql/paths/bucket_ring.hpp>
#include <sspql/paths/fibonacci_heap.hpp>
#include <sspql/paths/queue.hpp>

namespace sspql {

/// Queue: buckets on top of another queue (the idea of "heap on top", Cherkassky, Goldberg and Silverstein 1999). The
/// keys of a search lie between the last popped one and `greatest_cost` more; that range is cut into about a thousand
/// buckets, and only the vertices of the first bucket are in the inner queue. It stays small, most decreases happen
/// outside it in O(1), and the bound of the inner queue holds: a vertex moves into it at most once, and a decrease is
/// one entry more. Exact for any costs > 0, whatever the hints and the rounding.
///
/// Keys further ahead than `greatest_cost`, such as the offsets of several goals, wait in a heap.
/// Memory: 2 bytes a vertex, 16 an entry (as in BucketQueue), and the inner queue's.
/// `counters()` holds what Counters counted here, `inner().counters()` what the inner queue counted.
template <class Inner = FibonacciHeap<>, class Counters = NoCounters>
class RingQueue : public detail::QueuedVertices, private Counters {
    static_assert(is_queue_v<Inner>, "sspql: a RingQueue's Inner must be a Queue");

public:
    /// Takes no keys below the last popped one.
    static constexpr bool monotone_only = true;

    /// Empty, with room for vertices 0 .. n-1 and buckets for costs within these bounds.
    void prepare(std::size_t n, double least_cost, double greatest_cost) {
        ring_.prepare(n, size_ != 0, ring_size, greatest_cost / static_cast<double>(ring_size - 2));
        inner_.prepare(n, least_cost, greatest_cost);
        size_ = 0;
    }

    /// Queues a vertex that is not queued. O(1), but for the first bucket, where it is the inner queue's push.
    void push(std::uint32_t vertex, double key) {
        Counters::count_push();
        ++size_;
        put(vertex, key, ring_.place_for(key));
    }

    /// Lowers the key of a queued vertex. O(1), but for the first bucket, where it is the inner queue's decrease.
    void decrease(std::uint32_t vertex, double key) {
        Counters::count_decrease();
        SSPQL_ASSERT(ring_.place_of(vertex) != Ring::nowhere, "a queued vertex");
        if (ring_.place_of(vertex) == Ring::elsewhere) {
            inner_.decrease(vertex, key);
        } else {
            put(vertex, key, ring_.place_for(key));
        }
    }

    /// Takes out a vertex of least key. Amortised as the inner queue's. Precondition (asserted): not empty.
    std::uint32_t pop() {
        SSPQL_ASSERT(!empty(), "pop from an empty queue");
        Counters::count_pop();
        while (inner_.empty()) open_next();
        const std::uint32_t vertex = inner_.pop();
        ring_.forget(vertex);
        --size_;
        return vertex;
    }

    /// What was counted here.
    [[nodiscard]] const Counters& counters() const noexcept { return *this; }
    /// The inner queue, for its counters.
    [[nodiscard]] const Inner& inner() const noexcept { return inner_; }

private:
    struct Entry {
        double key;
        std::uint32_t vertex;
    };
    using Ring = detail::BucketRing<Entry>;

    static constexpr std::size_t ring_size = 1024;

    void put(std::uint32_t vertex, double key, std::uint16_t place) {
        if (place == ring_.current_place()) {
            ring_.set_place(vertex, Ring::elsewhere);
            inner_.push(vertex, key);
        } else {
            ring_.insert(vertex, key, place, {key, vertex});
        }
    }

    /// Moves the next bucket's vertices to the inner queue. Of several entries of a vertex the last has the least key.
    void open_next() {
        ring_.advance([](std::uint32_t vertex, double key) { return Entry{key, vertex}; });
        Counters::count_bucket();
        const std::vector<Entry>& bucket = ring_.current();
        for (std::size_t i = bucket.size(); i-- > 0;) {
            Counters::count_move();
            if (ring_.place_of(bucket[i].vertex) != ring_.current_place()) continue;  // stale
            ring_.set_place(bucket[i].vertex, Ring::elsewhere);
            inner_.push(bucket[i].vertex, bucket[i].key);
        }
    }

    Ring ring_;
    Inner inner_;
};

}  // namespace sspql
