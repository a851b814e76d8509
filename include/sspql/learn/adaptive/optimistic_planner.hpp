// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/core/step_budget.hpp>
#include <sspql/learn/adaptive/forgetting_model.hpp>
#include <sspql/learn/adaptive/optimism_scale.hpp>
#include <sspql/learn/adaptive/told_goals.hpp>
#include <sspql/learn/backup_queue.hpp>
#include <sspql/learn/q_table.hpp>
#include <sspql/learn/taught_learner.hpp>

namespace sspql {

/// The planning half of AdaptiveSspql: values of states and actions that are optimistic about what was not tried, full
/// expected backups, and their order by urgency within a budget of edge touches.
///
///     V(s) = the level `here` of s          no action tried
///            max(B(s), open(s))             some legal action untried: open(s) is what Derived says it is worth to others
///            B(s)                           all tried; B(s) = max_a Q(s,a) over the legal actions tried
///
/// For implementers (CRTP): Derived supplies open_worth(s), and sets the levels.
template <class Derived, class Policies, class ParamsType>
class OptimisticPlanner : public TaughtLearner<Derived, Policies, ParamsType> {
    using Base = TaughtLearner<Derived, Policies, ParamsType>;

public:
    /// The counts it plans on.
    using Counts = ForgettingModel::Counts;

    /// Q(s,a) of what was tried; 0 elsewhere.
    [[nodiscard]] const QTable& q() const noexcept { return q_; }
    /// What was observed, faded.
    [[nodiscard]] const Counts& counts() const noexcept { return model_.counts(); }

    /// Records and edges of the model touched so far, for whatever purpose.
    [[nodiscard]] std::uint64_t model_operations() const noexcept { return operations_; }

protected:
    static constexpr double never = -std::numeric_limits<double>::infinity();

    /// What a state is worth, in one place: a backup reads it for every outcome.
    struct StateValue {
        double value = 0.0;
        double best = never;   // B(s)
        double here = 0.0;     // an untried action's worth to the state itself
        double ahead = 0.0;    // ... and to others, if nothing else is known of it
        double reach = 1.0;    // how much smaller differences of value are here than near the goal
        std::uint16_t tried = 0;
        std::uint16_t open = 0;  // legal actions never tried
        bool seen = false;

        template <class Archive>
        void serialize(Archive& archive) {
            archive(value, best, here, ahead, reach, tried, open, seen);
        }
    };

    template <class Archive>
    void serialize(Archive& archive) {
        Base::serialize(archive);
        archive.section("values", [&] { archive(q_); });
        archive.section("model", [&] { archive(model_); });
        archive.section("beliefs", [&] {
            SerializationAccess::serialize(goals_, archive, Base::states());
            archive.fixed(states_);
            archive(queue_, budget_, operations_, call_ends_, scale_step_);
        });
    }

    OptimisticPlanner(StateCount states, std::size_t actions, ParamsType params, std::uint64_t seed)
        : Base(states, actions, std::move(params), seed),
          model_(states.initial(), actions, this->params_.trust, this->params_.change),
          q_(states.initial(), actions),
          states_(states.initial()),
          queue_(states.initial(), actions),
          budget_(this->params_.budget) {}

    void add_states(std::size_t n) {
        Base::add_states(n);
        model_.grow(n);
        q_.grow(n);
        states_.resize(n);
        queue_.grow(n);
    }

    void reserve_tables(std::size_t states, std::size_t pairs) {
        Base::reserve_visits(states);
        model_.reserve(states, pairs);
        q_.reserve(states);
        states_.reserve(states);
        queue_.reserve(states);
    }

    [[nodiscard]] const StateValue& at(StateId s) const noexcept { return states_[index(s)]; }
    [[nodiscard]] StateValue& at(StateId s) noexcept { return states_[index(s)]; }

    template <class F>
    void for_each_legal(StateId s, F&& f) const {
        const auto& allowed = Base::legal().allowed(s);
        for (std::size_t i = 0; i < Base::actions(); ++i) {
            if (allowed.contains(action_id(i))) f(action_id(i));
        }
    }

    void count_actions(StateId s) {
        StateValue& state = at(s);
        state.tried = 0;
        state.open = 0;
        for_each_legal(s, [&](ActionId a) { ++(model_.tried(s, a) ? state.tried : state.open); });
    }

    void renew_value(StateId s) {
        StateValue& state = at(s);
        if (state.open == 0) {
            state.value = state.best;
        } else if (state.tried == 0) {
            state.value = static_cast<const Derived&>(*this).unseen_worth(s);
        } else {
            state.value = std::max(state.best, static_cast<const Derived&>(*this).open_worth(s));
        }
    }

    /// B(s) and V(s) after Q(s,.) changed.
    void renew_best(StateId s) {
        double best = never;
        for_each_legal(s, [&](ActionId a) {
            if (model_.tried(s, a)) best = std::max(best, q_(s, a));
        });
        at(s).best = best;
        renew_value(s);
    }

    /// Over the outcomes of (s,a): the sum of n (r + gamma v(s')), apart from staying, and n of staying in s.
    struct Sums {
        double value = 0.0;
        double staying = 0.0;
    };

    template <class Value>
    [[nodiscard]] Sums sum_outcomes(StateId s, ActionId a, const Value& value) {
        Sums sums;
        std::size_t outcomes = 0;
        const double gamma = this->params_.gamma;
        model_.counts().for_each_outcome(s, a, [&](StateId next, const FadingCell& cell) {
            ++outcomes;
            if (!goals_.empty()) {
                if (goals_.contains(next)) {
                    sums.value += cell.n * goals_.worth(next);
                    return;
                }
                if (cell.terminal()) {  // a goal of old pays nothing now; a hazard stays one
                    sums.value += std::min(0.0, cell.reward_sum);
                    return;
                }
            }
            sums.value += cell.reward_sum;
            if (cell.terminal()) return;
            if (next == s) {
                sums.staying = cell.n;
            } else {
                sums.value += cell.n * gamma * value(next);
            }
        });
        touch(outcomes);
        return sums;
    }

    /// The expected value of (s,a), tried at least once. That it may lead back to s is solved for exactly: either a is
    /// repeated until it leads elsewhere, or the best other action is taken then, whichever is better.
    [[nodiscard]] double backup(StateId s, ActionId a) {
        const Sums sums = sum_outcomes(s, a, [this](StateId next) { return at(next).value; });
        const double kappa = model_.kappa(s, a);
        const double total = model_.counts().n(s, a) + kappa;
        const double once = (kappa * at(s).here + sums.value) / total;
        if (sums.staying == 0.0) return once;
        const double p = this->params_.gamma * sums.staying / total;
        const double repeated = once / (1.0 - p);
        double other = at(s).open != 0 ? static_cast<const Derived&>(*this).open_worth(s) : never;
        for_each_legal(s, [&](ActionId b) {
            if (b != a && model_.tried(s, b)) other = std::max(other, q_(s, b));
        });
        return repeated >= other ? repeated : once + p * other;
    }

    /// Changes of V(s) up to this are not passed on: a part of what a step is worth there.
    [[nodiscard]] double least_change(StateId s) const noexcept {
        return this->params_.threshold * scale_step_ * at(s).reach;
    }

    /// V(s) was `before`: every (u,b) that leads to s is queued for a backup, if the change matters to it.
    void pass_on(StateId s, double before) {
        const double change = this->params_.gamma * std::fabs(at(s).value - before);
        const double least = least_change(s);
        if (!(change > this->params_.gamma * least) || goals_.contains(s)) return;
        std::size_t edges = 0;
        model_.counts().for_each_edge_into(s, [&](StateId u, const auto& edge) {
            edge.for_each_action([&](ActionId b, const FadingCell& cell) {
                ++edges;
                if (cell.terminal()) return;
                const double priority = change * cell.n / (model_.counts().n(u, b) + model_.kappa());
                if (priority > least) queue_.raise(u, b, priority);
            });
        });
        touch(edges);
    }

    void back_up(StateId s, ActionId a) {
        q_(s, a) = backup(s, a);
        renew_best(s);
    }

    /// From now on sweeps and chores may touch a slice of edges, until the next call by the user.
    void begin_call() noexcept { call_ends_ = operations_ + this->params_.slice; }
    [[nodiscard]] bool call_over() const noexcept { return operations_ >= call_ends_; }

    /// Backups in order of urgency, until the budget or the call's slice is spent.
    void sweep() {
        while (!queue_.empty() && !budget_.exhausted() && !call_over()) {
            const BackupQueue::Pair pair = queue_.pop();
            const double before = at(pair.state).value;
            back_up(pair.state, pair.action);
            pass_on(pair.state, before);
        }
    }

    void touch(std::size_t edges) noexcept {
        operations_ += edges;
        budget_.spend(edges);
    }

    ForgettingModel model_;
    ToldGoals goals_;
    QTable q_;
    std::vector<StateValue> states_;
    BackupQueue queue_;
    StepBudget budget_;
    std::uint64_t operations_ = 0;
    std::uint64_t call_ends_ = 0;
    double scale_step_ = 0.0;  // what a step is worth now
};

}  // namespace sspql
