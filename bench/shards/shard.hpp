// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace sspql::shards {

/// One of `count` parts of a run. Its units (seeds; a mission's robots) are index, index + count, index + 2 count, ...:
/// every learner of a seed is in one shard, and shards are equally long but for one seed.
struct Shard {
    static constexpr std::size_t most = 100000;

    std::size_t index = 0;  ///< from 0; people write it from 1
    std::size_t count = 1;

    [[nodiscard]] bool has(std::size_t unit) const noexcept { return unit % count == index; }

    /// How many of a run's `units` are in this shard: 0 if there are more shards than units.
    [[nodiscard]] std::size_t share(std::size_t units) const noexcept {
        return units > index ? (units - index - 1) / count + 1 : 0;
    }

    /// The shard's j-th unit, j from 0.
    [[nodiscard]] std::size_t unit(std::size_t j) const noexcept { return index + j * count; }
};

/// "2/4" for index 1 of 4.
[[nodiscard]] std::string text_of(const Shard& shard);

/// The shard that a text like "2/4" means. \throws std::invalid_argument for everything else: "0/4", "5/4", "x", "1/0".
[[nodiscard]] Shard parse_shard(const std::string& text);

}  // namespace sspql::shards
