// SPDX-License-Identifier: MIT
// Every queue against a sorted set, for generated sequences of operations.
#ifdef SSPQL_HAS_RAPIDCHECK
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include <sspql/paths/dary_heap.hpp>
#include <sspql/paths/fibonacci_heap.hpp>

namespace {

constexpr std::uint32_t vertices = 32;

/// {pops if 0, vertex, key or how much the key drops}: few different keys, so that there are ties.
using Operation = std::tuple<int, std::uint32_t, int>;

template <class Queue>
void compare() {
    const auto operations =
        *rc::gen::scale(5.0, rc::gen::container<std::vector<Operation>>(rc::gen::tuple(
                                 rc::gen::inRange(0, 3), rc::gen::inRange(0u, vertices), rc::gen::inRange(0, 10))));
    Queue queue;
    queue.prepare(vertices, 0.0, 0.0);
    std::set<std::pair<double, std::uint32_t>> reference;
    std::vector<double> key(vertices, 0.0);
    const auto pop = [&] {
        const std::uint32_t v = queue.pop();
        RC_ASSERT(v < vertices);
        RC_ASSERT(reference.erase({key[v], v}) == 1u);
        RC_ASSERT(reference.empty() || key[v] <= reference.begin()->first);
        RC_ASSERT(queue.size() == reference.size());
    };
    for (const auto& [what, v, amount] : operations) {
        RC_ASSERT(queue.empty() == reference.empty());
        if (what == 0) {
            if (!reference.empty()) pop();
        } else if (reference.erase({key[v], v}) == 1u) {
            key[v] -= amount;
            queue.decrease(v, key[v]);
            reference.insert({key[v], v});
        } else {
            key[v] = amount;
            queue.push(v, key[v]);
            reference.insert({key[v], v});
        }
    }
    while (!reference.empty()) pop();
    RC_ASSERT(queue.empty());
}

}  // namespace

RC_GTEST_PROP(QueueProperty, FibonacciHeapEqualsTheReference, ()) { compare<sspql::FibonacciHeap<>>(); }

RC_GTEST_PROP(QueueProperty, BinaryHeapEqualsTheReference, ()) { compare<sspql::DaryHeap<2>>(); }

RC_GTEST_PROP(QueueProperty, QuaternaryHeapEqualsTheReference, ()) { compare<sspql::DaryHeap<4>>(); }

RC_GTEST_PROP(QueueProperty, OctalHeapEqualsTheReference, ()) { compare<sspql::DaryHeap<8>>(); }
#endif
