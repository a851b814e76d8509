// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/model/cells.hpp>
#include <sspql/model/transition_counts.hpp>

namespace sspql {

/// When AdaptiveSspql believes that an action's outcomes have changed. The defaults were chosen once, for all tasks.
struct ChangeParams {
    double drift = 0.5;         ///< surprise that is forgiven each time
    double threshold = 2.0;     ///< the least score that raises an alarm: the floor that keeps noise from doing so
    double log_offset = 3.5;    ///< with many (s,a) the threshold is ln(tried pairs) less this
    double fast = 0.7;          ///< the fast counts, kept after an alarm, forget with this factor a try
    double kept = 1.0;          ///< observations that are left after an alarm
    double least_count = 0.02;  ///< outcomes of which less is left are dropped

    template <class Archive>
    void serialize(Archive& archive) {
        archive(drift, threshold, log_offset, fast, kept, least_count);
    }

    /// Checks every number. \throws std::invalid_argument naming the first number out of range.
    void validate() const {
        require_in("change.drift", drift, 0.0, 100.0);
        require_in("change.threshold", threshold, 0.0, 1e9);
        require_in("change.log_offset", log_offset, -100.0, 100.0);
        require_in("change.fast", fast, 0.0, 1.0);
        require_in("change.kept", kept, 0.1, 1e6);
        require_in("change.least_count", least_count, 0.0, 0.09);
    }
};

/// Notices, for each (s,a) by itself, that the world is no longer as it was: a cumulative sum of how much more surprising
/// the outcomes are than this (s,a)'s outcomes usually are. An outcome seen n times, where the most frequent one was seen
/// m times, surprises by ln((m + 1/2) / (n + 1/2)); what the counts themselves lead to expect of that is subtracted, so
/// that a noisy action is allowed its noise. Memory 8 bytes an (s,a); a call is O(outcomes).
class ChangeDetector {
public:
    /// Nothing seen yet. \throws std::invalid_argument for parameters out of range.
    ChangeDetector(std::size_t states, std::size_t actions, const ChangeParams& params)
        : actions_(actions), params_(params), score_(states * actions, 0.0f), fast_total_(states * actions, 0.0f) {
        params_.validate();
    }

    /// More states, with score 0.
    void grow(std::size_t states) {
        if (states * actions_ <= score_.size()) return;
        score_.resize(states * actions_, 0.0f);
        fast_total_.resize(states * actions_, 0.0f);
    }
    /// Room for that many states.
    void reserve(std::size_t states) {
        score_.reserve(states * actions_);
        fast_total_.reserve(states * actions_);
    }

    /// How likely the counts so far made the outcome `next` of (s,a), and how much of a surprise that was.
    struct Surprise {
        double likelihood = 0.0;   ///< the probability of the outcome by the counts so far
        double score = 0.0;        ///< of (s,a), this outcome included, >= 0
        std::size_t outcomes = 0;  ///< looked at
    };

    /// Call before the outcome is recorded; (s,a) has outcomes.
    Surprise judge(const TransitionCounts<FadingCell>& counts, StateId s, ActionId a, StateId next) {
        const double total = counts.n(s, a);
        double seen = 0.0;
        double most = 0.0;
        Surprise result;
        counts.for_each_successor(s, [&](const auto& successor) {
            const double n = successor.n(a);
            most = std::max(most, n);
            if (successor.state() == next) seen = n;
            ++result.outcomes;
        });
        double usual = 0.0;
        counts.for_each_successor(s, [&](const auto& successor) {
            const double n = successor.n(a);
            if (n > 0.0 && n < most) usual += n / total * std::log((most + 0.5) / (n + 0.5));
        });
        const std::size_t at = index(s) * actions_ + index(a);
        const double surprise = std::log((most + 0.5) / (seen + 0.5)) - usual - params_.drift;
        score_[at] = static_cast<float>(std::max(0.0, static_cast<double>(score_[at]) + surprise));
        result.likelihood = seen / total;
        result.score = static_cast<double>(score_[at]);
        return result;
    }

    /// Call after the outcome is recorded: the fast counts forget a little and take it in.
    void follow(TransitionCounts<FadingCell>& counts, StateId s, ActionId a, StateId next) {
        const auto fast = static_cast<float>(params_.fast);
        counts.for_each_cell(s, a, [&](StateId to, FadingCell& cell) {
            cell.fast *= fast;
            if (to == next) cell.fast += 1.0f;
        });
        float& total = fast_total_[index(s) * actions_ + index(a)];
        total = total * fast + 1.0f;
    }

    /// Whether the score of (s,a) is too high for chance, `tried_pairs` (s,a) having been tried in all.
    [[nodiscard]] bool alarmed(StateId s, ActionId a, std::size_t tried_pairs) const noexcept {
        const double score = static_cast<double>(score_[index(s) * actions_ + index(a)]);
        return score > params_.threshold &&
               score > std::log(static_cast<double>(tried_pairs)) - params_.log_offset;
    }

    /// After an alarm: of the past only the fast counts stay, as `kept` observations; mean rewards stay.
    void reset(TransitionCounts<FadingCell>& counts, StateId s, ActionId a) {
        const std::size_t at = index(s) * actions_ + index(a);
        score_[at] = 0.0f;
        const double scale = params_.kept / static_cast<double>(fast_total_[at]);
        counts.for_each_cell(s, a, [&](StateId, FadingCell& cell) {
            const double mean = cell.mean_reward();
            cell.n = static_cast<double>(cell.fast) * scale;
            cell.reward_sum = cell.n * mean;
        });
        counts.fade(s, a, 1.0, params_.least_count);
        ++alarms_;
    }

    /// Nothing is known of (s,a) any more.
    void forget(StateId s, ActionId a) noexcept {
        score_[index(s) * actions_ + index(a)] = 0.0f;
        fast_total_[index(s) * actions_ + index(a)] = 0.0f;
    }

    /// How much of a surprise has added up for (s,a), >= 0.
    [[nodiscard]] double score(StateId s, ActionId a) const noexcept {
        return static_cast<double>(score_[index(s) * actions_ + index(a)]);
    }

    /// Alarms raised so far.
    [[nodiscard]] std::uint64_t alarms() const noexcept { return alarms_; }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive) {
        archive.fixed(score_);
        archive.fixed(fast_total_);
        archive(alarms_);
    }

    std::size_t actions_;
    ChangeParams params_;
    std::vector<float> score_;
    std::vector<float> fast_total_;
    std::uint64_t alarms_ = 0;
};

}  // namespace sspql
