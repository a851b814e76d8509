// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>

#include <sspql/core/ids.hpp>
#include <sspql/model/block_arena.hpp>

namespace sspql::detail {

/// The cells of (s,s') by action where there are too many actions for a cell each: (action, cell) pairs for the actions
/// that occurred, in a block that whoever has (s,s') keeps the handle of. A look-up is linear in their number.
template <class Cell>
class SparseCells {
public:
    /// Where the pairs of one (s,s') are; all zero: none.
    struct Handle {
        std::uint32_t begin = 0;
        std::uint32_t size = 0;
        std::uint32_t capacity = 0;
    };

    SparseCells() : arena_(0, sizeof(Pair)) {}

    void reserve(std::size_t pairs) { arena_.reserve(6 * pairs); }

    /// The action's cell, or nullptr if the action never occurred.
    [[nodiscard]] Cell* find(const Handle& handle, ActionId a) const noexcept {
        Pair* pair = pairs(handle);
        for (std::uint32_t i = 0; i < handle.size; ++i, ++pair) {
            if (pair->action == static_cast<std::uint32_t>(a)) return &pair->cell;
        }
        return nullptr;
    }

    /// The action of the i-th pair.
    [[nodiscard]] ActionId action(const Handle& handle, std::uint32_t i) const noexcept {
        return ActionId{pairs(handle)[i].action};
    }

    /// The action's cell, made if need be.
    [[nodiscard]] Cell& touch(Handle& handle, ActionId a) {
        if (Cell* found = find(handle, a)) return *found;
        if (handle.size == handle.capacity) enlarge(handle);
        Pair* pair = ::new (arena_.at(handle.begin) + handle.size * sizeof(Pair)) Pair{};
        pair->action = static_cast<std::uint32_t>(a);
        ++handle.size;
        return pair->cell;
    }

    /// Calls f(ActionId, const Cell&) for every action that occurred.
    template <class F>
    void for_each(const Handle& handle, F&& f) const {
        const Pair* pair = pairs(handle);
        for (std::uint32_t i = 0; i < handle.size; ++i, ++pair) {
            if (pair->cell.count() > typename Cell::Number{0}) f(ActionId{pair->action}, pair->cell);
        }
    }

    /// Gives the block back; the handle holds none afterwards.
    void release(Handle& handle) noexcept {
        if (handle.capacity != 0) arena_.release(handle.begin, handle.capacity);
        handle = Handle{};
    }

    [[nodiscard]] std::size_t bytes() const noexcept { return arena_.bytes(); }

private:
    struct Pair {
        std::uint32_t action = 0;
        Cell cell{};
    };

    [[nodiscard]] Pair* pairs(const Handle& handle) const noexcept {
        return reinterpret_cast<Pair*>(arena_.at(handle.begin));
    }

    void enlarge(Handle& handle) {
        const std::uint32_t capacity = BlockArena::grown(handle.capacity);
        const std::uint32_t to = arena_.allocate(capacity);
        const Pair* from = pairs(handle);
        for (std::uint32_t i = 0; i < handle.size; ++i) ::new (arena_.at(to) + i * sizeof(Pair)) Pair(from[i]);
        if (handle.capacity != 0) arena_.release(handle.begin, handle.capacity);
        handle.begin = to;
        handle.capacity = capacity;
    }

    BlockArena arena_;
};

}  // namespace sspql::detail
