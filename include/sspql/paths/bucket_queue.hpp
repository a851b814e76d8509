// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <sspql/core/assert.hpp>
#include <sspql/paths/bucket_ring.hpp>
#include <sspql/paths/queue.hpp>

namespace sspql {

/// Queue: buckets of keys just narrower than the least edge cost, and no order within a bucket (Dinitz 1978; Denardo
/// and Fox 1979). No edge leads from a bucket into the same one, so each vertex of the first bucket has its final key,
/// whichever is popped first. push and decrease are O(1), pop is O(1) amortised: a search takes O(m + n), as it opens
/// at most a bucket for each push and decrease (and at most D / width + 1 in all, D = the greatest distance), and a row
/// of bits finds the next one. For costs up to `greatest_cost` of at most a few thousand times `least_cost`: see
/// AutoQueue.
///
/// Exact whatever the hints and the rounding: a popped vertex whose key decreases once more is queued again
/// (corrects_labels). Keys further ahead than `greatest_cost`, such as the offsets of several goals, wait in a heap.
///
/// Memory: 2 bytes a vertex, 4 an entry; buckets hold an entry for each push and decrease and are cleared as the search
/// passes. They keep their capacity, so that a further search allocates only where it outgrows the earlier ones.
/// `counters()` holds what Counters counted.
template <class Counters = NoCounters>
class BucketQueue : public detail::QueuedVertices, private Counters {
public:
    /// Takes no keys below the last popped one.
    static constexpr bool monotone_only = true;
    /// `pop` may return vertices out of order; `decrease` takes popped ones back.
    static constexpr bool corrects_labels = true;

    /// Costs that reach further ahead than this many buckets go through the heap.
    static constexpr std::size_t most_buckets = 4096;

    /// Empty, with room for vertices 0 .. n-1 and buckets for costs within these bounds.
    void prepare(std::size_t n, double least_cost, double greatest_cost) {
        // Narrower than the least cost by more than the rounding of any distance up to 10^9 costs.
        const double width = least_cost * (1.0 - 1e-6);
        double reach = width > 0.0 ? greatest_cost / width : 0.0;
        if (!(reach < static_cast<double>(most_buckets))) reach = static_cast<double>(most_buckets);
        ring_.prepare(n, size_ != 0, static_cast<std::size_t>(reach) + 2, width);
        size_ = 0;
    }

    /// Queues a vertex that is not queued. O(1).
    void push(std::uint32_t vertex, double key) {
        Counters::count_push();
        ++size_;
        ring_.insert(vertex, key, ring_.place_for(key), vertex);
    }

    /// Lowers the key of a queued vertex, or queues a popped one again. O(1).
    void decrease(std::uint32_t vertex, double key) {
        Counters::count_decrease();
        const std::uint16_t place = ring_.place_for(key);
        const std::uint16_t before = ring_.place_of(vertex);
        if (before == place && place != Ring::far) return;
        if (before == Ring::nowhere) {
            Counters::count_rescan();
            ++size_;
        }
        ring_.insert(vertex, key, place, vertex);
    }

    /// Takes out a vertex of the first bucket. O(1) amortised. Precondition (asserted): not empty.
    std::uint32_t pop() {
        SSPQL_ASSERT(!empty(), "pop from an empty queue");
        Counters::count_pop();
        for (;;) {
            std::vector<std::uint32_t>& bucket = ring_.current();
            while (!bucket.empty()) {
                const std::uint32_t vertex = bucket.back();
                bucket.pop_back();
                if (ring_.place_of(vertex) != ring_.current_place()) continue;  // stale: moved on or popped
                ring_.forget(vertex);
                --size_;
                return vertex;
            }
            ring_.advance([](std::uint32_t vertex, double) { return vertex; });
            Counters::count_bucket();
        }
    }

    /// The vertex that pop returns k pops from now if nothing changes in the bucket; no_vertex past its end.
    [[nodiscard]] std::uint32_t upcoming(std::size_t k) const noexcept {
        const std::vector<std::uint32_t>& bucket = ring_.current();
        return k < bucket.size() ? bucket[bucket.size() - 1 - k] : no_vertex;
    }

    /// What was counted.
    [[nodiscard]] const Counters& counters() const noexcept { return *this; }

private:
    using Ring = detail::BucketRing<std::uint32_t>;

    Ring ring_;
};

}  // namespace sspql
