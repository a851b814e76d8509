// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/core/random.hpp>
#include <sspql/learn/q_learning.hpp>
#include <sspql/learn/sspql.hpp>

#include "duels/learning.hpp"
#include "duels/task.hpp"
#include "floors/q_learning_floor.hpp"
#include "floors/slippery_grid.hpp"
#include "floors/sspql_floor.hpp"

/// \file
/// The duels of whole steps: Q-learning's and SSPQL's.

namespace sspql::duels {

/// Both are led through the same random walk, whatever they choose; the choices are compared through the values.
template <class Ours, class Floor>
class WalkDuel {
public:
    WalkDuel(const floors::SlipperyGrid& grid, Ours ours, Floor floor)
        : ours_(std::move(ours)), floor_(std::move(floor)), grid_(grid), random_(seed, RandomStream::environment) {}

    void turn() {
        for (auto& [reward, next] : walk_) {
            state_ = grid_.moved(state_, static_cast<std::uint32_t>(random_.below(4)));
            reward = random_.uniform();
            next = state_;
        }
    }
    std::uint64_t ours() {
        for (const auto& [reward, next] : walk_) static_cast<void>(ours_.step(reward, StateId{next}));
        return walk_.size();
    }
    std::uint64_t floor() {
        for (const auto& [reward, next] : walk_) floor_.step(reward, next);
        return walk_.size();
    }
    [[nodiscard]] double disagreement() const { return difference(ours_.q(), floor_.q()); }

protected:
    /// Both begin their walk, in state 0.
    void begin() {
        static_cast<void>(ours_.begin(StateId{state_}));
        floor_.begin(state_);
    }

    /// The parameters of eq. 1 and of the noise, the same for all.
    template <class Params>
    static Params params() {
        Params params;
        params.alpha = alpha;
        params.gamma = discount;
        params.selector = ActionSelector(noise);
        return params;
    }

    Ours ours_;
    Floor floor_;

private:
    floors::SlipperyGrid grid_;
    Random random_;
    std::uint32_t state_ = 0;
    std::vector<std::pair<double, std::uint32_t>> walk_ = std::vector<std::pair<double, std::uint32_t>>(2000);
};

class QLearningDuel : public WalkDuel<QLearning<>, floors::QLearning> {
public:
    explicit QLearningDuel(const floors::SlipperyGrid& grid)
        : WalkDuel(grid, QLearning<>(grid.states(), floors::actions, params<QLearningParams<>>(), seed),
                   floors::QLearning(grid.states(), alpha, discount, noise, seed)) {
        begin();
    }
};

/// The paths to the last cell are as they are after ten tries of every (s,a).
class SspqlDuel : public WalkDuel<Sspql<>, floors::Sspql> {
public:
    explicit SspqlDuel(const floors::SlipperyGrid& grid)
        : WalkDuel(grid, Sspql<>(grid.states(), floors::actions, params<SspqlParams<>>(), seed),
                   floors::Sspql(grid.states(), alpha, discount, noise, 0.1, seed)) {
        ours_.set_goals({{state_id(grid.states() - 1), 0.0}});
        grid.explore(tries, seed, [this](const floors::Step& t) {
            ours_.observe(StateId{t.state}, ActionId{t.action}, t.reward, StateId{t.next}, false);
            floor_.observe({t.state, t.action, t.reward, t.next, false});
        });
        ours_.update_paths();
        for (std::uint32_t s = 0; s < grid.states(); ++s) {
            const ActionId a = ours_.ssp_values().action(StateId{s});
            if (a != no_action) floor_.set_path(s, static_cast<std::uint32_t>(a), ours_.ssp_values()(StateId{s}, a));
        }
        begin();
    }
};

}  // namespace sspql::duels
