// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "grid_task.hpp"

/// \file
/// Counting written by hand for one task, a grid with four actions: what bench_counts holds TransitionCounts against.
///
/// It writes what the library writes: N(s,a,s') with the terminal flag, N(s,a), the predecessor's record with a label,
/// the slot between the two, the dirty bit and list. It knows what a library cannot: that a state has at most four
/// successors and predecessors, so that everything lies in place in one array and nothing ever moves.

namespace sspql::floors {

class Counts {
public:
    explicit Counts(std::size_t states) : nodes_(states) { dirty_.reserve(states); }

    void record(std::uint32_t s, std::uint32_t a, std::uint32_t next, bool terminal) {
        Node& node = nodes_[s];
        std::uint32_t i = 0;
        while (i < node.out_size && node.target[i] != next) ++i;
        if (i == node.out_size) insert(node, s, next);
        std::uint32_t& count = node.count[i][a];
        count = ((count & 0x7FFFFFFFu) + 1u) | (terminal ? 0x80000000u : 0u);
        ++node.total[a];
        if (node.dirty == 0) {
            node.dirty = 1;
            dirty_.push_back(s);
        }
    }

    template <class F>
    void for_each_successor(std::uint32_t s, F&& f) const {
        const Node& node = nodes_[s];
        for (std::uint32_t i = 0; i < node.out_size; ++i) f(node.target[i], node.count[i]);
    }

    template <class F>
    void for_each_predecessor(std::uint32_t s, F&& f) const {
        const Node& node = nodes_[s];
        for (std::uint32_t i = 0; i < node.in_size; ++i) f(node.from[i], node.label[i]);
    }

    void clear_dirty() {
        for (const std::uint32_t s : dirty_) nodes_[s].dirty = 0;
        dirty_.clear();
    }

    [[nodiscard]] std::uint32_t n(std::uint32_t s, std::uint32_t a, std::uint32_t next) const {
        const Node& node = nodes_[s];
        for (std::uint32_t i = 0; i < node.out_size; ++i) {
            if (node.target[i] == next) return node.count[i][a] & 0x7FFFFFFFu;
        }
        return 0;
    }
    [[nodiscard]] std::uint32_t n(std::uint32_t s, std::uint32_t a) const { return nodes_[s].total[a]; }
    [[nodiscard]] std::size_t bytes() const { return nodes_.capacity() * sizeof(Node) + dirty_.capacity() * 4; }

private:
    static constexpr std::size_t most = 4;
    struct Node {
        std::uint8_t out_size = 0;
        std::uint8_t in_size = 0;
        std::uint8_t dirty = 0;
        std::array<std::uint32_t, actions> total{};
        std::array<std::uint32_t, most> target{};
        std::array<std::uint32_t, most> slot{};
        std::array<std::array<std::uint32_t, actions>, most> count{};
        std::array<std::uint32_t, most> from{};
        std::array<double, most> label{};
    };

    void insert(Node& node, std::uint32_t s, std::uint32_t next) {
        Node& other = nodes_[next];
        node.target[node.out_size] = next;
        node.slot[node.out_size++] = other.in_size;
        other.from[other.in_size] = s;
        other.label[other.in_size++] = std::numeric_limits<double>::quiet_NaN();
    }

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> dirty_;
};

}  // namespace sspql::floors
