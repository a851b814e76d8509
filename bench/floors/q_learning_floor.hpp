// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <sspql/core/random.hpp>

#include "grid_task.hpp"

namespace sspql::floors {

/// Q-learning: the update, then the best action by Q plus uniform noise.
class QLearning {
public:
    QLearning(std::size_t states, double alpha, double gamma, double noise, std::uint64_t seed)
        : q_(states), alpha_(alpha), gamma_(gamma), noise_(noise), random_(seed, RandomStream::learner) {}

    std::uint32_t begin(std::uint32_t s) {
        state_ = s;
        return action_ = choose();
    }

    std::uint32_t step(double reward, std::uint32_t next) {
        double& q = q_[state_ * actions + action_];
        q += alpha_ * (reward + gamma_ * q_.max(next) - q);
        state_ = next;
        return action_ = choose();
    }

    [[nodiscard]] const Values& q() const { return q_; }

private:
    std::uint32_t choose() {
        std::uint32_t best = 0;
        double best_score = q_[state_ * actions] + noise_ * random_.uniform();
        for (std::uint32_t a = 1; a < actions; ++a) {
            const double score = q_[state_ * actions + a] + noise_ * random_.uniform();
            if (score > best_score) {
                best = a;
                best_score = score;
            }
        }
        return best;
    }

    Values q_;
    double alpha_;
    double gamma_;
    double noise_;
    Random random_;
    std::uint32_t state_ = 0;
    std::uint32_t action_ = 0;
};

}  // namespace sspql::floors
