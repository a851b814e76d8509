// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <sspql/core/concepts.hpp>

/// \file
/// Queue (concept): a priority queue over the vertices 0 .. n-1 with keys that can decrease, for searches.
///
///     void prepare(std::size_t n, double least_cost, double greatest_cost)   empty, room for vertices 0 .. n-1;
///                                          the bounds on edge costs are hints some queues size their buckets by
///     void push(std::uint32_t vertex, double key)       vertex not queued
///     void decrease(std::uint32_t vertex, double key)   vertex queued, key <= its key
///     std::uint32_t pop()                               a vertex of least key; queue not empty
///     bool empty() const
///
/// Three members are optional:
///
///     static constexpr bool monotone_only    true: keys below the last popped one are not allowed (searches with
///                                            costs >= 0 need none), and popped vertices are not pushed again
///     static constexpr bool corrects_labels  true: pop may return a vertex of not quite the least key; `decrease` of a
///                                            popped vertex queues it again, so that a search still ends exact
///     std::uint32_t upcoming(std::size_t k) const   a vertex that pop may return k pops from now, or no_vertex: a hint
///                                            for fetching memory ahead
///
/// Ours: FibonacciHeap (the bound O(m + n log n) by itself), DaryHeap, BucketQueue (the fastest; costs within a factor
/// of about a thousand), RingQueue (any costs, keeps its inner heap's bound) and AutoQueue, which picks one of the last
/// two. All answer every search with the same distances, bit for bit.

namespace sspql {

namespace detail {

template <class Q>
using QueueExpressions = std::void_t<decltype(std::declval<Q&>().prepare(std::size_t{}, double{}, double{})),
                                     decltype(std::declval<Q&>().push(std::uint32_t{}, double{})),
                                     decltype(std::declval<Q&>().decrease(std::uint32_t{}, double{})),
                                     decltype(std::uint32_t{std::declval<Q&>().pop()}),
                                     decltype(static_cast<bool>(std::declval<const Q&>().empty()))>;

template <class Q>
using MonotoneOnly = std::enable_if_t<Q::monotone_only>;

template <class Q>
using CorrectsLabels = std::enable_if_t<Q::corrects_labels>;

template <class Q>
using Upcoming = decltype(std::uint32_t{std::declval<const Q&>().upcoming(std::size_t{})});

}  // namespace detail

/// Whether Q has the five members of a Queue.
template <class Q>
inline constexpr bool is_queue_v = detail::is_detected_v<detail::QueueExpressions, Q>;

namespace detail {

/// Says once, for all who use it, what a Queue lacks: `static_assert(detail::QueueRequirements<Queue>::met);`
template <class Queue>
struct QueueRequirements {
    static_assert(is_queue_v<Queue>, "sspql: this Queue lacks one of prepare(n, least_cost, greatest_cost), "
                                     "push(vertex, key), decrease(vertex, key), pop() -> vertex, empty()");
    static constexpr bool met = true;
};

}  // namespace detail

/// Whether Q takes no keys below the last popped one.
template <class Q>
inline constexpr bool is_monotone_only_v = detail::is_detected_v<detail::MonotoneOnly, Q>;

/// Whether Q may return vertices out of order, and takes them back.
template <class Q>
inline constexpr bool corrects_labels_v = detail::is_detected_v<detail::CorrectsLabels, Q>;

/// "No vertex", the answer of upcoming(k) where nothing is known.
inline constexpr std::uint32_t no_vertex = 0xFFFFFFFFu;

/// Counters policy of the queues: counts nothing and costs nothing.
struct NoCounters {
    /// A vertex is pushed.
    void count_push() noexcept {}
    /// A vertex is popped.
    void count_pop() noexcept {}
    /// A key is decreased.
    void count_decrease() noexcept {}
    /// Two keys are compared.
    void count_comparison() noexcept {}
    /// Two trees are joined.
    void count_link() noexcept {}
    /// A subtree is cut off.
    void count_cut() noexcept {}
    /// An item is moved.
    void count_move() noexcept {}
    /// A bucket is opened.
    void count_bucket() noexcept {}
    /// A popped vertex is queued again, in place of a decrease of its key.
    void count_rescan() noexcept {}
    /// A root with this many children is popped.
    void count_children(std::uint32_t /*degree*/) noexcept {}
};

/// Counters policy of the queues: exact operation counts since construction, for tests and benchmarks that must not
/// depend on a clock.
struct OperationCounters {
    std::uint64_t pushes = 0;         ///< vertices pushed
    std::uint64_t pops = 0;           ///< vertices popped
    std::uint64_t decreases = 0;      ///< rescans included
    std::uint64_t comparisons = 0;    ///< of keys
    std::uint64_t links = 0;          ///< trees joined
    std::uint64_t cuts = 0;           ///< subtrees cut off, cascades included
    std::uint64_t moves = 0;          ///< items moved within an array or from a bucket to a heap, stale ones included
    std::uint64_t buckets = 0;        ///< buckets opened
    std::uint64_t rescans = 0;        ///< popped vertices that were queued again with a smaller key
    std::uint64_t children = 0;       ///< sum of the degrees of popped roots
    std::uint64_t most_children = 0;  ///< the greatest of them

    /// \name What the queues call
    /// \{

    /// When: see NoCounters.
    void count_push() noexcept { ++pushes; }
    void count_pop() noexcept { ++pops; }
    void count_decrease() noexcept { ++decreases; }
    void count_comparison() noexcept { ++comparisons; }
    void count_link() noexcept { ++links; }
    void count_cut() noexcept { ++cuts; }
    void count_move() noexcept { ++moves; }
    void count_bucket() noexcept { ++buckets; }
    void count_rescan() noexcept { ++rescans; }
    void count_children(std::uint32_t degree) noexcept {
        children += degree;
        if (degree > most_children) most_children = degree;
    }
    /// \}

    /// The figure compared with m + n log2 n: everything but pops (each follows a push) and what others contain.
    [[nodiscard]] std::uint64_t work() const noexcept {
        return pushes + decreases + comparisons + links + cuts + moves + buckets;
    }
};

}  // namespace sspql
