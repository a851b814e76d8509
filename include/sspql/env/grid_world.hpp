// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/random.hpp>
#include <sspql/env/environment.hpp>
#include <sspql/env/grid_map.hpp>
#include <sspql/model/transition_table.hpp>
#include <sspql/model/transition_table_builder.hpp>

namespace sspql {

/// The four commands of a grid world; EnumActions<Move>(4) decodes them.
enum class Move : std::uint8_t { up, down, left, right };

/// Where a slip leads: in one of the three other directions, in one of the two perpendicular ones, or nowhere.
enum class SlipKind : std::uint8_t { other, perpendicular, lost };

/// Rewards of a grid world. A step has one of them: `goal` if it reaches a goal, `hazard` if a hazard, else `step`.
struct GridRewards {
    double goal = 1.0;        ///< of reaching a goal
    double step = 0.0;        ///< of any other step
    double hazard = 0.0;      ///< of getting into a hazard
    bool hazard_ends = true;  ///< false: a hazard takes the agent back to the start instead of ending the episode
};

/// Settings of a GridWorld.
struct GridWorldParams {
    double slip = 0.0;                     ///< chance that a step slips, in [0, 1]
    SlipKind slip_kind = SlipKind::other;  ///< where a slip leads
    GridRewards rewards{};                 ///< what steps bring

    /// Checks every number. \throws std::invalid_argument naming the first number out of range.
    void validate() const {
        require_in("slip", slip, 0.0, 1.0);
        require_finite("goal reward", rewards.goal);
        require_finite("step reward", rewards.step);
        require_finite("hazard reward", rewards.hazard);
    }
};

namespace detail {

/// Number of directions in which a slip may lead (`lost` counts as one), all alike.
inline std::size_t slip_ways(SlipKind kind) noexcept {
    return kind == SlipKind::other ? 3 : kind == SlipKind::perpendicular ? 2 : 1;
}

/// The k-th direction in which `move` may slip; not for `lost`.
inline Move slipped(SlipKind kind, Move move, std::size_t k) noexcept {
    const auto m = static_cast<std::size_t>(move);
    if (kind == SlipKind::perpendicular) return static_cast<Move>(m < 2 ? 2 + k : k);
    return static_cast<Move>(k < m ? k : k + 1);
}

/// The cell one step further; s itself at a wall or the edge.
inline StateId neighbour(const GridMap& map, StateId s, Move move) noexcept {
    std::size_t to = index(s);
    switch (move) {
        case Move::up:
            if (map.row(s) == 0) return s;
            to -= map.columns();
            break;
        case Move::down:
            if (map.row(s) + 1 == map.rows()) return s;
            to += map.columns();
            break;
        case Move::left:
            if (map.column(s) == 0) return s;
            --to;
            break;
        case Move::right:
            if (map.column(s) + 1 == map.columns()) return s;
            ++to;
            break;
    }
    return map.cell(state_id(to)) == GridCell::wall ? s : state_id(to);
}

/// What comes of going from `from` to `cell`; staying enters nothing.
inline Step<StateId> arrival(const GridMap& map, const GridRewards& rewards, StateId from, StateId cell) noexcept {
    if (cell == from) return {from, rewards.step, false, false};
    switch (map.cell(cell)) {
        case GridCell::goal: return {cell, rewards.goal, true, false};
        case GridCell::hazard:
            if (!rewards.hazard_ends) return {map.starts().front(), rewards.hazard, false, false};
            return {cell, rewards.hazard, true, false};
        default: return {cell, rewards.step, false, false};
    }
}

/// Checks what map and rewards must agree on.
inline void require_one_start(const GridMap& map, const GridRewards& rewards) {
    if (!rewards.hazard_ends && map.starts().size() != 1) {
        throw_invalid("number of start cells", "be 1 where hazards lead back to the start", map.starts().size());
    }
}

}  // namespace detail

/// Environment: an agent on a GridMap. Observation: its cell's state (EnumState<StateId>(world.size())). Command: Move.
///
/// With chance `slip` a step goes elsewhere (SlipKind), else where it was sent; against a wall or the edge the agent
/// stays. A goal ends the episode; so does a hazard, unless it leads back to the start. Episodes start in one of the
/// map's start cells, all alike.
///
/// Chance: reset(seed) draws the start from RandomStream::environment, each step takes exactly one number from
/// RandomStream::noise, whatever happens. Both O(1), without allocation.
/// \throws std::invalid_argument for parameters out of range, or hazards that lead back to one of several starts.
class GridWorld {
public:
    /// The number of actions.
    static constexpr std::size_t actions = 4;

    /// The agent is nowhere until reset().
    explicit GridWorld(GridMap map, GridWorldParams params = {})
        : map_(std::move(map)), params_(params), noise_(0, RandomStream::noise) {
        params_.validate();
        detail::require_one_start(map_, params_.rewards);
    }

    /// Starts an episode; all of its chance comes from the seed. \returns the start.
    StateId reset(std::uint64_t seed) {
        Random start(seed, RandomStream::environment);
        noise_ = Random(seed, RandomStream::noise);
        state_ = map_.starts()[start.below(map_.starts().size())];
        running_ = true;
        return state_;
    }

    /// Moves, or slips.
    /// \throws std::logic_error before reset() and after the end of an episode; std::invalid_argument for no move.
    Step<StateId> step(Move move) {
        if (!running_) throw std::logic_error("step() outside an episode: reset() first");
        if (static_cast<std::size_t>(move) >= actions) throw_invalid("move", "be below 4", static_cast<int>(move));
        const double u = noise_.uniform();
        StateId to = state_;
        if (u >= params_.slip) {
            to = detail::neighbour(map_, state_, move);
        } else if (params_.slip_kind != SlipKind::lost) {
            const std::size_t ways = detail::slip_ways(params_.slip_kind);
            const auto way = static_cast<std::size_t>(u / params_.slip * static_cast<double>(ways));
            to = detail::neighbour(map_, state_, detail::slipped(params_.slip_kind, move, std::min(way, ways - 1)));
        }
        const Step<StateId> result = detail::arrival(map_, params_.rewards, state_, to);
        state_ = result.observation;
        running_ = !result.terminated;
        return result;
    }

    /// Another map from the next step on, also within an episode: the agent stays where it is. If a wall was built
    /// there, it can leave but not return; a goal or hazard counts only once it is entered.
    /// \throws std::invalid_argument for a map of other dimensions, or without its one start where hazards lead there.
    void set_map(GridMap map) {
        if (map.rows() != map_.rows() || map.columns() != map_.columns()) {
            throw_invalid("new map", "have " + dimensions(map_), dimensions(map));
        }
        detail::require_one_start(map, params_.rewards);
        map_ = std::move(map);
    }

    /// This world as a table: every free and every start cell has the four moves, the others no actions. O(size).
    [[nodiscard]] TransitionTable table() const {
        TransitionTableBuilder builder(map_.size(), actions);
        for (std::size_t s = 0; s < map_.size(); ++s) {
            const GridCell cell = map_.cell(state_id(s));
            if (cell != GridCell::free && cell != GridCell::start) continue;
            for (std::size_t m = 0; m < actions; ++m) add_move(builder, state_id(s), static_cast<Move>(m));
        }
        builder.start_in(map_.starts());
        return builder.build();
    }

    /// Number of states: cells, walls included.
    [[nodiscard]] std::size_t size() const noexcept { return map_.size(); }

    /// The map as it is now.
    [[nodiscard]] const GridMap& map() const noexcept { return map_; }
    /// Slip and rewards, as given.
    [[nodiscard]] const GridWorldParams& params() const noexcept { return params_; }

    /// Where the agent is; no_state before the first reset().
    [[nodiscard]] StateId state() const noexcept { return state_; }

    /// "row 2, column 0 (start)". \throws std::invalid_argument for a state outside.
    [[nodiscard]] std::string describe(StateId s) const { return map_.describe(s); }

private:
    static std::string dimensions(const GridMap& map) {
        return std::to_string(map.rows()) + " rows of " + std::to_string(map.columns());
    }

    void add_move(TransitionTableBuilder& builder, StateId s, Move move) const {
        const auto add = [&](StateId to, double probability) {
            if (!(probability > 0.0)) return;
            const Step<StateId> end = detail::arrival(map_, params_.rewards, s, to);
            builder.add(s, action_id(static_cast<std::size_t>(move)), end.observation, probability, end.reward,
                        end.terminated);
        };
        add(detail::neighbour(map_, s, move), 1.0 - params_.slip);
        const std::size_t ways = detail::slip_ways(params_.slip_kind);
        for (std::size_t k = 0; k < ways; ++k) {
            const bool lost = params_.slip_kind == SlipKind::lost;
            add(lost ? s : detail::neighbour(map_, s, detail::slipped(params_.slip_kind, move, k)),
                params_.slip / static_cast<double>(ways));
        }
    }

    GridMap map_;
    GridWorldParams params_;
    Random noise_;
    StateId state_ = no_state;
    bool running_ = false;
};

}  // namespace sspql
