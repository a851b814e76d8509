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
    using Buckets = BucketQueue<Counters>;
    using Ring = RingQueue<FibonacciHeap<Counters>, Counters>;

    static constexpr bool monotone_only = true;
    static constexpr bool corrects_labels = true;

    static constexpr double most_ratio = 1024.0;

    void prepare(std::size_t n, double least_cost, double greatest_cost) {
        uses_buckets_ = greatest_cost <= most_ratio * least_cost;
        visit([&](auto& queue) { queue.prepare(n, least_cost, greatest_cost); });
    }

    [[nodiscard]] bool uses_buckets() const noexcept { return uses_buckets_; }

    /// f(the chosen queue).
    template <class F>
    decltype(auto) visit(F&& f) {
        return uses_buckets_ ? f(buckets_) : f(ring_);
    }

    [[nodiscard]] bool empty() const noexcept { return uses_buckets_ ? buckets_.empty() : ring_.empty(); }
    [[nodiscard]] std::size_t size() const noexcept { return uses_buckets_ ? buckets_.size() : ring_.size(); }

    void push(std::uint32_t vertex, double key) {
        visit([&](auto& queue) { queue.push(vertex, key); });
    }
    void decrease(std::uint32_t vertex, double key) {
        visit([&](auto& queue) { queue.decrease(vertex, key); });
    }
    std::uint32_t pop() {
        return visit([](auto& queue) { return queue.pop(); });
    }
    [[nodiscard]] std::uint32_t upcoming(std::size_t k) const noexcept {
        return uses_buckets_ ? buckets_.upcoming(k) : no_vertex;
    }

    [[nodiscard]] const Buckets& buckets() const noexcept { return buckets_; }
    [[nodiscard]] const Ring& ring() const noexcept { return ring_; }

private:
    Buckets buckets_;
    Ring ring_;
    bool uses_buckets_ = true;
};

}  // namespace sspql
