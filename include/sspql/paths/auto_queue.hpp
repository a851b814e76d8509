// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include <sspql/paths/bucket_queue.hpp>
#include <sspql/paths/fibonacci_heap.hpp>
#include <sspql/paths/queue.hpp>
#include <sspql/paths/ring_queue.hpp>

namespace sspql {

/// Queue: the right one for the costs at hand, chosen by prepare: BucketQueue where the greatest cost is at most
/// `most_ratio` times the least, else RingQueue<FibonacciHeap>. The default of searches.
///
/// The paper's costs (eq. 2) with equal weights differ by at most e^{lambda |A|}, so that their searches are linear in
/// the graph and in the greatest distance; all others keep O(m + n log n). `visit` hands out the chosen queue, so that
/// a search need not choose again with every operation.
template <class Counters = NoCounters>
class AutoQueue {
public:
    /// What is chosen for costs of about one size.
    using Buckets = BucketQueue<Counters>;
    /// What is chosen for all others.
    using Ring = RingQueue<FibonacciHeap<Counters>, Counters>;

    /// Takes no keys below the last popped one: both do not.
    static constexpr bool monotone_only = true;
    /// `pop` may return vertices out of order: the buckets do.
    static constexpr bool corrects_labels = true;

    /// The greatest ratio of costs that buckets are chosen for.
    static constexpr double most_ratio = 1024.0;

    /// Chooses by the bounds on edge costs, and empties the chosen queue: room for vertices 0 .. n-1.
    void prepare(std::size_t n, double least_cost, double greatest_cost) {
        uses_buckets_ = greatest_cost <= most_ratio * least_cost;
        visit([&](auto& queue) { queue.prepare(n, least_cost, greatest_cost); });
    }

    /// Whether the last prepare chose the buckets.
    [[nodiscard]] bool uses_buckets() const noexcept { return uses_buckets_; }

    /// f(the chosen queue).
    template <class F>
    decltype(auto) visit(F&& f) {
        return uses_buckets_ ? f(buckets_) : f(ring_);
    }

    /// Whether nothing is queued.
    [[nodiscard]] bool empty() const noexcept { return uses_buckets_ ? buckets_.empty() : ring_.empty(); }
    /// How many vertices are queued.
    [[nodiscard]] std::size_t size() const noexcept { return uses_buckets_ ? buckets_.size() : ring_.size(); }

    /// Queues a vertex that is not queued.
    void push(std::uint32_t vertex, double key) {
        visit([&](auto& queue) { queue.push(vertex, key); });
    }
    /// Lowers the key of a queued vertex; where buckets were chosen, also queues a popped one again.
    void decrease(std::uint32_t vertex, double key) {
        visit([&](auto& queue) { queue.decrease(vertex, key); });
    }
    /// Takes out a vertex of least key, of nearly the least where buckets were chosen. Precondition (asserted): not
    /// empty.
    std::uint32_t pop() {
        return visit([](auto& queue) { return queue.pop(); });
    }
    /// A hint at what pop returns k pops from now; no_vertex where it is not known.
    [[nodiscard]] std::uint32_t upcoming(std::size_t k) const noexcept {
        return uses_buckets_ ? buckets_.upcoming(k) : no_vertex;
    }

    /// The buckets, chosen or not, for their counters.
    [[nodiscard]] const Buckets& buckets() const noexcept { return buckets_; }
    /// The ring, chosen or not, for its counters.
    [[nodiscard]] const Ring& ring() const noexcept { return ring_; }

private:
    Buckets buckets_;
    Ring ring_;
    bool uses_buckets_ = true;
};

}  // namespace sspql
