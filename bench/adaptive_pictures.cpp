// SPDX-License-Identifier: MIT
//
// What does the adaptive planner believe before and after a wall moves, and how does it look for a goal it does not
// know? Writes the pictures of docs/adaptive.md: adaptive_pictures --help

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <sspql/env/changing_grid_world.hpp>
#include <sspql/env/grid_maps.hpp>
#include <sspql/learn/adaptive_sspql.hpp>

#include "experiment/options.hpp"
#include "report/belief_picture.hpp"
#include "report/output_file.hpp"

namespace {

using namespace sspql;
using report::BeliefCell;
using report::BeliefPanel;

/// A learner in a world, step by step, and what happened lately.
class Watch {
public:
    Watch(ChangingGridWorld world, std::uint64_t seed)
        : world_(std::move(world)),
          learner_(world_.size(), GridWorld::actions, {}, seed),
          seen_(world_.size()),
          seed_(seed) {
        begin();
    }

    /// One step; a new episode begins where one has ended.
    void step() {
        if (ended_) begin();
        const std::uint64_t alarms = learner_.status().alarms;
        const StateId from = at_;
        const ActionId action = action_;
        const Step<StateId> outcome = world_.step(static_cast<Move>(index(action)));
        at_ = outcome.observation;
        way_.push_back(index(at_));
        seen_[index(at_)] = true;
        ended_ = outcome.terminated;
        if (ended_) {
            learner_.end(outcome.reward, at_, true);
            ++episodes_;
        } else {
            action_ = learner_.step(outcome.reward, at_);
        }
        if (learner_.status().alarms > alarms) alarmed_.emplace_back(index(from), index(action));
    }

    /// The rest of the running episode. \returns its steps.
    std::size_t finish() {
        do {
            step();
        } while (!ended_);
        return way_.size() - 1;
    }

    /// What it believes now. Alarms are those since the last panel; the robot is drawn within an episode only.
    BeliefPanel panel(std::string title, std::string subtitle) {
        BeliefPanel result{std::move(title), std::move(subtitle), {}, {}, {}};
        const GridMap& map = world_.world().map();
        for (std::size_t i = 0; i < map.size(); ++i) result.cells.push_back(cell(map, state_id(i)));
        for (const auto& [state, action] : alarmed_) result.cells[state].alarmed[action] = true;
        alarmed_.clear();
        if (!ended_) result.robot = index(at_);
        result.way = way_;
        return result;
    }

    [[nodiscard]] std::size_t steps() const { return world_.steps(); }
    [[nodiscard]] std::size_t episodes() const { return episodes_; }
    [[nodiscard]] std::size_t at() const { return index(at_); }
    [[nodiscard]] bool goal_known() const { return learner_.status().goal_known; }
    [[nodiscard]] bool alarmed() const { return !alarmed_.empty(); }
    [[nodiscard]] bool changed() const { return world_.changes_made() > 0; }

private:
    void begin() {
        at_ = world_.reset(1000 * seed_ + episodes_);
        way_.assign(1, index(at_));
        seen_[index(at_)] = true;
        action_ = learner_.begin(at_);
        ended_ = false;
    }

    [[nodiscard]] BeliefCell cell(const GridMap& map, StateId s) const {
        BeliefCell cell;
        if (map.cell(s) == GridCell::wall) cell.kind = report::GridCellKind::wall;
        if (map.cell(s) == GridCell::goal) cell.kind = report::GridCellKind::goal;
        if (!seen_[index(s)] || cell.kind != report::GridCellKind::free) return cell;
        cell.steps = goal_known() ? std::max(0.0, learner_.scale().cost_of(learner_.state_value(s))) : unknown;
        double most = -1e300;
        for (std::size_t a = 0; a < GridWorld::actions; ++a) {
            const ActionTerms terms = learner_.terms(s, action_id(a));
            cell.untried[a] = terms.n == 0.0;
            if (!(terms.sum() > most)) continue;
            most = terms.sum();
            cell.next = static_cast<report::GridMove>(a);
        }
        return cell;
    }

    static constexpr double unknown = std::numeric_limits<double>::infinity();

    ChangingGridWorld world_;
    AdaptiveSspql<> learner_;
    std::vector<bool> seen_;
    std::uint64_t seed_;
    StateId at_{};
    ActionId action_{};
    bool ended_ = true;
    std::size_t episodes_ = 0;
    std::vector<std::size_t> way_;
    std::vector<std::pair<std::size_t, std::size_t>> alarmed_;  // (s,a) since the last panel
};

std::string count(std::size_t n, const std::string& what) {
    return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

report::Svg change_picture(std::uint64_t seed) {
    const GridTask task = grid_task("blocking-maze");
    Watch watch(task.changing_world(), seed);
    std::vector<BeliefPanel> panels;
    std::size_t last = 0;
    const std::size_t moves_at = task.changes.front().from_step;
    while (watch.steps() + 2 * last < moves_at || last == 0) last = watch.finish();
    panels.push_back(
        watch.panel("The way is known", "episode " + std::to_string(watch.episodes()) + ": " + count(last, "step")));

    while (!(watch.changed() && watch.alarmed())) watch.step();
    const std::size_t before = watch.at();
    std::size_t bumps = 0;
    for (; watch.at() == before; ++bumps) watch.step();
    panels.push_back(watch.panel("The wall has moved", count(bumps, "bump") + ", then it turns away"));

    const std::size_t search = watch.finish();
    for (int k = 0; k < 4; ++k) last = watch.finish();
    panels.push_back(
        watch.panel("Four episodes later", count(last, "step") + "; the search took " + std::to_string(search)));
    const GridMap& map = task.map;
    return report::belief_picture(
        panels, map.rows(), map.columns(), 3,
        "Three maps: what the planner believes before a wall moves, when it meets the wall, and "
        "four episodes later");
}

report::Svg search_picture(std::uint64_t seed) {
    const GridTask task = grid_task("walls12:4");
    Watch watch(task.changing_world(), seed);
    std::vector<BeliefPanel> panels;
    while (watch.steps() < 60 && !watch.goal_known()) watch.step();
    panels.push_back(watch.panel("No goal known", "step " + std::to_string(watch.steps()) + " of the first episode"));
    while (!watch.goal_known()) watch.step();
    panels.push_back(watch.panel("The goal is found", "at step " + std::to_string(watch.steps())));
    while (watch.episodes() < 9) watch.finish();
    const std::size_t last = watch.finish();
    panels.push_back(watch.panel("Episode 10", count(last, "step")));
    return report::belief_picture(
        panels, task.map.rows(), task.map.columns(), 3,
        "Three maps: what the planner believes while it looks for a goal, when it has found it, "
        "and in episode 10");
}

int body(int argc, char** argv) {
    std::string out;
    std::int64_t seed = 3;
    experiment::Options parser("adaptive_pictures", "The pictures of docs/adaptive.md, as SVG files.");
    parser.text("--out", out, "The folder to write them to");
    parser.whole("--seed", seed, 1, 1000000, "The run that is drawn");
    if (!parser.parse(argc, argv)) return 0;
    if (out.empty()) throw std::invalid_argument("give --out (--help lists the options)");
    report::write_file(out + "/adaptive-change.svg", change_picture(static_cast<std::uint64_t>(seed)).document());
    report::write_file(out + "/adaptive-search.svg", search_picture(static_cast<std::uint64_t>(seed)).document());
    return 0;
}

}  // namespace

int main(int argc, char** argv) { return sspql::experiment::run_program("adaptive_pictures", body, argc, argv); }
