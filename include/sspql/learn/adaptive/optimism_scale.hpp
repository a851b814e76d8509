// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <sspql/core/errors.hpp>
#include <sspql/core/serialization.hpp>

namespace sspql {

/// How optimistic AdaptiveSspql is about what it has not tried, in steps (in units of the cost of a step where steps
/// cost). The defaults were chosen once, for all tasks.
struct OptimismParams {
    double fraction = 0.45;  ///< an untried action is believed to lead to the goal in this part of what episodes cost,
    double least = 4.0;      ///< ... but in no fewer steps than this
    double most = 8.0;       ///< ... and no more
    double gap = 4.0;        ///< seen from another state it is believed to be this much further
    double limit = 0.3;      ///< the number of steps stays below limit / (1 - gamma)
    double saving = 2.0;     ///< a state is believed to be at most this much nearer to the goal than its shortest known path

    template <class Archive>
    void serialize(Archive& archive) {
        archive(fraction, least, most, gap, limit, saving);
    }

    /// Checks every number. \throws std::invalid_argument naming the first number out of range.
    void validate() const {
        require_in("optimism.fraction", fraction, 0.0, 10.0);
        require_in("optimism.least", least, 0.0, 1e9);
        require_in("optimism.most", most, least, 1e9);
        require_in("optimism.gap", gap, 0.0, 1e9);
        require_in("optimism.limit", limit, 0.0, 1.0);
        require_in("optimism.saving", saving, 0.0, 1e9);
    }
};

/// The scale between values and steps: what reaching the goal pays, what a step costs, what episodes cost lately; from
/// these, how much an untried action is worth. All it knows comes from rewards; it never sees a state. O(1) a call.
///
/// Two kinds of tasks. Where steps have costs (most actions, when first tried, brought a negative reward without ending
/// the episode), a value v lies (top - v) / unit steps away, `unit` being the smallest such cost. Elsewhere only
/// discounting makes way cost: v lies log(v / top) / log(gamma) steps away. `top` is the best reward an episode ended
/// with. A positive reward on the way is income, not a cost: top is then the most that was ever collected,
/// sum_k gamma^k r_{t-k} over the positive rewards up to some step t. For a goal that pays once this is its reward, for a
/// steady income r it tends to r / (1 - gamma), what staying there is worth.
class OptimismScale {
public:
    static constexpr std::size_t window = 9;  ///< episodes whose costs count

    /// What untried actions of a state are worth: to the state itself, and to others.
    struct Level {
        double here = 1.0;   ///< to the state itself
        double ahead = 1.0;  ///< to others, if nothing else is known of it
    };

    /// Nothing seen yet; `gamma`, the discount, lies in (0, 1).
    /// \throws std::invalid_argument for parameters out of range.
    OptimismScale(double gamma, const OptimismParams& params)
        : gamma_(gamma), log_gamma_(std::log(gamma)), params_(params) {
        params_.validate();
        renew();
    }

    /// A step that did not end the episode brought `reward`; `first`: the action had never been tried in this state.
    void observe_step(double reward, bool first) {
        collect(reward);
        if (reward > 0.0) income_ = true;
        if (reward < 0.0) unit_ = std::min(unit_, -reward);
        if (first) {
            ++first_tries_;
            first_tries_cost_ += std::fabs(reward);
            if (reward < 0.0) ++costly_first_tries_;
            if (!mode_known_ && reward != 0.0) renew();
        }
        if (income_ && !told_ && collected_ > top_) {
            top_ = collected_;
            goal_known_ = true;
        }
    }

    /// A step ended the episode with `reward`, at a goal or not.
    void observe_end(double reward, bool goal) {
        collect(reward);
        if (!goal) return;
        if (!told_) top_ = std::max(top_, income_ ? std::max(reward, collected_) : reward);
        goal_known_ = true;
        note_cost(cost_of(return_, 1e-300));
        begin_episode();
    }

    /// Goals were told: the best is worth 1, or 0 where steps cost. What was discovered is put aside.
    void told_goals() {
        if (!told_) {
            discovered_top_ = top_;
            discovered_goal_ = goal_known_;
        }
        told_ = true;
        top_ = costs_ ? 0.0 : 1.0;
        goal_known_ = true;
        noted_ = 0;
        renew();
    }

    /// The goals told hold no longer.
    void discover_goals() {
        if (!told_) return;
        told_ = false;
        top_ = discovered_top_;
        goal_known_ = discovered_goal_;
        noted_ = 0;
        renew();
    }

    /// An episode begins: its cost and its income count from here.
    void begin_episode() noexcept {
        return_ = 0.0;
        discount_ = 1.0;
        collected_ = 0.0;
    }

    /// An episode ended, or was cut.
    void end_episode() {
        begin_episode();
        renew();
    }

    /// Whether an end of an episode with this reward is a goal: one that pays, or any where steps cost.
    [[nodiscard]] bool counts_as_goal(double terminal_reward) const noexcept {
        return costs_ || terminal_reward > 0.0;
    }

    /// Whether it is known what there is to be had: an episode ended at a goal, a step brought income, or goals were
    /// told.
    [[nodiscard]] bool goal_known() const noexcept { return goal_known_; }
    /// Whether steps have costs; else only discounting does.
    [[nodiscard]] bool costs() const noexcept { return costs_; }
    /// The value that a step costs; infinite while no step brought a negative reward.
    [[nodiscard]] double unit() const noexcept { return unit_; }
    /// The best there is: see above.
    [[nodiscard]] double top() const noexcept { return top_; }

    /// The median cost of the last episodes that reached a goal, in steps; 0 before.
    [[nodiscard]] double typical_cost() const noexcept { return median_; }

    /// c: how far the goal is believed to be from an untried action, in steps.
    [[nodiscard]] double optimism() const noexcept { return c_; }

    /// The value of one step.
    [[nodiscard]] double step_value() const noexcept {
        return costs_ ? unit_ : (1.0 - gamma_) * (goal_known_ ? top_ : 1.0);
    }

    /// The value of being c steps away from the goal.
    [[nodiscard]] double at_cost(double c) const noexcept {
        return costs_ ? top_ - c * unit_ : top_ * std::exp(c * log_gamma_);
    }

    /// How many steps away from the goal a value is; values below least * top count as that much.
    [[nodiscard]] double cost_of(double value, double least = 1e-6) const noexcept {
        if (costs_) return (top_ - value) / unit_;
        return std::log(std::max(value, least * top_) / top_) / log_gamma_;
    }

    /// What untried actions are worth in a state whose shortest known path to a goal is `path` steps long; infinite
    /// where none is known.
    [[nodiscard]] Level level(double path) const noexcept {
        if (!goal_known_) return costs_ ? Level{0.0, 0.0} : Level{1.0, 1.0};
        const double most = params_.limit / (1.0 - gamma_);
        double far = costs_ ? std::min(median_, most) : median_;  // no path: as far as usual
        if (path < std::numeric_limits<double>::infinity()) {
            far = costs_ ? (1.0 - std::exp(path * log_gamma_)) / (1.0 - gamma_) : path;
        }
        const double c = std::max(c_, far - params_.saving);
        return {at_cost(c), at_cost(c + params_.gap)};
    }

    /// How much smaller differences of value are `path` steps from the goal than near it: discounting flattens them
    /// beyond the horizon of 1 / (1 - gamma) steps. In (0, 1].
    [[nodiscard]] double reach(double path) const noexcept {
        const double beyond = path - 1.0 / (1.0 - gamma_);
        return beyond > 0.0 && goal_known_ ? std::exp(std::max(-600.0, beyond * log_gamma_)) : 1.0;
    }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive) {
        archive(unit_, top_, return_, discount_, collected_, first_tries_cost_, costs_of_episodes_, median_, c_, costs_,
                mode_known_, income_, goal_known_, told_, discovered_top_, discovered_goal_);
        archive.size(first_tries_);
        archive.size(costly_first_tries_);
        archive.size(noted_);
        for (const double cost : costs_of_episodes_) archive.require(cost == cost, "an episode's cost is no number");
    }

    void collect(double reward) noexcept {
        return_ += discount_ * reward;
        discount_ *= gamma_;
        collected_ = gamma_ * collected_ + std::max(reward, 0.0);
    }

    void note_cost(double cost) {
        costs_of_episodes_[noted_ % window] = cost;
        ++noted_;
    }

    void renew() {
        costs_ = 2 * costly_first_tries_ > first_tries_ || (costs_ && 2 * costly_first_tries_ == first_tries_);
        mode_known_ = first_tries_ != 0 && first_tries_cost_ != 0.0;
        const std::size_t n = std::min<std::size_t>(noted_, window);
        std::array<double, window> sorted = costs_of_episodes_;
        std::sort(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(n));
        median_ = n == 0 ? 0.0 : sorted[n / 2];
        c_ = std::min(std::max(params_.fraction * median_, params_.least), params_.most);
        // Trying an unknown action may cost more than a plain step.
        if (costs_) c_ *= std::max(1.0, first_tries_cost_ / static_cast<double>(first_tries_) / unit_);
        c_ = std::min(c_, params_.limit / (1.0 - gamma_));
    }

    double gamma_;
    double log_gamma_;
    OptimismParams params_;
    double unit_ = std::numeric_limits<double>::infinity();
    double top_ = -std::numeric_limits<double>::infinity();
    double return_ = 0.0;     // discounted, of the running episode
    double discount_ = 1.0;
    double collected_ = 0.0;  // positive rewards, discounted backwards
    double first_tries_cost_ = 0.0;
    std::size_t first_tries_ = 0;
    std::size_t costly_first_tries_ = 0;
    std::array<double, window> costs_of_episodes_{};
    std::size_t noted_ = 0;
    double median_ = 0.0;
    double c_ = 0.0;
    bool costs_ = false;
    bool mode_known_ = false;
    bool income_ = false;
    bool goal_known_ = false;
    bool told_ = false;
    double discovered_top_ = 0.0;
    bool discovered_goal_ = false;
};

}  // namespace sspql
