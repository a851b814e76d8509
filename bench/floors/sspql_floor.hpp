// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <sspql/core/random.hpp>

#include "counts_floor.hpp"
#include "grid_task.hpp"

namespace sspql::floors {

/// A step of SSPQL written by hand for a grid with four actions: records the transition (Counts), updates Q by eq. 1, and
/// chooses by eq. 8, powers tabulated, paths given. Knows nothing of masks, hints, goals, weights or wrong arguments.
class Sspql {
public:
    Sspql(std::size_t states, double alpha, double gamma, double noise, double w_exp, std::uint64_t seed)
        : q_(states),
          counts_(states),
          visits_(states * actions, 0),
          path_action_(states, actions),
          path_value_(states, 0.0),
          alpha_(alpha),
          gamma_(gamma),
          noise_(noise),
          w_exp_(w_exp),
          random_(seed, RandomStream::learner) {
        for (std::size_t n = 0; n < tabulated; ++n) {
            const auto visits = static_cast<double>(n);
            decay_[n] = n <= 1 ? 1.0 : std::pow(visits, -2.0);
            bonus_[n] = n == 0 ? 1.0 : std::pow(visits + 1.0, -1.5);
        }
    }

    /// Q_SSP of s: the value is that of this action, 0 for the others.
    void set_path(std::uint32_t s, std::uint32_t action, double value) {
        path_action_[s] = action;
        path_value_[s] = value;
    }
    void observe(const Step& t) { learn(t); }

    std::uint32_t begin(std::uint32_t s) {
        state_ = s;
        return action_ = choose();
    }

    std::uint32_t step(double reward, std::uint32_t next) {
        learn({state_, action_, reward, next, false});
        state_ = next;
        return action_ = choose();
    }

    [[nodiscard]] std::uint32_t state() const { return state_; }
    [[nodiscard]] const Values& q() const { return q_; }
    [[nodiscard]] Counts& counts() { return counts_; }

private:
    static constexpr std::size_t tabulated = 1024;

    void learn(const Step& t) {
        const std::uint32_t pair = t.state * actions + t.action;
        counts_.record(t.state, t.action, t.next, t.terminated);
        ++visits_[pair];
        const double future = t.terminated ? 0.0 : gamma_ * q_.max(t.next);
        q_[pair] += alpha_ * (t.reward + future - q_[pair]);
    }

    [[nodiscard]] double decay(std::uint32_t n) const {
        return n < tabulated ? decay_[n] : std::pow(static_cast<double>(n), -2.0);
    }
    [[nodiscard]] double bonus(std::uint32_t n) const {
        return n < tabulated ? bonus_[n] : std::pow(static_cast<double>(n) + 1.0, -1.5);
    }

    std::uint32_t choose() {
        std::uint32_t best = 0;
        double best_score = 0.0;
        const std::uint32_t on_path = path_action_[state_];
        for (std::uint32_t a = 0; a < actions; ++a) {
            const std::uint32_t pair = state_ * actions + a;
            double score = q_[pair];
            if (a == on_path) score += decay(visits_[pair]) * path_value_[state_];
            score += w_exp_ * bonus(counts_.n(state_, a));
            score += noise_ * random_.uniform();
            if (a == 0 || score > best_score) {
                best = a;
                best_score = score;
            }
        }
        return best;
    }

    Values q_;
    Counts counts_;
    std::vector<std::uint32_t> visits_;
    std::vector<std::uint32_t> path_action_;
    std::vector<double> path_value_;
    std::array<double, tabulated> decay_{};
    std::array<double, tabulated> bonus_{};
    double alpha_;
    double gamma_;
    double noise_;
    double w_exp_;
    Random random_;
    std::uint32_t state_ = 0;
    std::uint32_t action_ = 0;
};

}  // namespace sspql::floors
