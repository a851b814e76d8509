// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/learn/backup_queue.hpp>
#include <sspql/learn/model_learner.hpp>

namespace sspql {

/// What the learners share that pass changes of value on to predecessors in order of size: a queue of (s,a), and one
/// backup of the most urgent. For implementers (CRTP): Derived supplies learn(t) and sweeps(u, b), whether (u,b) may be
/// queued; its parameters have a `threshold`, below which changes are not passed on.
template <class Derived, class Policies, class ParamsType>
class SweepingLearner : public ModelLearner<Derived, Policies, ParamsType> {
    using Base = ModelLearner<Derived, Policies, ParamsType>;

public:
    /// Room for `states` states and `pairs` distinct (s,s') in all (0: four a state).
    void reserve(std::size_t states, std::size_t pairs = 0) {
        Base::reserve(states, pairs);
        queue_.reserve(states);
    }

    /// Backups done so far.
    [[nodiscard]] std::uint64_t backups() const noexcept { return backups_; }

protected:
    SweepingLearner(StateCount states, std::size_t actions, ParamsType params, std::uint64_t seed)
        : Base(states, actions, std::move(params), seed), queue_(states.initial(), actions) {}

    template <class Archive>
    void serialize(Archive& archive) {
        Base::serialize(archive);
        archive.section("queue", [&] {
            archive(queue_, backups_);
            queue_.for_each([&](StateId s, ActionId a) {
                archive.require(this->model_.counts().n(s, a) > 0, "what was never tried is queued");
            });
        });
    }

    void add_states(std::size_t n) {
        Base::add_states(n);
        queue_.grow(n);
    }

    void goals_changed(const std::vector<Goal>& goals) {
        queue_.clear();
        Base::goals_changed(goals);
    }

    /// Backs the most urgent (s,a) up; where that moves max_a Q(s,a), every (u,b) that leads to s is raised to
    /// gamma P(s|u,b) times the move. O(degrees x |A| + log n).
    void sweep_one() {
        const BackupQueue::Pair pair = queue_.pop();
        ++backups_;
        const double moved = this->params_.gamma * Base::back_up(pair.state, pair.action);
        if (!(moved > this->params_.threshold)) return;
        const Derived& self = static_cast<const Derived&>(*this);
        const auto& counts = this->model_.counts();
        counts.for_each_edge_into(pair.state, [&](StateId u, const auto& edge) {
            edge.for_each_action([&](ActionId b, const auto& cell) {
                this->model_.count_operation();
                if (cell.terminal() || !self.sweeps(u, b)) return;
                const double priority = moved * cell.count() / (counts.n(u, b) + this->params_.kappa);
                if (priority > this->params_.threshold) queue_.raise(u, b, priority);
            });
        });
    }

    BackupQueue queue_;

private:
    std::uint64_t backups_ = 0;
};

}  // namespace sspql
