// SPDX-License-Identifier: MIT
//
// What does a step of each learner cost: next to the same learner written by hand for one task, and, SSPQL's next to
// Dyna-Q's, when an episode's shortest paths are cheaper than k planning steps a step?
//
// Against floors (floors/): an update of eq. 1, a step of Q-learning and of SSPQL, a planning step of Dyna-Q,
// a backup of prioritized sweeping, on a grid of 64, 10 000 and 1 000 000 states, four actions, one step in ten slips;
// the model is learnt from ten tries of every (s,a). Library and floor take turns in one process, on the same steps and
// the same random numbers, and must reach the same values.
// Whole episodes: SSPQL and Dyna-Q with k = 5, 20, 50 and 0.2 |S| |A| go through the same episodes of 50, 500 and 5000
// random steps; the table at the end says at which k an episode of Dyna-Q costs as much as one of SSPQL.
// Times are CPU times; a ratio is the median over the turns of library / other. The summary goes to the standard error;
// for JSON use --benchmark_out=FILE --benchmark_out_format=json.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include <sspql/learn/dyna_q.hpp>
#include <sspql/learn/prioritized_sweeping.hpp>
#include <sspql/learn/q_learning.hpp>
#include <sspql/learn/q_update.hpp>
#include <sspql/learn/sspql.hpp>

#include "floors/match.hpp"
#include "floors/planning_floor.hpp"
#include "floors/slippery_grid.hpp"
#include "floors/sspql_floor.hpp"

namespace {

using namespace sspql;
using floors::Match;
using floors::SlipperyGrid;
using floors::Step;

constexpr double alpha = 0.8;
constexpr double gamma_ = 0.95;
constexpr std::uint32_t tries = 10;
constexpr std::uint64_t seed = 1;

struct Size {
    const char* name;
    std::uint32_t columns;
    std::uint32_t rows;
};
constexpr Size sizes[] = {{"64", 8, 8}, {"1e4", 100, 100}, {"1e6", 1000, 1000}};

/// A library's learner that learns the model first and plans afterwards.
template <class Learner>
class Planner : public Learner {
public:
    using Learner::Learner;
    void set_planning_steps(std::size_t steps) { this->params_.planning_steps = steps; }

    void learn_from(const Step& t) {
        Learner::observe(StateId{t.state}, ActionId{t.action}, t.reward, StateId{t.next}, t.terminated);
    }
};

/// Some of the steps of the exploration, spread over the grid, in random order; rewards in [0, 1).
class StepPool {
public:
    explicit StepPool(const SlipperyGrid& grid) : random_(seed, RandomStream::environment) {
        const std::size_t every = std::max<std::size_t>(1, std::size_t{grid.states()} * 4 * tries / most);
        std::size_t i = 0;
        grid.explore(tries, seed, [&](const Step& t) {
            if (i++ % every == 0) steps_.push_back(t);
        });
    }

    Step draw() {
        Step t = steps_[random_.below(steps_.size())];
        t.reward = random_.uniform();
        return t;
    }

private:
    static constexpr std::size_t most = 1 << 16;
    Random random_;
    std::vector<Step> steps_;
};

/// The largest difference between the two tables.
double difference(const QTable& ours, const floors::Values& floor) {
    double largest = 0.0;
    for (std::size_t s = 0; s < ours.states(); ++s) {
        for (std::size_t a = 0; a < floors::actions; ++a) {
            largest = std::max(largest, std::fabs(ours(state_id(s), action_id(a)) - floor[s * floors::actions + a]));
        }
    }
    return largest;
}

// ---- The duels: `turn` prepares one, `ours` and `floor` do the same amount of work and return it --------------------

class DynaQDuel {
public:
    explicit DynaQDuel(const SlipperyGrid& grid)
        : ours_(grid.states(), floors::actions, params(), seed),
          floor_(grid.states(), alpha, gamma_, seed),
          pool_(grid) {
        grid.explore(tries, seed, [this](const Step& t) { ours_.learn_from(t); });
        grid.explore(tries, seed, [this](const Step& t) { floor_.observe(t, 0); });
        ours_.set_planning_steps(planning_steps);
    }

    void turn() { step_ = pool_.draw(); }
    std::uint64_t ours() {
        ours_.learn_from(step_);
        return planning_steps;
    }
    std::uint64_t floor() {
        floor_.observe(step_, planning_steps);
        return planning_steps;
    }
    [[nodiscard]] double disagreement() const { return difference(ours_.q(), floor_.q()); }

private:
    static constexpr std::size_t planning_steps = 2000;

    static DynaQParams<> params() {
        DynaQParams<> params;
        params.alpha = alpha;
        params.gamma = gamma_;
        params.planning_steps = 0;
        return params;
    }

    Planner<DynaQ<>> ours_;
    floors::DynaQ floor_;
    StepPool pool_;
    Step step_{};
};

class SweepingDuel {
public:
    explicit SweepingDuel(const SlipperyGrid& grid)
        : ours_(grid.states(), floors::actions, params(), seed), floor_(grid.states(), gamma_, threshold), pool_(grid) {
        grid.explore(tries, seed, [this](const Step& t) { ours_.learn_from(t); });
        grid.explore(tries, seed, [this](const Step& t) { floor_.observe(t, 0); });
        ours_.set_planning_steps(most_backups);
    }

    /// Rewards that bring the mean reward of (s,a) to a new value in [0, 1): however much was seen, values move.
    void turn() {
        for (Step& t : steps_) {
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
        for (const Step& t : steps_) ours_.learn_from(t);
        return ours_.backups() - before;
    }
    std::uint64_t floor() {
        const std::uint64_t before = floor_.backups();
        for (const Step& t : steps_) floor_.observe(t, most_backups);
        return floor_.backups() - before;
    }
    [[nodiscard]] double disagreement() const { return difference(ours_.q(), floor_.q()); }

private:
    static constexpr double threshold = 1e-3;
    static constexpr std::size_t most_backups = 1000;

    static PrioritizedSweepingParams<> params() {
        PrioritizedSweepingParams<> params;
        params.gamma = gamma_;
        params.threshold = threshold;
        params.planning_steps = 0;
        return params;
    }

    Planner<PrioritizedSweeping<>> ours_;
    floors::PrioritizedSweeping floor_;
    StepPool pool_;
    std::vector<Step> steps_ = std::vector<Step>(16);
};

/// Both are led through the same random walk, whatever they choose; the choices are compared through the values.
class QLearningDuel {
public:
    explicit QLearningDuel(const SlipperyGrid& grid)
        : grid_(grid),
          ours_(grid.states(), floors::actions, params(), seed),
          floor_(grid.states(), alpha, gamma_, noise, seed),
          random_(seed, RandomStream::environment) {
        static_cast<void>(ours_.begin(StateId{state_}));
        floor_.begin(state_);
    }

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

private:
    static constexpr double noise = 0.01;

    static QLearningParams<> params() {
        QLearningParams<> params;
        params.alpha = alpha;
        params.gamma = gamma_;
        params.selector = ActionSelector(noise);
        return params;
    }

    SlipperyGrid grid_;
    QLearning<> ours_;
    floors::QLearning floor_;
    Random random_;
    std::uint32_t state_ = 0;
    std::vector<std::pair<double, std::uint32_t>> walk_ = std::vector<std::pair<double, std::uint32_t>>(2000);
};

/// An update of eq. 1 for each of many steps.
class QUpdateDuel {
public:
    explicit QUpdateDuel(const SlipperyGrid& grid) : ours_(grid.states(), floors::actions), floor_(grid.states()), pool_(grid) {}

    void turn() {
        for (Step& t : steps_) t = pool_.draw();
    }
    std::uint64_t ours() {
        for (const Step& t : steps_) {
            q_update(ours_, {StateId{t.state}, ActionId{t.action}, t.reward, StateId{t.next}, t.terminated, 1.0}, alpha,
                     gamma_, legal_);
        }
        return steps_.size();
    }
    std::uint64_t floor() {
        for (const Step& t : steps_) {
            double& q = floor_[t.state * floors::actions + t.action];
            q += alpha * (t.reward + (t.terminated ? 0.0 : gamma_ * floor_.max(t.next)) - q);
        }
        return steps_.size();
    }
    [[nodiscard]] double disagreement() const { return difference(ours_, floor_); }

private:
    QTable ours_;
    LegalActionTable legal_;
    floors::Values floor_;
    StepPool pool_;
    std::vector<Step> steps_ = std::vector<Step>(2000);
};

/// As QLearningDuel, with the paths to the last cell as they are after ten tries of every (s,a).
class SspqlDuel {
public:
    explicit SspqlDuel(const SlipperyGrid& grid)
        : grid_(grid),
          ours_(grid.states(), floors::actions, params(), seed),
          floor_(grid.states(), alpha, gamma_, noise, 0.1, seed),
          random_(seed, RandomStream::environment) {
        ours_.set_goals({{state_id(grid.states() - 1), 0.0}});
        grid.explore(tries, seed, [this](const Step& t) {
            ours_.observe(StateId{t.state}, ActionId{t.action}, t.reward, StateId{t.next}, false);
            floor_.observe({t.state, t.action, t.reward, t.next, false});
        });
        ours_.update_paths();
        for (std::uint32_t s = 0; s < grid.states(); ++s) {
            const ActionId a = ours_.ssp_values().action(StateId{s});
            if (a != no_action) floor_.set_path(s, static_cast<std::uint32_t>(a), ours_.ssp_values()(StateId{s}, a));
        }
        static_cast<void>(ours_.begin(StateId{state_}));
        floor_.begin(state_);
    }

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

private:
    static constexpr double noise = 0.01;

    static SspqlParams<> params() {
        SspqlParams<> params;
        params.alpha = alpha;
        params.gamma = gamma_;
        params.selector = ActionSelector(noise);
        return params;
    }

    SlipperyGrid grid_;
    Sspql<> ours_;
    floors::Sspql floor_;
    Random random_;
    std::uint32_t state_ = 0;
    std::vector<std::pair<double, std::uint32_t>> walk_ = std::vector<std::pair<double, std::uint32_t>>(2000);
};

template <class Duel>
Match match_of(const Size& size) {
    const auto duel = std::make_shared<Duel>(SlipperyGrid(size.columns, size.rows));
    Match match;
    match.prepare = [=] { duel->turn(); };
    match.rivals = {{"library", [=] { return duel->ours(); }}, {"floor", [=] { return duel->floor(); }}};
    match.disagreement = [=] { return duel->disagreement(); };
    return match;
}

// ---- Whole episodes -------------------------------------------------------------------------------------------------

/// SSPQL, and Dyna-Q with several numbers of planning steps, led through the same episodes; the last step of each ends it
/// in the last cell, with reward 1. ns per step.
class Episodes {
public:
    Episodes(const SlipperyGrid& grid, std::size_t length, std::vector<std::size_t> planning_steps)
        : grid_(grid), sspql_(grid.states(), floors::actions, {}, seed), random_(seed, RandomStream::environment) {
        sspql_.reserve(grid.states());
        for (std::size_t i = 0; i < planning_steps.size(); ++i) {
            dyna_.push_back(std::make_unique<Planner<DynaQ<>>>(grid.states(), floors::actions, without_planning(), seed));
            dyna_.back()->reserve(grid.states());
            dyna_.back()->set_planning_steps(0);
        }
        grid.explore(tries, seed, [this](const Step& t) {
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

    SlipperyGrid grid_;
    Sspql<> sspql_;
    std::vector<std::unique_ptr<Planner<DynaQ<>>>> dyna_;
    Random random_;
    std::uint32_t start_ = 0;
    std::vector<std::uint32_t> steps_;
};

Match episodes(const Size& size, std::size_t length) {
    const SlipperyGrid grid(size.columns, size.rows);
    std::vector<std::size_t> planning_steps{0, 5, 20, 50};
    const std::size_t fifth = std::size_t{grid.states()} * floors::actions / 5;
    if (fifth * length <= 1000000) planning_steps.push_back(fifth);
    const auto played = std::make_shared<Episodes>(grid, length, planning_steps);
    Match match;
    match.prepare = [=] { played->turn(); };
    match.rivals.push_back({"sspql", [=] { return played->play_sspql(); }});
    for (std::size_t i = 0; i < planning_steps.size(); ++i) {
        match.rivals.push_back({"dyna-q k=" + std::to_string(planning_steps[i]), [=] { return played->play_dyna(i); }});
    }
    return match;
}

constexpr Size episode_sizes[] = {{"1e3", 40, 25}, {"1e4", 100, 100}, {"1e5", 400, 250}};
constexpr std::size_t lengths[] = {50, 500, 5000};

std::string episode_name(const Size& size, std::size_t length) {
    return std::string("episode, ns a step/S=") + size.name + "/steps=" + std::to_string(length);
}

/// k at which an episode of Dyna-Q costs as much as one of SSPQL, from what a planning step cost at k = 50.
void print_crossings(const floors::Tournament& tournament) {
    std::fprintf(stderr, "\nplanning steps a step at which Dyna-Q's episode costs as much as SSPQL's\n%14s", "steps:");
    for (const std::size_t length : lengths) std::fprintf(stderr, " %9zu", length);
    for (const Size& size : episode_sizes) {
        std::fprintf(stderr, "\n%14s", (std::string("S = ") + size.name).c_str());
        for (const std::size_t length : lengths) {
            const std::vector<double> ns = tournament.medians(episode_name(size, length));
            if (ns.size() < 5) continue;
            std::fprintf(stderr, " %9.0f", std::max(0.0, (ns[0] - ns[1]) / ((ns[4] - ns[1]) / 50.0)));
        }
    }
    std::fprintf(stderr, "\n");
}

}  // namespace

int main(int argc, char** argv) {
    floors::Tournament tournament;
    for (const Size& size : sizes) {
        tournament.add(std::string("q update/") + size.name, [=] { return match_of<QUpdateDuel>(size); });
    }
    for (const Size& size : sizes) {
        tournament.add(std::string("q-learning step/") + size.name, [=] { return match_of<QLearningDuel>(size); });
    }
    for (const Size& size : sizes) {
        tournament.add(std::string("sspql step/") + size.name, [=] { return match_of<SspqlDuel>(size); });
    }
    for (const Size& size : sizes) {
        tournament.add(std::string("dyna-q planning step/") + size.name, [=] { return match_of<DynaQDuel>(size); });
    }
    for (const Size& size : sizes) {
        tournament.add(std::string("prioritized sweeping backup/") + size.name,
                       [=] { return match_of<SweepingDuel>(size); });
    }
    for (const Size& size : episode_sizes) {
        for (const std::size_t length : lengths) {
            tournament.add(episode_name(size, length), [=] { return episodes(size, length); }, 31);
        }
    }
    const int result = tournament.run(argc, argv);
    if (result == 0) print_crossings(tournament);
    return result;
}

// Found (g++ 12, -O2, two shared and busy cores; medians of library / floor, one to three runs each, of
// versions that differ in details; no complete run of the last one):
//
//     states                          64          1e4         1e6      bound
//     q update                       1.26        1.30        1.19      1.15
//     q-learning step              2.4-2.6     2.7-2.9        -          -
//     sspql step                   1.0-1.2     1.2-1.4       1.40        2
//     dyna-q planning step         1.3-1.6     1.2-1.4     0.9-1.2     1.3
//     prioritized sweeping backup  1.47-1.50   1.25-1.29   1.19-1.24   1.5
//
// All values agreed to the last bit. Planning steps a step at which an episode of Dyna-Q costs as much as one of SSPQL:
//
//     steps of an episode            50         500        5000
//     1e3 states                     12           8           1
//     1e4 states                     24           5           2
//     1e5 states                    170          25           4
//
// So SSPQL is cheaper than Dyna-Q with k = 50 in all but short episodes among 1e5 states, and than k = 0.2 |S| |A| by
// far wherever both were run. The update of eq. 1 misses its bound; an instruction count of it stays below 50.
