// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include <sspql/core/ids.hpp>
#include <sspql/model/block_arena.hpp>
#include <sspql/model/neighbours.hpp>

namespace sspql::detail {

/// Where the bytes of Adjacency lie. Every state has a body: a head, N(s,a) for every a, a block of four successors and
/// one of four predecessors, so that a step reads one place in memory. Further neighbours are in an outer block of an
/// arena. Bodies of states nobody has written to stay untouched. Addresses change with grow() and enlarge...().
template <class Number>
class StateBodies {
public:
    static constexpr std::uint32_t inner_size = 4;  // neighbours within the body

    /// Begins a body.
    struct Head {
        std::uint32_t out_size : 31;
        std::uint32_t dirty : 1;
        std::uint32_t in_size;
        std::uint32_t out_more;  // the outer blocks
        std::uint32_t in_more;
    };

    /// \param rows rows of cells in a block of successors; \param cell bytes of a cell.
    StateBodies(std::size_t actions, std::size_t rows, std::size_t cell)
        : rows_(rows),
          cell_(cell),
          out_offset_(round_up(sizeof(Head) + actions * sizeof(Number))),
          in_offset_(round_up(out_offset_ + inner_size * Successors::bytes(rows, cell))),
          stride_(in_offset_ + inner_size * Predecessors::bytes),
          out_(block_head, Successors::bytes(rows, cell)),
          in_(block_head, Predecessors::bytes) {}

    [[nodiscard]] std::size_t states() const noexcept { return states_; }
    [[nodiscard]] std::size_t rows() const noexcept { return rows_; }
    [[nodiscard]] std::size_t cell() const noexcept { return cell_; }

    void grow(std::size_t states) {
        bodies_.resize(states * stride_);
        states_ = states;
    }

    /// Room for `states` states and `pairs` distinct (s, s') without allocating.
    void reserve(std::size_t states, std::size_t pairs) {
        bodies_.reserve(states * stride_);
        // With blocks that were outgrown and found no other taker, d neighbours of a state take up at most 4 d places
        // up to 32, and 5 d beyond. What is not used stays untouched address space.
        out_.reserve(4 * pairs);
        in_.reserve(5 * pairs);
    }

    [[nodiscard]] Head* head(StateId s) const noexcept {
        return reinterpret_cast<Head*>(bodies_.data() + index(s) * stride_);
    }

    /// N(s,0), N(s,1), ...
    [[nodiscard]] Number* totals(StateId s) const noexcept { return reinterpret_cast<Number*>(head(s) + 1); }

    [[nodiscard]] Successors inner_out(const Head* of_s) const noexcept {
        return {words(of_s, out_offset_), inner_size};
    }
    [[nodiscard]] Successors outer_out(const Head* of_s) const noexcept { return out_block(of_s->out_more); }
    [[nodiscard]] Predecessors inner_in(const Head* of_s) const noexcept {
        return {words(of_s, in_offset_), inner_size};
    }
    [[nodiscard]] Predecessors outer_in(const Head* of_s) const noexcept { return in_block(of_s->in_more); }

    /// Whether there is no room for one more.
    [[nodiscard]] bool out_full(const Head* of_s) const noexcept {
        return of_s->out_size >= inner_size && of_s->out_size - inner_size == outer_out(of_s).capacity;
    }
    [[nodiscard]] bool in_full(const Head* of_s) const noexcept {
        return of_s->in_size >= inner_size && of_s->in_size - inner_size == outer_in(of_s).capacity;
    }

    /// Moves the outer successors into a block of the next class.
    void enlarge_out(Head* of_s) {
        const std::uint32_t begin = larger_block(out_, outer_out(of_s).capacity);
        const Successors from = outer_out(of_s);
        const Successors to = out_block(begin);
        std::memset(to.targets, 0, to.capacity * sizeof(std::uint32_t));
        std::memcpy(to.targets, from.targets, from.capacity * sizeof(std::uint32_t));
        std::memcpy(to.slots(), from.slots(), from.capacity * sizeof(std::uint32_t));
        for (std::size_t r = 0; r < rows_; ++r) {
            std::memcpy(to.row(r, cell_), from.row(r, cell_), from.capacity * cell_);
        }
        if (from.capacity != 0) out_.release(of_s->out_more, from.capacity);
        of_s->out_more = begin;
    }

    /// Moves the outer predecessors likewise.
    void enlarge_in(Head* of_s) {
        const std::uint32_t begin = larger_block(in_, outer_in(of_s).capacity);
        const Predecessors from = outer_in(of_s);
        const Predecessors to = in_block(begin);
        std::memcpy(to.from, from.from, from.capacity * sizeof(std::uint32_t));
        std::memcpy(to.labels(), from.labels(), from.capacity * sizeof(double));
        if (from.capacity != 0) in_.release(of_s->in_more, from.capacity);
        of_s->in_more = begin;
    }

    /// Units of the arena of outer successors in use, and those there is room for.
    [[nodiscard]] std::size_t out_units() const noexcept { return out_.extent(); }
    [[nodiscard]] std::size_t most_out_units() const noexcept { return out_.bytes() / BlockArena::unit; }
    /// States there is room for.
    [[nodiscard]] std::size_t most_states() const noexcept { return bodies_.capacity() / stride_; }

    [[nodiscard]] std::size_t bytes() const noexcept { return bodies_.capacity() + out_.bytes() + in_.bytes(); }

private:
    static_assert(sizeof(Head) == 16 && alignof(Number) <= 8, "everything lies at its alignment");
    static constexpr std::size_t block_head = 8;  // of an outer block: its capacity

    static constexpr std::size_t round_up(std::size_t bytes) noexcept { return (bytes + 7) / 8 * 8; }

    static std::uint32_t* words(const void* bytes, std::size_t offset) noexcept {
        return reinterpret_cast<std::uint32_t*>(const_cast<std::byte*>(static_cast<const std::byte*>(bytes)) + offset);
    }
    [[nodiscard]] Successors out_block(std::uint32_t begin) const noexcept {
        return {words(out_.at(begin), block_head), *words(out_.at(begin), 0)};
    }
    [[nodiscard]] Predecessors in_block(std::uint32_t begin) const noexcept {
        return {words(in_.at(begin), block_head), *words(in_.at(begin), 0)};
    }

    static std::uint32_t larger_block(BlockArena& arena, std::uint32_t old) {
        const std::uint32_t capacity = BlockArena::grown(old);
        const std::uint32_t begin = arena.allocate(capacity);
        *words(arena.at(begin), 0) = capacity;
        return begin;
    }

    std::size_t rows_;
    std::size_t cell_;
    std::size_t out_offset_;
    std::size_t in_offset_;
    std::size_t stride_;
    std::size_t states_ = 0;
    ZeroedBytes bodies_;
    BlockArena out_;
    BlockArena in_;
};

}  // namespace sspql::detail
