// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/learn/q_table.hpp>
#include <sspql/learn/q_update.hpp>
#include <sspql/spaces/legal_actions.hpp>

#include "duels/learning.hpp"
#include "duels/task.hpp"
#include "floors/grid_task.hpp"
#include "floors/slippery_grid.hpp"

namespace sspql::duels {

/// An update of eq. 1 for each of many steps.
class QUpdateDuel {
public:
    explicit QUpdateDuel(const floors::SlipperyGrid& grid)
        : ours_(grid.states(), floors::actions), floor_(grid.states()), pool_(grid) {}

    void turn() {
        for (floors::Step& t : steps_) t = pool_.draw();
    }
    std::uint64_t ours() {
        for (const floors::Step& t : steps_) {
            q_update(ours_, {StateId{t.state}, ActionId{t.action}, t.reward, StateId{t.next}, t.terminated, 1.0}, alpha,
                     discount, legal_);
        }
        return steps_.size();
    }
    std::uint64_t floor() {
        for (const floors::Step& t : steps_) {
            double& q = floor_[t.state * floors::actions + t.action];
            q += alpha * (t.reward + (t.terminated ? 0.0 : discount * floor_.max(t.next)) - q);
        }
        return steps_.size();
    }
    [[nodiscard]] double disagreement() const { return difference(ours_, floor_); }

private:
    QTable ours_;
    LegalActionTable legal_;
    floors::Values floor_;
    StepPool pool_;
    std::vector<floors::Step> steps_ = std::vector<floors::Step>(2000);
};

}  // namespace sspql::duels
