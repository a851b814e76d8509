// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/env/environment.hpp>
#include <sspql/env/grid_map.hpp>
#include <sspql/env/grid_world.hpp>

namespace sspql {

/// Another map from this step of a run on: the first step made on it is number `from_step`, counted from 0.
struct MapChange {
    std::size_t from_step = 0;  ///< steps of the run made before it, in all episodes; > 0
    GridMap map;                ///< the map that holds then
};

/// Environment: a GridWorld whose map changes while it runs, when a given number of steps was made in all episodes
/// together, as in the blocking and the shortcut maze of Sutton and Barto (2018, section 8.3). A change may come within
/// an episode; see GridWorld::set_map. A new run needs a new object (or a copy made before).
///
/// \throws std::invalid_argument for changes that do not come later and later, the first after step 0, or maps of other
/// dimensions.
class ChangingGridWorld {
public:
    /// `world` as it is until the first of `changes`, which are in the order they come.
    ChangingGridWorld(GridWorld world, std::vector<MapChange> changes)
        : world_(std::move(world)), changes_(std::move(changes)) {
        std::size_t previous = 0;
        GridWorld trial = world_;
        for (const MapChange& change : changes_) {
            if (change.from_step <= previous) {
                throw_invalid("from_step of a map change", "exceed " + std::to_string(previous), change.from_step);
            }
            previous = change.from_step;
            trial.set_map(change.map);
        }
    }

    /// Starts an episode in the world as it is now: see GridWorld::reset. \returns the start.
    StateId reset(std::uint64_t seed) {
        change_map();
        return world_.reset(seed);
    }

    /// A step in the map that holds by now. \throws what GridWorld::step throws; such a call is no step.
    Step<StateId> step(Move move) {
        change_map();
        const Step<StateId> result = world_.step(move);
        ++steps_;
        return result;
    }

    /// Steps made so far, in all episodes.
    [[nodiscard]] std::size_t steps() const noexcept { return steps_; }

    /// Number of changes that have taken effect.
    [[nodiscard]] std::size_t changes_made() const noexcept { return made_; }

    /// As given, those that have taken effect included.
    [[nodiscard]] const std::vector<MapChange>& changes() const noexcept { return changes_; }

    /// The world as it is now.
    [[nodiscard]] const GridWorld& world() const noexcept { return world_; }

    /// Number of states: cells, walls included.
    [[nodiscard]] std::size_t size() const noexcept { return world_.size(); }

private:
    void change_map() {
        while (made_ < changes_.size() && steps_ >= changes_[made_].from_step) world_.set_map(changes_[made_++].map);
    }

    GridWorld world_;
    std::vector<MapChange> changes_;
    std::size_t made_ = 0;
    std::size_t steps_ = 0;
};

}  // namespace sspql
