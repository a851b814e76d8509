// SPDX-License-Identifier: MIT
#pragma once

// Those who count transitions: the library, the floor, a hash map and Eigen's sparse matrix. All have record(step),
// n(s, a, next), start_turn() and bytes().

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <Eigen/SparseCore>

#include <sspql/core/ids.hpp>
#include <sspql/model/transition_counts.hpp>

#include "floors/counts_floor.hpp"
#include "floors/grid_task.hpp"

namespace sspql::rivals {

/// The library with some kind of cell, nothing reserved.
template <class Cell = CountCell>
class Unreserved {
public:
    explicit Unreserved(std::size_t states) : counts_(states, floors::actions) {}
    void record(const floors::Step& t) {
        counts_.record(StateId{t.state}, ActionId{t.action}, StateId{t.next}, t.terminated);
    }
    void start_turn() { counts_.clear_dirty(); }
    [[nodiscard]] double n(const floors::Step& t) const {
        return static_cast<double>(counts_.n(StateId{t.state}, ActionId{t.action}, StateId{t.next}));
    }
    [[nodiscard]] const TransitionCounts<Cell>& counts() const { return counts_; }
    [[nodiscard]] std::size_t bytes() const { return counts_.bytes(); }

protected:
    TransitionCounts<Cell> counts_;
};

class Library : public Unreserved<> {
public:
    explicit Library(std::size_t states) : Unreserved(states) { counts_.reserve(states, 4 * states); }
};

class Floor {
public:
    explicit Floor(std::size_t states) : counts_(states) {}
    void record(const floors::Step& t) { counts_.record(t.state, t.action, t.next, t.terminated); }
    void start_turn() { counts_.clear_dirty(); }
    [[nodiscard]] double n(const floors::Step& t) const { return counts_.n(t.state, t.action, t.next); }
    [[nodiscard]] const floors::Counts& counts() const { return counts_; }
    [[nodiscard]] std::size_t bytes() const { return counts_.bytes(); }

private:
    floors::Counts counts_;
};

/// Counts only, no neighbours.
class HashMap {
public:
    explicit HashMap(std::size_t states) : totals_(states * floors::actions, 0) {}
    void record(const floors::Step& t) {
        ++counts_[key(t)];
        ++totals_[t.state * floors::actions + t.action];
    }
    void start_turn() {}
    [[nodiscard]] double n(const floors::Step& t) const {
        const auto found = counts_.find(key(t));
        return found == counts_.end() ? 0.0 : found->second;
    }
    [[nodiscard]] std::size_t bytes() const {
        return counts_.size() * 24 + counts_.bucket_count() * sizeof(void*) +
               totals_.capacity() * sizeof(std::uint32_t);
    }

private:
    static std::uint64_t key(const floors::Step& t) {
        return (std::uint64_t{t.state} * floors::actions + t.action) << 32 | t.next;
    }
    std::unordered_map<std::uint64_t, std::uint32_t> counts_;
    std::vector<std::uint32_t> totals_;
};

/// Counts only; rows are (s,a), with room for every outcome they can have.
class EigenReserved {
public:
    explicit EigenReserved(std::size_t states) : EigenReserved(states, floors::most_outcomes) {}
    void record(const floors::Step& t) {
        ++counts_.coeffRef(static_cast<int>(t.state * floors::actions + t.action), static_cast<int>(t.next));
        ++totals_[t.state * floors::actions + t.action];
    }
    void start_turn() {}
    [[nodiscard]] double n(const floors::Step& t) const {
        return counts_.coeff(static_cast<int>(t.state * floors::actions + t.action), static_cast<int>(t.next));
    }
    [[nodiscard]] const auto& counts() const { return counts_; }
    [[nodiscard]] std::size_t bytes() const {
        return static_cast<std::size_t>(counts_.data().allocatedSize()) * 8 + totals_.capacity() * 12 + 8;
    }

protected:
    EigenReserved(std::size_t states, std::size_t room)
        : counts_(static_cast<int>(states * floors::actions), static_cast<int>(states)),
          totals_(states * floors::actions, 0) {
        if (room != 0) counts_.reserve(Eigen::VectorXi::Constant(counts_.rows(), static_cast<int>(room)));
    }

private:
    Eigen::SparseMatrix<int, Eigen::RowMajor> counts_;
    std::vector<std::uint32_t> totals_;
};

class EigenUnreserved : public EigenReserved {
public:
    explicit EigenUnreserved(std::size_t states) : EigenReserved(states, 0) {}
};

}  // namespace sspql::rivals
