// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <sspql/core/random.hpp>

#include "grid_task.hpp"

namespace sspql::floors {

/// Dyna-Q: the update, then planning steps, each an outcome of a tried (s,a) drawn from the counts and the update with
/// it.
class DynaQ {
public:
    DynaQ(std::size_t states, double alpha, double gamma, std::uint64_t seed)
        : q_(states), model_(states * actions), alpha_(alpha), gamma_(gamma), random_(seed, RandomStream::learner) {}

    void observe(const Step& t, std::size_t planning_steps) {
        const std::uint32_t pair = t.state * actions + t.action;
        if (model_[pair].count == 0) tried_.push_back(pair);
        model_[pair].add(t);
        update(pair, t.reward, t.next, t.terminated);
        for (std::size_t k = 0; k < planning_steps; ++k) plan();
    }

    [[nodiscard]] const Values& q() const { return q_; }

private:
    void plan() {
        const std::uint32_t pair = tried_[random_.below(tried_.size())];
        const Outcomes& outcomes = model_[pair];
        double left = random_.uniform() * outcomes.count;
        const Outcome* drawn = outcomes.seen.data();
        const Outcome* last = drawn + outcomes.size - 1;
        while ((left -= drawn->count) >= 0.0 && drawn != last) ++drawn;
        update(pair, drawn->reward_sum / drawn->count, drawn->next, drawn->terminal);
    }

    void update(std::uint32_t pair, double reward, std::uint32_t next, bool terminal) {
        const double future = terminal ? 0.0 : gamma_ * q_.max(next);
        q_[pair] += alpha_ * (reward + future - q_[pair]);
    }

    Values q_;
    std::vector<Outcomes> model_;
    std::vector<std::uint32_t> tried_;
    double alpha_;
    double gamma_;
    Random random_;
};

}  // namespace sspql::floors
