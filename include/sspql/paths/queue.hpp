// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <sspql/core/concepts.hpp>

/// \file
/// Queue (concept): a priority queue over the vertices 0 .. n-1 with keys that can decrease.
///
///     void prepare(std::size_t n, double least_cost, double greatest_cost)   empty, room for vertices 0 .. n-1;
///                                          the bounds on edge costs are hints some queues size their buckets by
///     void push(std::uint32_t vertex, double key)       vertex not queued
///     void decrease(std::uint32_t vertex, double key)   vertex queued, key <= its key
///     std::uint32_t pop()                               a vertex of least key; queue not empty
///     bool empty() const
///
/// Searches push keys that are no smaller than the last popped one (monotone). Ours: FibonacciHeap, DaryHeap.

namespace sspql {

namespace detail {

template <class Q>
using QueueExpressions = std::void_t<decltype(std::declval<Q&>().prepare(std::size_t{}, double{}, double{})),
                                     decltype(std::declval<Q&>().push(std::uint32_t{}, double{})),
                                     decltype(std::declval<Q&>().decrease(std::uint32_t{}, double{})),
                                     decltype(std::uint32_t{std::declval<Q&>().pop()}),
                                     decltype(static_cast<bool>(std::declval<const Q&>().empty()))>;

}  // namespace detail

/// Whether Q has the five members of a Queue.
template <class Q>
inline constexpr bool is_queue_v = detail::is_detected_v<detail::QueueExpressions, Q>;

/// Counters policy of the queues: counts nothing and costs nothing.
struct NoCounters {
    void count_push() noexcept {}
    void count_pop() noexcept {}
    void count_decrease() noexcept {}
    void count_comparison() noexcept {}
    void count_link() noexcept {}
    void count_cut() noexcept {}
    void count_move() noexcept {}
};

/// Counters policy of the queues: exact operation counts since construction, for tests and benchmarks that must not
/// depend on a clock.
struct OperationCounters {
    std::uint64_t pushes = 0;
    std::uint64_t pops = 0;
    std::uint64_t decreases = 0;
    std::uint64_t comparisons = 0;  ///< of keys
    std::uint64_t links = 0;        ///< trees joined
    std::uint64_t cuts = 0;         ///< subtrees cut off, cascades included
    std::uint64_t moves = 0;        ///< items moved within an array

    void count_push() noexcept { ++pushes; }
    void count_pop() noexcept { ++pops; }
    void count_decrease() noexcept { ++decreases; }
    void count_comparison() noexcept { ++comparisons; }
    void count_link() noexcept { ++links; }
    void count_cut() noexcept { ++cuts; }
    void count_move() noexcept { ++moves; }

    /// Everything but pops, the figure compared with m + n log2 n.
    [[nodiscard]] std::uint64_t work() const noexcept {
        return pushes + decreases + comparisons + links + cuts + moves;
    }
};

}  // namespace sspql
