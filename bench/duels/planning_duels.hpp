// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/learn/dyna_q.hpp>
#include <sspql/learn/prioritized_sweeping.hpp>
#include <sspql/model/cells.hpp>

#include "duels/learning.hpp"
#include "duels/task.hpp"
#include "floors/dyna_q_floor.hpp"
#include "floors/grid_task.hpp"
#include "floors/slippery_grid.hpp"
#include "floors/sweeping_floor.hpp"

/// \file
/// The duels of planning: Dyna-Q's planning steps and prioritized sweeping's backups.

namespace sspql::duels {

/// Both learn the model from the exploration, without planning; then they plan.
template <class Learner, class Floor>
class PlanningDuel {
public:
    [[nodiscard]] double disagreement() const { return difference(ours_.q(), floor_.q()); }

protected:
    template <class Params>
    PlanningDuel(const floors::SlipperyGrid& grid, Params params, Floor floor, std::size_t planning_steps)
        : ours_(grid.states(), floors::actions, before_planning(params), seed), floor_(std::move(floor)), pool_(grid) {
        grid.explore(tries, seed, [this](const floors::Step& t) { ours_.learn_from(t); });
        grid.explore(tries, seed, [this](const floors::Step& t) { floor_.observe(t, 0); });
        ours_.set_planning_steps(planning_steps);
    }

    Planner<Learner> ours_;
    Floor floor_;
    StepPool pool_;

private:
    template <class Params>
    static Params before_planning(Params params) {
        params.gamma = discount;
        params.planning_steps = 0;
        return params;
    }
};

class DynaQDuel : public PlanningDuel<DynaQ<>, floors::DynaQ> {
public:
    explicit DynaQDuel(const floors::SlipperyGrid& grid)
        : PlanningDuel(grid, params(), floors::DynaQ(grid.states(), alpha, discount, seed), planning_steps) {}

    void turn() { step_ = pool_.draw(); }
    std::uint64_t ours() {
        ours_.learn_from(step_);
        return planning_steps;
    }
    std::uint64_t floor() {
        floor_.observe(step_, planning_steps);
        return planning_steps;
    }

private:
    static constexpr std::size_t planning_steps = 2000;

    static DynaQParams<> params() {
        DynaQParams<> params;
        params.alpha = alpha;
        return params;
    }

    floors::Step step_{};
};

class SweepingDuel : public PlanningDuel<PrioritizedSweeping<>, floors::PrioritizedSweeping> {
public:
    explicit SweepingDuel(const floors::SlipperyGrid& grid)
        : PlanningDuel(grid, params(), floors::PrioritizedSweeping(grid.states(), discount, threshold), most_backups) {}

    /// Rewards that bring the mean reward of (s,a) to a new value in [0, 1): however much was seen, values move.
    void turn() {
        for (floors::Step& t : steps_) {
            t = pool_.draw();
            double sum = 0.0;
            ours_.counts().for_each_successor(StateId{t.state}, [&](const auto& successor) {
                if (const FadingCell* cell = successor.cell(ActionId{t.action})) sum += cell->reward_sum;
            });
            t.reward = t.reward * (ours_.counts().n(StateId{t.state}, ActionId{t.action}) + 1.0) - sum;
        }
    }
    std::uint64_t ours() {
        const std::uint64_t before = ours_.backups();
        for (const floors::Step& t : steps_) ours_.learn_from(t);
        return ours_.backups() - before;
    }
    std::uint64_t floor() {
        const std::uint64_t before = floor_.backups();
        for (const floors::Step& t : steps_) floor_.observe(t, most_backups);
        return floor_.backups() - before;
    }

private:
    static constexpr double threshold = 1e-3;
    static constexpr std::size_t most_backups = 1000;

    static PrioritizedSweepingParams<> params() {
        PrioritizedSweepingParams<> params;
        params.threshold = threshold;
        return params;
    }

    std::vector<floors::Step> steps_ = std::vector<floors::Step>(16);
};

}  // namespace sspql::duels
