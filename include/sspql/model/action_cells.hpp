// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>

#include <sspql/core/assert.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/model/record_slab.hpp>

namespace sspql::detail {

/// The per-action cells of one (s,s'), kept in the payload of its out-record: one cell for each action up to 8 actions,
/// beyond that a block of (action, cell) pairs in an arena of its own, for the actions that occurred.
template <class Cell>
class ActionCells {
public:
    static constexpr std::size_t dense_actions = 8;

    explicit ActionCells(std::size_t actions) : actions_(actions), slab_(sizeof(Pair)) {}

    [[nodiscard]] bool dense() const noexcept { return actions_ <= dense_actions; }
    [[nodiscard]] std::size_t payload_bytes() const noexcept {
        return dense() ? actions_ * sizeof(Cell) : sizeof(Block);
    }
    [[nodiscard]] std::size_t payload_alignment() const noexcept { return dense() ? alignof(Cell) : alignof(Block); }

    void reserve(std::size_t pairs) {
        if (!dense()) slab_.reserve(6 * pairs);
    }

    /// The action's cell, or nullptr if the action never occurred (dense: then the cell is all zero).
    [[nodiscard]] const Cell* find(const std::byte* payload, ActionId a) const noexcept {
        if (dense()) return cells(payload) + index(a);
        const Block block = *reinterpret_cast<const Block*>(payload);
        for (std::uint32_t i = 0; i < block.size; ++i) {
            const Pair* pair = at(block.begin + i);
            if (pair->action == static_cast<std::uint32_t>(a)) return &pair->cell;
        }
        return nullptr;
    }
    [[nodiscard]] Cell* find(std::byte* payload, ActionId a) noexcept {
        return const_cast<Cell*>(static_cast<const ActionCells*>(this)->find(payload, a));
    }

    /// The action's cell, made if need be.
    [[nodiscard]] Cell& touch(std::byte* payload, ActionId a) {
        if (Cell* found = find(payload, a)) return *found;
        Block& block = *reinterpret_cast<Block*>(payload);
        if (block.size == 0) block.size_class = RecordSlab::no_block;
        if (block.size == RecordSlab::capacity(static_cast<std::uint8_t>(block.size_class))) enlarge(block);
        Pair* pair = ::new (slab_.record(block.begin + block.size)) Pair{};
        pair->action = static_cast<std::uint32_t>(a);
        ++block.size;
        return pair->cell;
    }

    /// Calls f(ActionId, const Cell&) for every action that occurred.
    template <class F>
    void for_each(const std::byte* payload, F&& f) const {
        if (dense()) {
            const Cell* cell = cells(payload);
            for (std::size_t a = 0; a < actions_; ++a) {
                if (cell[a].count() > typename Cell::Number{0}) f(action_id(a), cell[a]);
            }
            return;
        }
        const Block block = *reinterpret_cast<const Block*>(payload);
        for (std::uint32_t i = 0; i < block.size; ++i) {
            const Pair* pair = at(block.begin + i);
            if (pair->cell.count() > typename Cell::Number{0}) f(ActionId{pair->action}, pair->cell);
        }
    }

    /// Whether no action is left.
    [[nodiscard]] bool vacant(const std::byte* payload) const noexcept {
        bool empty = true;
        for_each(payload, [&empty](ActionId, const Cell&) { empty = false; });
        return empty;
    }

    /// Gives back what the payload holds, before its record goes.
    void release(std::byte* payload) noexcept {
        if (dense()) return;
        Block& block = *reinterpret_cast<Block*>(payload);
        if (block.size != 0) slab_.release(block.begin, static_cast<std::uint8_t>(block.size_class));
        block = Block{};
    }

    [[nodiscard]] std::size_t bytes() const noexcept { return slab_.bytes(); }

private:
    struct Pair {
        std::uint32_t action = 0;
        Cell cell{};
    };
    struct Block {
        std::uint32_t begin = 0;
        std::uint32_t size = 0;
        std::uint32_t size_class = 0;
    };

    static const Cell* cells(const std::byte* payload) noexcept { return reinterpret_cast<const Cell*>(payload); }

    [[nodiscard]] const Pair* at(std::size_t i) const noexcept {
        return reinterpret_cast<const Pair*>(slab_.record(i));
    }

    void enlarge(Block& block) {
        const auto old = static_cast<std::uint8_t>(block.size_class);
        const auto next = static_cast<std::uint8_t>(old == RecordSlab::no_block ? 0 : old + 1);
        const std::uint32_t to = slab_.allocate(next);
        for (std::uint32_t i = 0; i < block.size; ++i) ::new (slab_.record(to + i)) Pair(*at(block.begin + i));
        if (old != RecordSlab::no_block) slab_.release(block.begin, old);
        block.begin = to;
        block.size_class = next;
    }

    std::size_t actions_;
    RecordSlab slab_;
};

}  // namespace sspql::detail
