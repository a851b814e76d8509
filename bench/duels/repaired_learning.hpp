// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/core/random.hpp>
#include <sspql/model/transition_counts.hpp>
#include <sspql/paths/auto_queue.hpp>
#include <sspql/paths/path_solver.hpp>

#include "floors/clock.hpp"
#include "floors/grid_task.hpp"
#include "floors/slippery_grid.hpp"

namespace sspql::duels {

using RepairCounts = TransitionCounts<CountCell>;
using RepairSolver = PathSolver<RiskWeighted, SumOverActions, AutoQueue<>>;

inline void require_equal(const ShortestPathTree& a, const ShortestPathTree& b) {
    if (a.distance == b.distance && a.next == b.next) return;
    std::fprintf(stderr, "repaired and searched trees differ\n");
    std::abort();
}

/// One way of solving, with counts of its own.
struct RepairWay {
    const char* name;
    bool scratch;
    RepairCounts counts;
    RepairSolver solver;
    std::vector<double> seconds{};
    std::vector<double> ratio{};
    double total = 0.0;
    std::size_t repaired = 0;

    RepairWay(const char* name_, double tolerance, bool scratch_, const RepairCounts& counts_)
        : name(name_), scratch(scratch_), counts(counts_), solver(RiskWeighted{}, {}, tolerance) {}

    double solve(const std::vector<Goal>& goals) {
        if (scratch) solver.forget();
        return floors::timed([&] { repaired += solver.solve(counts, goals) == Solved::searched ? 0 : 1; });
    }
};

class RepairedLearning {
public:
    explicit RepairedLearning(std::uint32_t side)
        : grid_(side, side),
          goals_{{state_id(side / 2 * side + side / 2), 0.0}},
          random_(1, RandomStream::environment),
          counts_(grid_.states(), floors::actions) {
        RepairSolver solver;
        for (int episode = 0; episode < 1000; ++episode) {
            walk(solver.tree());
            for (const floors::Step& t : steps_) record(counts_, t);
            solver.solve(counts_, goals_);
        }
        const std::pair<const char*, double> tolerances[] = {{"repair, exact", 0.0}, {"1 %", 0.01}, {"5 %", 0.05}};
        ways_.reserve(4);
        ways_.emplace_back("from scratch", 0.0, true, counts_);
        for (const auto& [name, tolerance] : tolerances) ways_.emplace_back(name, tolerance, false, counts_);
        for (RepairWay& way : ways_) way.solve(goals_);
    }

    double episode() {
        walk(ways_[0].solver.tree());
        double scratch = 0.0;
        for (RepairWay& way : ways_) {
            for (const floors::Step& t : steps_) record(way.counts, t);
            way.seconds.push_back(way.solve(goals_));
            way.total += way.seconds.back();
            if (way.scratch) scratch = way.seconds.back();
            way.ratio.push_back(way.seconds.back() / scratch);
        }
        require_equal(ways_[0].solver.tree(), ways_[1].solver.tree());
        return scratch;
    }

    /// A line for each way.
    [[nodiscard]] std::vector<std::string> summary() const {
        std::vector<std::string> lines;
        for (const RepairWay& way : ways_) {
            std::vector<double> sorted = way.ratio;
            std::sort(sorted.begin(), sorted.end());
            char line[200];
            std::snprintf(line, sizeof line,
                          "learning, 1e4: %s: median %.1f us, sum / sum %.3f, median ratio %.3f, 99 %% below %.2f",
                          way.name, 1e6 * floors::median(way.seconds), way.total / ways_[0].total,
                          floors::median(way.ratio), sorted[sorted.size() * 99 / 100]);
            lines.emplace_back(line);
        }
        return lines;
    }

private:
    static void record(RepairCounts& counts, const floors::Step& t) {
        counts.record(StateId{t.state}, ActionId{t.action}, StateId{t.next}, t.terminated, t.reward);
    }

    void walk(const ShortestPathTree& tree) {
        const auto goal = static_cast<std::uint32_t>(goals_[0].state);
        auto s = static_cast<std::uint32_t>(random_.below(grid_.states()));
        steps_.clear();
        while (s != goal && steps_.size() < 20000) {
            auto action = static_cast<std::uint32_t>(random_.below(4));
            if (!random_.chance(0.1) && s < tree.size() && tree.next[s] != no_state) {
                while (grid_.moved(s, action) != static_cast<std::uint32_t>(tree.next[s])) action = (action + 1) % 4;
            }
            const std::uint32_t next = grid_.moved(s, floors::SlipperyGrid::direction(action, random_));
            steps_.push_back({s, action, 0.0, next, next == goal});
            s = next;
        }
    }

    floors::SlipperyGrid grid_;
    std::vector<Goal> goals_;
    Random random_;
    RepairCounts counts_;
    std::vector<RepairWay> ways_;
    std::vector<floors::Step> steps_;
};

}  // namespace sspql::duels
