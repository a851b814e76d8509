// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/model/block_arena.hpp>
#include <sspql/model/state_bodies.hpp>

namespace sspql::detail {

/// A number for each place of a successor in StateBodies, 1 until it is set: two arrays in step with its memory, which
/// exist only once somebody asked for them. O(1).
template <class Number>
class EdgeWeights {
    using Bodies = StateBodies<Number>;
    using Head = typename Bodies::Head;

public:
    [[nodiscard]] bool empty() const noexcept { return inner_.empty(); }

    /// Room for all that `bodies` has room for.
    void reserve(const Bodies& bodies) {
        inner_.reserve(bodies.most_states() * Bodies::inner_size);
        outer_.reserve(bodies.most_out_units() * per_unit(bodies));
    }

    /// As many as `bodies` has places for.
    void fit(const Bodies& bodies) {
        inner_.resize(bodies.states() * Bodies::inner_size, 1.0);
        outer_.resize(bodies.out_units() * per_unit(bodies), 1.0);
    }

    [[nodiscard]] double& at(const Bodies& bodies, StateId s, std::uint32_t place) noexcept {
        if (place < Bodies::inner_size) return inner_[index(s) * Bodies::inner_size + place];
        return outer_[bodies.head(s)->out_more * per_unit(bodies) + (place - Bodies::inner_size)];
    }
    [[nodiscard]] double at(const Bodies& bodies, StateId s, std::uint32_t place) const noexcept {
        return const_cast<EdgeWeights*>(this)->at(bodies, s, place);
    }

    /// The outer successors of a state, `size` of them, have moved from the block `from` to `to`.
    void move(const Bodies& bodies, std::uint32_t from, std::uint32_t to, std::uint32_t size) {
        fit(bodies);
        for (std::uint32_t i = 0; i < size; ++i) {
            outer_[to * per_unit(bodies) + i] = outer_[from * per_unit(bodies) + i];
        }
    }

    [[nodiscard]] std::size_t bytes() const noexcept {
        return (inner_.capacity() + outer_.capacity()) * sizeof(double);
    }

private:
    /// Enough for what a unit can hold.
    static std::size_t per_unit(const Bodies& bodies) noexcept {
        const std::size_t record = Successors::bytes(bodies.rows(), bodies.cell());
        return (BlockArena::unit + record - 1) / record;
    }

    std::vector<double> inner_;
    std::vector<double> outer_;
};

}  // namespace sspql::detail
