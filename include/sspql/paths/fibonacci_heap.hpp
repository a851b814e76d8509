// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <sspql/core/assert.hpp>
#include <sspql/paths/queue.hpp>

namespace sspql {

/// Queue: a Fibonacci heap (Fredman and Tarjan 1987): push and decrease O(1) amortised, pop O(log n) amortised, so that
/// Dijkstra's search takes O(m + n log n) heap operations (the bound of the paper's section 2.5).
///
/// Nodes (32 bytes) live in a pool and are linked by index; a free slot is reused last in, first out, so that the nodes
/// of the search front stay packed; a vertex finds its slot through one index. Roots are a plain array. No allocation
/// after prepare. `counters()` holds what Counters counted.
template <class Counters = NoCounters>
class FibonacciHeap : private Counters {
public:
    /// Empty, with room for vertices 0 .. n-1; the bounds on costs do not matter.
    void prepare(std::size_t n, double /*least_cost*/ = 0.0, double /*greatest_cost*/ = 0.0) {
        if (slot_of_.size() < n) {
            slot_of_.resize(n);
            nodes_.reserve(n);
            roots_.reserve(n);
        }
        nodes_.clear();
        roots_.clear();
        free_ = none;
        size_ = 0;
        least_ = none;
    }

    /// Whether nothing is queued.
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
    /// How many vertices are queued.
    [[nodiscard]] std::size_t size() const noexcept { return size_; }

    /// Queues a vertex that is not queued. O(1).
    void push(std::uint32_t vertex, double key) {
        Counters::count_push();
        const std::uint32_t slot = take_slot();
        nodes_[slot] = Node{key, vertex, none, none, none, none, 0};
        slot_of_[vertex] = slot;
        add_root(slot);
        ++size_;
    }

    /// Lowers the key of a queued vertex. O(1) amortised.
    void decrease(std::uint32_t vertex, double key) {
        Counters::count_decrease();
        const std::uint32_t slot = slot_of_[vertex];
        SSPQL_ASSERT(key <= nodes_[slot].key, "keys only decrease");
        nodes_[slot].key = key;
        const std::uint32_t parent = nodes_[slot].parent;
        if (parent == none) {
            prefer(slot);
            return;
        }
        Counters::count_comparison();
        if (!(key < nodes_[parent].key)) return;
        cut(slot, parent);
        cascade(parent);
    }

    /// Takes out a vertex of least key. O(log n) amortised. Precondition (asserted): not empty.
    std::uint32_t pop() {
        SSPQL_ASSERT(!empty(), "pop from an empty queue");
        Counters::count_pop();
        const std::uint32_t top = least_;
        const std::uint32_t vertex = nodes_[top].vertex;
        Counters::count_children(nodes_[top].degree);
        consolidate(top);
        nodes_[top].right = free_;
        free_ = top;
        --size_;
        return vertex;
    }

    /// The largest degree a node of a heap of n can have: floor(log_phi n) + 1 fits for every n < 2^32.
    static constexpr std::size_t degree_bound = 48;

    /// What was counted.
    [[nodiscard]] const Counters& counters() const noexcept { return *this; }

private:
    static constexpr std::uint32_t none = 0xFFFFFFFFu;
    static constexpr std::uint32_t marked = 0x80000000u;

    struct Node {
        double key;
        std::uint32_t vertex;
        std::uint32_t parent;
        std::uint32_t child;  // any child; children form a list by left and right, ends are none
        std::uint32_t left;
        std::uint32_t right;
        std::uint32_t degree;  // top bit: lost a child since it became one itself
    };

    std::uint32_t take_slot() {
        if (free_ != none) {
            const std::uint32_t slot = free_;
            free_ = nodes_[slot].right;
            return slot;
        }
        nodes_.push_back({});
        return static_cast<std::uint32_t>(nodes_.size() - 1);
    }

    void add_root(std::uint32_t slot) {
        roots_.push_back(slot);
        prefer(slot);
    }

    void prefer(std::uint32_t slot) {
        if (least_ != none) {
            Counters::count_comparison();
            if (!(nodes_[slot].key < nodes_[least_].key)) return;
        }
        least_ = slot;
    }

    void cut(std::uint32_t slot, std::uint32_t parent) {
        Counters::count_cut();
        Node& node = nodes_[slot];
        if (node.left != none) {
            nodes_[node.left].right = node.right;
        } else {
            nodes_[parent].child = node.right;
        }
        if (node.right != none) nodes_[node.right].left = node.left;
        --nodes_[parent].degree;
        node.parent = none;
        node.left = none;
        node.right = none;
        node.degree &= ~marked;
        add_root(slot);
    }

    void cascade(std::uint32_t slot) {
        for (;;) {
            const std::uint32_t parent = nodes_[slot].parent;
            if (parent == none) return;
            if ((nodes_[slot].degree & marked) == 0) {
                nodes_[slot].degree |= marked;
                return;
            }
            cut(slot, parent);
            slot = parent;
        }
    }

    /// Removes the root `top`, makes its children roots, and joins trees until all degrees differ.
    void consolidate(std::uint32_t top) {
        std::array<std::uint32_t, degree_bound> by_degree;
        by_degree.fill(none);
        std::uint32_t highest = 0;
        const auto insert = [&](std::uint32_t slot) {
            std::uint32_t degree = nodes_[slot].degree;
            while (by_degree[degree] != none) {
                std::uint32_t other = by_degree[degree];
                by_degree[degree] = none;
                Counters::count_comparison();
                if (nodes_[other].key < nodes_[slot].key) {
                    const std::uint32_t swap = slot;
                    slot = other;
                    other = swap;
                }
                link(other, slot);
                ++degree;
            }
            by_degree[degree] = slot;
            if (degree > highest) highest = degree;
        };
        for (const std::uint32_t slot : roots_) {
            if (slot != top) insert(slot);
        }
        for (std::uint32_t child = nodes_[top].child; child != none;) {
            const std::uint32_t next = nodes_[child].right;
            nodes_[child].parent = none;
            nodes_[child].left = none;
            nodes_[child].right = none;
            nodes_[child].degree &= ~marked;
            insert(child);
            child = next;
        }
        roots_.clear();
        least_ = none;
        for (std::uint32_t degree = 0; degree <= highest; ++degree) {
            if (by_degree[degree] != none) add_root(by_degree[degree]);
        }
    }

    void link(std::uint32_t child, std::uint32_t parent) {
        Counters::count_link();
        Node& c = nodes_[child];
        Node& p = nodes_[parent];
        c.parent = parent;
        c.left = none;
        c.right = p.child;
        if (p.child != none) nodes_[p.child].left = child;
        p.child = child;
        ++p.degree;
    }

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> slot_of_;
    std::vector<std::uint32_t> roots_;
    std::uint32_t free_ = none;
    std::uint32_t least_ = none;
    std::size_t size_ = 0;
};

}  // namespace sspql
