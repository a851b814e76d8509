// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/core/random.hpp>
#include <sspql/learn/q_table.hpp>

#include "duels/task.hpp"
#include "floors/grid_task.hpp"
#include "floors/match.hpp"
#include "floors/slippery_grid.hpp"

/// \file
/// What the duels of bench_learners share.
///
/// A duel has a library's learner and a floor's: `turn()` prepares work, `ours()` and `floor()` do the same amount of
/// it and return how much that was, `disagreement()` is the largest difference between their values.

namespace sspql::duels {

/// A library's learner that learns the model first and plans afterwards.
template <class Learner>
class Planner : public Learner {
public:
    using Learner::Learner;
    void set_planning_steps(std::size_t steps) { this->params_.planning_steps = steps; }

    void learn_from(const floors::Step& t) {
        Learner::observe(StateId{t.state}, ActionId{t.action}, t.reward, StateId{t.next}, t.terminated);
    }
};

/// Some of the steps of the exploration, spread over the grid, in random order; rewards in [0, 1).
class StepPool {
public:
    explicit StepPool(const floors::SlipperyGrid& grid) : random_(seed, RandomStream::environment) {
        const std::size_t every = std::max<std::size_t>(1, std::size_t{grid.states()} * 4 * tries / most);
        std::size_t i = 0;
        grid.explore(tries, seed, [&](const floors::Step& t) {
            if (i++ % every == 0) steps_.push_back(t);
        });
    }

    floors::Step draw() {
        floors::Step t = steps_[random_.below(steps_.size())];
        t.reward = random_.uniform();
        return t;
    }

private:
    static constexpr std::size_t most = 1 << 16;
    Random random_;
    std::vector<floors::Step> steps_;
};

/// The largest difference between the two tables.
inline double difference(const QTable& ours, const floors::Values& floor) {
    double largest = 0.0;
    for (std::size_t s = 0; s < ours.states(); ++s) {
        for (std::size_t a = 0; a < floors::actions; ++a) {
            largest = std::max(largest, std::fabs(ours(state_id(s), action_id(a)) - floor[s * floors::actions + a]));
        }
    }
    return largest;
}

template <class Duel>
floors::Match match_of(const floors::GridSize& size) {
    const auto duel = std::make_shared<Duel>(size.grid());
    floors::Match match;
    match.prepare = [=] { duel->turn(); };
    match.rivals = {{"library", [=] { return duel->ours(); }}, {"floor", [=] { return duel->floor(); }}};
    match.disagreement = [=] { return duel->disagreement(); };
    return match;
}

}  // namespace sspql::duels
