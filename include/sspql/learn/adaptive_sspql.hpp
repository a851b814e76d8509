// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/step_budget.hpp>
#include <sspql/learn/adaptive_params.hpp>
#include <sspql/learn/backup_queue.hpp>
#include <sspql/learn/change_detector.hpp>
#include <sspql/learn/goal_distances.hpp>
#include <sspql/learn/optimism_scale.hpp>
#include <sspql/learn/q_table.hpp>
#include <sspql/learn/taught_learner.hpp>
#include <sspql/learn/transition.hpp>
#include <sspql/model/cells.hpp>
#include <sspql/model/transition_counts.hpp>

namespace sspql {

/// What an AdaptiveSspql is about, for reports.
struct AdaptiveStatus {
    std::size_t states_known = 0;    ///< seen at least once
    std::size_t pairs_tried = 0;     ///< (s,a) tried at least once
    std::uint64_t edge_touches = 0;  ///< all planning and recording so far
    std::uint64_t steps = 0;
    std::uint64_t alarms = 0;        ///< changes noticed
    double optimism = 0.0;           ///< c, in steps
    double kappa = 0.0;              ///< the pseudo-count
    double noise = 0.0;              ///< how often outcomes are not the usual one
    double typical_cost = 0.0;       ///< median cost of the last episodes, in steps
    bool goal_known = false;
};

template <class Policies = AdaptivePolicies>
class AdaptiveSspql
    : public TaughtLearner<AdaptiveSspql<Policies>, Policies, AdaptiveParams<Policies>> {
    using Base = TaughtLearner<AdaptiveSspql, Policies, AdaptiveParams<Policies>>;
    friend Learner<AdaptiveSspql, typename Policies::LegalActions>;

public:
    using Params = AdaptiveParams<Policies>;
    using Counts = TransitionCounts<FadingCell>;

    AdaptiveSspql(StateCount states, std::size_t actions, Params params = {}, std::uint64_t seed = 0)
        : Base(states, actions, std::move(params), seed),
          counts_(states.initial(), actions),
          q_(states.initial(), actions),
          scale_((this->params_.validate(), this->params_.gamma), this->params_.optimism),
          detector_(states.initial(), actions, this->params_.change),
          distances_(states.initial()),
          queue_(states.initial(), actions),
          budget_(this->params_.budget),
          kappa_(this->params_.kappa_least) {
        add_tables(states.initial());
    }

    void reserve(std::size_t states, std::size_t pairs = 0) {
        Base::reserve_visits(states);
        q_.reserve(states);
        counts_.reserve(states, pairs == 0 ? 5 * states : pairs);
        detector_.reserve(states);
        distances_.reserve(states);
        value_.reserve(states);
        best_.reserve(states);
        here_.reserve(states);
        ahead_.reserve(states);
        tried_.reserve(states);
        open_.reserve(states);
        seen_.reserve(states);
        leads_out_.reserve(states);
    }

    [[nodiscard]] ActionTerms terms(StateId s, ActionId a) const {
        Base::require_known(s, a);
        const double q = counts_.n(s, a) > 0.0 ? q_(s, a) : here(s);
        return {q, 0.0, bonus_factor(s) / (counts_.n(s, a) + 1.0), Base::hint_term(s, a), counts_.n(s, a)};
    }

    [[nodiscard]] const QTable& q() const noexcept { return q_; }
    [[nodiscard]] const Counts& counts() const noexcept { return counts_; }
    [[nodiscard]] const OptimismScale& scale() const noexcept { return scale_; }
    [[nodiscard]] double state_value(StateId s) const noexcept { return seen_[index(s)] ? value_[index(s)] : 1.0; }
    [[nodiscard]] double path_length(StateId s) const { return distances_.distance(s); }
    [[nodiscard]] std::uint64_t model_operations() const noexcept { return operations_; }

    [[nodiscard]] AdaptiveStatus status() const noexcept {
        return {order_.size(), pairs_tried_, operations_, steps_, detector_.alarms(), scale_.optimism(), kappa_, noise_,
                scale_.typical_cost(), scale_.goal_known()};
    }

private:
    static constexpr double never = -std::numeric_limits<double>::infinity();

    void add_tables(std::size_t n) {
        value_.resize(n, 1.0);
        best_.resize(n, never);
        here_.resize(n, 1.0);
        ahead_.resize(n, 1.0);
        tried_.resize(n, 0);
        open_.resize(n, 0);
        seen_.resize(n, 0);
        leads_out_.resize(n, 0);
    }

    void add_states(std::size_t n) {
        Base::add_states(n);
        q_.grow(n);
        counts_.grow(n);
        detector_.grow(n);
        distances_.grow(n);
        queue_.grow(n);
        add_tables(n);
    }

    // --- values ---

    [[nodiscard]] double here(StateId s) const noexcept { return here_[index(s)]; }
    [[nodiscard]] double step_threshold() const noexcept { return this->params_.threshold * scale_.step_value(); }

    void set_level(StateId s) {
        double path = GoalDistances::unknown;
        if (this->params_.bound_by_paths) path = distances_.distance(s);
        else path = 0.0;
        const OptimismScale::Level level = scale_.level(path);
        here_[index(s)] = level.here;
        ahead_[index(s)] = level.ahead;
    }

    void renew_value(StateId s) noexcept {
        const std::size_t i = index(s);
        value_[i] = tried_[i] == 0 ? here_[i] : open_[i] != 0 ? std::max(best_[i], ahead_[i]) : best_[i];
    }

    void renew_best(StateId s) noexcept {
        const auto& allowed = Base::legal().allowed(s);
        double best = never;
        for (std::size_t i = 0; i < Base::actions(); ++i) {
            const ActionId a = action_id(i);
            if (allowed.contains(a) && counts_.n(s, a) > 0.0) best = std::max(best, q_(s, a));
        }
        best_[index(s)] = best;
        renew_value(s);
    }

    void count_actions(StateId s) noexcept {
        const auto& allowed = Base::legal().allowed(s);
        std::uint16_t tried = 0;
        std::uint16_t open = 0;
        for (std::size_t i = 0; i < Base::actions(); ++i) {
            if (!allowed.contains(action_id(i))) continue;
            ++(counts_.n(s, action_id(i)) > 0.0 ? tried : open);
        }
        tried_[index(s)] = tried;
        open_[index(s)] = open;
    }

    void know(StateId s, StateId from) {
        if (seen_[index(s)]) return;
        seen_[index(s)] = 1;
        order_.push_back(s);
        distances_.set_distance(s, from == no_state ? GoalDistances::unknown : distances_.distance(from));
        set_level(s);
        count_actions(s);
        renew_value(s);
    }

    void legal_actions_changed(StateId s) {
        if (!seen_[index(s)]) return;
        const double before = value_[index(s)];
        count_actions(s);
        renew_best(s);
        pass_on(s, before);
    }

    [[nodiscard]] double worth(StateId s) const noexcept {
        return given_.empty() ? std::numeric_limits<double>::quiet_NaN() : worth_[index(s)];
    }

    /// Sum over the outcomes of (s,a) of n (r + gamma v(s')), s' = s apart.
    struct Sums {
        double value = 0.0;
        double self = 0.0;
    };

    template <class Value>
    Sums sum_outcomes(StateId s, ActionId a, const Value& value) {
        Sums sums;
        const double gamma = this->params_.gamma;
        counts_.for_each_successor(s, [&](const auto& successor) {
            const FadingCell* cell = successor.cell(a);
            if (cell == nullptr) return;
            spend(1);
            const StateId next = successor.state();
            if (!given_.empty() && worth_[index(next)] == worth_[index(next)]) {
                sums.value += cell->n * worth_[index(next)];
                return;
            }
            if (cell->terminal()) {
                sums.value += given_.empty() ? cell->reward_sum : std::min(0.0, cell->reward_sum);
                return;
            }
            sums.value += cell->reward_sum;
            if (next == s) {
                sums.self = cell->n;
            } else {
                sums.value += cell->n * gamma * value(next);
            }
        });
        return sums;
    }

    [[nodiscard]] double kappa_of(StateId s, ActionId a) const noexcept {
        if (this->params_.tau == 0.0) return kappa_;
        const std::size_t at = index(s) * Base::actions() + index(a);
        const double age = static_cast<double>(steps_ - last_try_[at]);
        return kappa_ + counts_.n(s, a) *
                            (1.0 - std::exp(-age / (this->params_.tau * static_cast<double>(pairs_tried_))));
    }

    [[nodiscard]] double backup(StateId s, ActionId a) {
        const Sums sums = sum_outcomes(s, a, [&](StateId next) { return value_[index(next)]; });
        const double kappa = kappa_of(s, a);
        const double total = counts_.n(s, a) + kappa;
        const double x = (kappa * here(s) + sums.value) / total;
        const double p = this->params_.gamma * sums.self / total;
        if (p == 0.0) return x;
        const double alone = x / (1.0 - p);
        double other = open_[index(s)] != 0 ? ahead_[index(s)] : never;
        if (alone >= other) {
            const auto& allowed = Base::legal().allowed(s);
            for (std::size_t i = 0; i < Base::actions(); ++i) {
                const ActionId b = action_id(i);
                if (b != a && allowed.contains(b) && counts_.n(s, b) > 0.0) other = std::max(other, q_(s, b));
            }
        }
        return alone >= other ? alone : x + p * other;
    }

    /// Every (u,b) that leads to s is queued for a backup if the change of V(s) matters to it.
    void pass_on(StateId s, double before) {
        const double change = std::fabs(value_[index(s)] - before);
        const double threshold = step_threshold();
        if (!(change > threshold)) return;
        const double most = this->params_.gamma * change;
        if (!given_.empty() && worth(s) == worth(s)) return;
        counts_.for_each_edge_into(s, [&](StateId u, const auto& edge) {
            edge.for_each_action([&](ActionId b, const FadingCell& cell) {
                spend(1);
                if (cell.terminal()) return;
                const double priority = most * cell.n / (counts_.n(u, b) + kappa_);
                if (priority > threshold) queue_.raise(u, b, priority);
            });
        });
    }

    void sweep_one() {
        const BackupQueue::Pair pair = queue_.pop();
        ++operations_;
        if (!(counts_.n(pair.state, pair.action) > 0.0)) return;
        const double before = value_[index(pair.state)];
        q_(pair.state, pair.action) = backup(pair.state, pair.action);
        renew_best(pair.state);
        pass_on(pair.state, before);
    }

    void sweep() {
        std::uint64_t begun = operations_;
        while (!budget_.exhausted() && !queue_.empty() && operations_ - begun < this->params_.slice) sweep_one();
    }

    void spend(std::uint64_t edges) noexcept {
        operations_ += edges;
        budget_.spend(edges);
    }

    // --- choosing ---

    [[nodiscard]] double bonus_factor(StateId s) const noexcept {
        if (!scale_.goal_known()) return 0.0;
        const double left = std::max(0.0, scale_.cost_of(value_[index(s)])) * scale_.step_value();
        const double typical = scale_.typical_cost();
        const double shrink = typical > this->params_.bonus_scale ? this->params_.bonus_scale / typical : 1.0;
        return this->params_.bonus * left * shrink;
    }

    ActionId select(StateId s) {
        know(s, no_state);
        const double bonus = bonus_factor(s);
        return Base::choose(s, [&](ActionId a) {
            const double n = counts_.n(s, a);
            double score = (n > 0.0 ? q_(s, a) : here(s)) + bonus / (n + 1.0);
            if (!this->hints_.empty()) score += Base::hint_term(s, a);
            return score;
        });
    }

    [[nodiscard]] double value(StateId s, ActionId a) const noexcept { return counts_.n(s, a) > 0.0 ? q_(s, a) : -1e300; }

    // --- learning ---

    void episode_begun() noexcept { scale_.begin_episode(); }

    void learn(const Transition& t) {
        const StateId s = t.state;
        const ActionId a = t.action;
        ++steps_;
        path_bank_ += this->params_.path_budget;
        know(s, no_state);
        const bool given_goal = !given_.empty() && worth(t.next) == worth(t.next);
        const bool ends = t.terminated || given_goal;
        know(t.next, ends ? no_state : s);
        const double n = counts_.n(s, a);
        const bool first = !(n > 0.0);
        const bool costs_before = scale_.costs();
        if (given_goal) {
            scale_.observe_end(worth(t.next), true);
        } else if (t.terminated) {
            scale_.observe_end(t.reward, given_.empty() && scale_.counts_as_goal(t.reward));
        } else {
            scale_.observe_step(t.reward, first);
        }
        budget_.earn();
        const double before = value_[index(s)];
        if (!first) {
            const ChangeDetector::Surprise surprise = detector_.judge(counts_, s, a, t.next);
            spend(surprise.outcomes);
            const double w = std::min(1.0, n / 3.0);
            noise_ += w * (1.0 - surprise.likelihood - noise_) * std::max(0.002, 1.0 / (1.0 + noise_weight_));
            noise_weight_ += w;
            kappa_ = std::max(this->params_.kappa_least, this->params_.kappa_noise * noise_);
        } else {
            ++pairs_tried_;
            ++tried_[index(s)];
            if (open_[index(s)] != 0) --open_[index(s)];
        }
        if (this->params_.cap > 0.0 && n >= this->params_.cap) {
            counts_.fade(s, a, this->params_.cap / (n + 1.0), this->params_.change.least_count);
        }
        counts_.record(s, a, t.next, t.terminated, t.reward, t.weight);
        this->visits_.add(s, a);
        if (this->params_.tau > 0.0) remember_try(s, a);
        if (ends && !leads_out_[index(s)]) {
            leads_out_[index(s)] = 1;
            exits_.push_back(s);
        }
        detector_.follow(counts_, s, a, t.next);
        if (detector_.alarmed(s, a, pairs_tried_)) detector_.reset(counts_, s, a);
        if (scale_.costs() != costs_before && !scale_.goal_known()) relevel_all(false);

        q_(s, a) = backup(s, a);
        renew_best(s);
        for (std::size_t i = 0; i < Base::actions(); ++i) {
            const ActionId b = action_id(i);
            if (b == a || !(counts_.n(s, b) > 0.0)) continue;
            q_(s, b) = backup(s, b);
            renew_best(s);
        }
        pass_on(s, before);
        sweep();
    }

    void remember_try(StateId s, ActionId a) {
        if (last_try_.size() < value_.size() * Base::actions()) last_try_.resize(value_.size() * Base::actions(), 0);
        last_try_[index(s) * Base::actions() + index(a)] = steps_;
    }

    // --- at the end of an episode ---

    void relevel_all(bool pass) {
        for (const StateId s : order_) {
            const double before = value_[index(s)];
            set_level(s);
            renew_value(s);
            ++operations_;
            if (pass) pass_on(s, before);
        }
    }

    [[nodiscard]] auto step_cost() const {
        const bool costs = scale_.costs();
        const double unit = scale_.unit();
        return [costs, unit](double mean_reward) { return costs ? std::max(1.0, -mean_reward / unit) : 1.0; };
    }

    void find_paths() {
        const bool mode_changed = labelled_costs_ != scale_.costs() || (scale_.costs() && labelled_unit_ != scale_.unit());
        labelled_costs_ = scale_.costs();
        labelled_unit_ = scale_.unit();
        const std::size_t edges = mode_changed ? distances_.refresh_all(counts_, step_cost()) : distances_.refresh(counts_, step_cost());
        seeds_.clear();
        for (const StateId s : exits_) {
            double least = GoalDistances::unknown;
            counts_.for_each_successor(s, [&](const auto& successor) {
                successor.for_each_action([&](ActionId a, const FadingCell& cell) {
                    const bool goal = !given_.empty() && worth(successor.state()) == worth(successor.state());
                    if (!(goal || cell.terminal()) || cell.n < 0.5) return;
                    const double r = goal ? worth(successor.state()) : cell.mean_reward();
                    if (!goal && (!given_.empty() || !scale_.counts_as_goal(r))) return;
                    const double cost = scale_.costs() ? (scale_.top() - r) / scale_.unit() : scale_.cost_of(r) + 1.0;
                    least = std::min(least, std::max(0.0, cost) * counts_.n(s, a) / cell.n);
                });
            });
            if (least < GoalDistances::unknown) seeds_.push_back({s, least});
        }
        distances_.start(seeds_);
        StepBudget all = StepBudget::unlimited();
        distances_.advance(counts_, all);
        path_cost_ = static_cast<double>(distances_.work() + edges);
        operations_ += distances_.work() + edges;
    }

    void episode_ended() {
        scale_.end_episode();
        if (!scale_.goal_known()) return;
        if (this->params_.bound_by_paths && (!resolved_ || path_bank_ >= path_cost_)) {
            path_bank_ = 0.0;
            find_paths();
        }
        relevel_all(resolved_);
        if (!resolved_) resolve();
    }

    void resolve() {
        resolved_ = true;
        queue_.clear();
        for (const StateId s : order_) {
            for (std::size_t i = 0; i < Base::actions(); ++i) {
                const ActionId a = action_id(i);
                const double n = counts_.n(s, a);
                if (!(n > 0.0)) continue;
                const Sums sums = sum_outcomes(s, a, [&](StateId next) { return ahead_[index(next)]; });
                q_(s, a) = (sums.value + sums.self * this->params_.gamma * ahead_[index(s)]) / n;
            }
            renew_best(s);
        }
        for (const StateId s : order_) {
            for (std::size_t i = 0; i < Base::actions(); ++i) {
                const ActionId a = action_id(i);
                if (!(counts_.n(s, a) > 0.0)) continue;
                const double off = std::fabs(backup(s, a) - q_(s, a));
                if (off > 0.0) queue_.raise(s, a, off);
            }
        }
        budget_.grant(budget_.per_step() * steps_);
        sweep();
    }

    void goals_changed(const std::vector<Goal>& goals) {
        given_ = goals;
    }

    Counts counts_;
    QTable q_;
    OptimismScale scale_;
    ChangeDetector detector_;
    GoalDistances distances_;
    BackupQueue queue_;
    StepBudget budget_;

    std::vector<double> value_;   // V(s)
    std::vector<double> best_;    // max Q over tried legal actions
    std::vector<double> here_;    // worth of an untried action of s
    std::vector<double> ahead_;   // ... seen from another state
    std::vector<std::uint16_t> tried_;
    std::vector<std::uint16_t> open_;  // legal actions never tried
    std::vector<std::uint8_t> seen_;
    std::vector<StateId> order_;  // states in the order they were seen
    std::vector<std::uint8_t> leads_out_;
    std::vector<StateId> exits_;  // states from which an episode ended
    std::vector<Goal> seeds_;
    std::vector<std::uint64_t> last_try_;

    std::vector<Goal> given_;
    std::vector<double> worth_;

    double kappa_;
    double noise_ = 0.0;
    double noise_weight_ = 0.0;
    double path_bank_ = 0.0;
    double path_cost_ = 0.0;
    double labelled_unit_ = 0.0;
    bool labelled_costs_ = false;
    bool resolved_ = false;
    std::size_t pairs_tried_ = 0;
    std::uint64_t steps_ = 0;
    std::uint64_t operations_ = 0;
};

}  // namespace sspql
