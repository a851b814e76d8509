// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <sspql/core/ids.hpp>

/// \file
/// Blocks of neighbours, in columns: looking for one reads the ids only, and a row of cells lies together. Views; where
/// a block's bytes are is the business of Adjacency.

namespace sspql::detail {

/// {ids, slots, rows of one cell each}, every column `capacity` long. Ids are complemented: 0 is an unused place.
struct Successors {
    std::uint32_t* targets = nullptr;
    std::uint32_t capacity = 0;

    /// Of each successor.
    static constexpr std::size_t bytes(std::size_t rows, std::size_t cell) noexcept {
        return 2 * sizeof(std::uint32_t) + rows * cell;
    }
    static constexpr std::uint32_t target(StateId s) noexcept { return ~static_cast<std::uint32_t>(s); }
    [[nodiscard]] StateId state(std::size_t at) const noexcept { return StateId{~targets[at]}; }
    void set(std::size_t at, StateId s) const noexcept { targets[at] = target(s); }

    [[nodiscard]] std::uint32_t* slots() const noexcept { return targets + capacity; }
    [[nodiscard]] std::byte* row(std::size_t r, std::size_t cell) const noexcept {
        return reinterpret_cast<std::byte*>(targets + 2 * std::size_t{capacity}) + r * capacity * cell;
    }
    [[nodiscard]] std::byte* cell(std::size_t r, std::size_t at, std::size_t cell) const noexcept {
        return row(r, cell) + at * cell;
    }
};

/// {ids, labels}.
struct Predecessors {
    std::uint32_t* from = nullptr;
    std::uint32_t capacity = 0;

    static constexpr std::size_t bytes = sizeof(std::uint32_t) + sizeof(double);  // of each predecessor
    [[nodiscard]] double* labels() const noexcept { return reinterpret_cast<double*>(from + capacity); }
};

}  // namespace sspql::detail
