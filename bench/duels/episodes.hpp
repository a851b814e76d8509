// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/core/random.hpp>
#include <sspql/learn/dyna_q.hpp>
#include <sspql/learn/sspql.hpp>

#include "duels/learning.hpp"
#include "duels/task.hpp"
#include "floors/grid_task.hpp"
#include "floors/match.hpp"
#include "floors/slippery_grid.hpp"

namespace sspql::duels {

/// SSPQL, and Dyna-Q with several numbers of planning steps, led through the same episodes; the last step of each ends
/// it in the last cell, with reward 1. ns per step.
class Episodes {
public:
    Episodes(const floors::SlipperyGrid& grid, std::size_t length, std::vector<std::size_t> planning_steps)
        : grid_(grid), sspql_(grid.states(), floors::actions, {}, seed), random_(seed, RandomStream::environment) {
        sspql_.reserve(grid.states());
        for (std::size_t i = 0; i < planning_steps.size(); ++i) {
            dyna_.push_back(
                std::make_unique<Planner<DynaQ<>>>(grid.states(), floors::actions, without_planning(), seed));
            dyna_.back()->reserve(grid.states());
            dyna_.back()->set_planning_steps(0);
        }
        grid.explore(tries, seed, [this](const floors::Step& t) {
            sspql_.observe(StateId{t.state}, ActionId{t.action}, t.reward, StateId{t.next}, false);
            for (const auto& dyna : dyna_) dyna->learn_from(t);
        });
        for (std::size_t i = 0; i < planning_steps.size(); ++i) dyna_[i]->set_planning_steps(planning_steps[i]);
        steps_.resize(length);
        turn();
        play(sspql_);  // the first solve takes all states in
    }

    void turn() {
        std::uint32_t s = static_cast<std::uint32_t>(random_.below(grid_.states()));
        start_ = s;
        for (std::uint32_t& next : steps_) {
            s = grid_.moved(s, static_cast<std::uint32_t>(random_.below(4)));
            next = s;
        }
        steps_.back() = grid_.states() - 1;
    }
    std::uint64_t play_sspql() { return play(sspql_); }
    std::uint64_t play_dyna(std::size_t i) { return play(*dyna_[i]); }

private:
    static DynaQParams<> without_planning() {
        DynaQParams<> params;
        params.planning_steps = 0;
        return params;
    }

    /// What the learner chooses is replaced, so that all learn from the same.
    template <class L>
    std::uint64_t play(L& learner) {
        static_cast<void>(learner.begin(StateId{start_}));
        for (std::size_t i = 0; i + 1 < steps_.size(); ++i) static_cast<void>(learner.step(0.0, StateId{steps_[i]}));
        learner.end(1.0, StateId{steps_.back()}, true);
        return steps_.size();
    }

    floors::SlipperyGrid grid_;
    Sspql<> sspql_;
    std::vector<std::unique_ptr<Planner<DynaQ<>>>> dyna_;
    Random random_;
    std::uint32_t start_ = 0;
    std::vector<std::uint32_t> steps_;
};

inline floors::Match episodes(const floors::GridSize& size, std::size_t length) {
    const floors::SlipperyGrid grid = size.grid();
    std::vector<std::size_t> planning_steps{0, 5, 20, 50};
    const std::size_t fifth = std::size_t{grid.states()} * floors::actions / 5;
    if (fifth * length <= 1000000) planning_steps.push_back(fifth);
    const auto played = std::make_shared<Episodes>(grid, length, planning_steps);
    floors::Match match;
    match.prepare = [=] { played->turn(); };
    match.rivals.push_back({"sspql", [=] { return played->play_sspql(); }});
    for (std::size_t i = 0; i < planning_steps.size(); ++i) {
        match.rivals.push_back({"dyna-q k=" + std::to_string(planning_steps[i]), [=] { return played->play_dyna(i); }});
    }
    return match;
}

}  // namespace sspql::duels
