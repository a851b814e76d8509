// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace sspql_test {

/// A queue and a sorted set side by side.
template <class Queue>
class Pair {
public:
    explicit Pair(Queue& queue, std::size_t n, double least_cost = 0.0, double greatest_cost = 0.0)
        : queue_(queue), key_(n, -1.0) {
        queue_.prepare(n, least_cost, greatest_cost);
    }

    [[nodiscard]] bool empty() const { return reference_.empty(); }
    [[nodiscard]] bool queued(std::uint32_t v) const { return reference_.count({key_[v], v}) != 0; }
    [[nodiscard]] double key(std::uint32_t v) const { return key_[v]; }
    [[nodiscard]] double least() const { return reference_.begin()->first; }

    void push(std::uint32_t v, double key) {
        queue_.push(v, key);
        key_[v] = key;
        reference_.insert({key, v});
    }
    void decrease(std::uint32_t v, double key) {
        queue_.decrease(v, key);
        reference_.erase({key_[v], v});
        key_[v] = key;
        reference_.insert({key, v});
    }
    /// `slack`: by how much the key may exceed the least.
    void pop(double slack = 0.0) {
        ASSERT_FALSE(queue_.empty());
        const std::uint32_t v = queue_.pop();
        ASSERT_LT(v, key_.size());
        ASSERT_TRUE(queued(v)) << v << " is not in the queue";
        ASSERT_LE(key_[v] - least(), slack) << "not a least key";
        reference_.erase({key_[v], v});
        ASSERT_EQ(queue_.size(), reference_.size());
        ASSERT_EQ(queue_.empty(), reference_.empty());
    }

private:
    Queue& queue_;
    std::vector<double> key_;
    std::set<std::pair<double, std::uint32_t>> reference_;
};

}  // namespace sspql_test
