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
#include <sspql/learn/adaptive/change_detector.hpp>
#include <sspql/learn/transition.hpp>
#include <sspql/model/cells.hpp>
#include <sspql/model/transition_counts.hpp>

namespace sspql {

/// How far AdaptiveSspql trusts what it has counted. The defaults were chosen once, for all tasks.
struct TrustParams {
    double cap = 50.0;          ///< at most so many observations of an (s,a) count, older ones fade; 0: all count
    double kappa_noise = 0.4;   ///< the optimistic pseudo-count of every (s,a), as a multiple of the noise seen
    double kappa_least = 0.01;  ///< ... and at least this
    double kappa_few = 0.5;     ///< ... and, once a goal is known, times 1 + this / sqrt(N): few outcomes say less
    /// > 0: an (s,a) not tried for a while is in doubt again, by half of its counts after 0.7 tau times the number of
    /// (s,a) tried. For worlds where shortcuts open; costs 8 bytes an (s,a), and tries that find nothing new.
    double tau = 0.0;

    template <class Archive>
    void serialize(Archive& archive) {
        archive(cap, kappa_noise, kappa_least, kappa_few, tau);
    }

    /// Checks every number. \throws std::invalid_argument naming the first number out of range.
    void validate() const {
        if (cap != 0.0) require_in("trust.cap", cap, 1.0, 1e9);
        require_in("trust.kappa_noise", kappa_noise, 0.0, 1e6);
        require_in("trust.kappa_least", kappa_least, 1e-9, 1e6);
        require_in("trust.kappa_few", kappa_few, 0.0, 1e6);
        require_in("trust.tau", tau, 0.0, 1e12);
    }
};

/// What AdaptiveSspql has seen of the world: fading counts with rewards, a change detector per (s,a), and how noisy
/// outcomes are. observe is O(out-degree) and allocates only when the counts do.
class ForgettingModel {
public:
    /// The counts: they fade and keep rewards.
    using Counts = TransitionCounts<FadingCell>;

    /// Nothing seen yet. \throws std::invalid_argument for parameters out of range.
    ForgettingModel(std::size_t states, std::size_t actions, const TrustParams& trust, const ChangeParams& change)
        : counts_(states, actions),
          detector_(states, actions, change),
          trust_(trust),
          least_count_(change.least_count),
          kappa_(trust.kappa_least) {
        trust_.validate();
        grow(states);
    }

    /// More states, never seen.
    void grow(std::size_t states) {
        counts_.grow(states);
        detector_.grow(states);
        if (trust_.tau > 0.0 && last_try_.size() < states * counts_.actions()) {
            last_try_.resize(states * counts_.actions(), 0);
        }
    }

    /// Room for that many states and distinct (s,s').
    void reserve(std::size_t states, std::size_t pairs) {
        counts_.reserve(states, pairs);
        detector_.reserve(states);
        if (trust_.tau > 0.0) last_try_.reserve(states * counts_.actions());
    }

    /// Takes a step in. \returns whether its (s,a) was tried for the first time.
    bool observe(const Transition& t) {
        const StateId s = t.state;
        const ActionId a = t.action;
        const double n = counts_.n(s, a);
        const bool first = !(n > 0.0);
        ++steps_;
        if (first) {
            ++pairs_tried_;
        } else {
            follow_noise(n, detector_.judge(counts_, s, a, t.next).likelihood);
            if (trust_.cap > 0.0 && n >= trust_.cap) counts_.fade(s, a, trust_.cap / (n + 1.0), least_count_);
        }
        counts_.record(s, a, t.next, t.terminated, t.reward, t.weight);
        detector_.follow(counts_, s, a, t.next);
        if (detector_.alarmed(s, a, pairs_tried_)) detector_.reset(counts_, s, a);
        if (trust_.tau > 0.0) last_try_[index(s) * counts_.actions() + index(a)] = steps_;
        return first;
    }

    /// Whether (s,a) was tried, and not all of it has faded.
    [[nodiscard]] bool tried(StateId s, ActionId a) const noexcept { return counts_.n(s, a) > 0.0; }

    /// The optimistic pseudo-count of (s,a), tried at least once: it grows with the noise of outcomes, is larger where only
    /// few were seen (the only one may have been the exception, and what looks useless is not tried again) and, if
    /// tau > 0, grows with the time since the last try: kappa (1 + few / sqrt(N)) + N (1 - e^{-age / (tau pairs)}).
    [[nodiscard]] double kappa(StateId s, ActionId a) const noexcept {
        const double n = counts_.n(s, a);
        const double kappa = kappa_ * (1.0 + few_ / std::sqrt(std::max(1.0, n)));
        if (trust_.tau == 0.0) return kappa;
        const std::size_t at = index(s) * counts_.actions() + index(a);
        const double age = static_cast<double>(steps_ - last_try_[at]);
        return kappa - n * std::expm1(-age / (trust_.tau * static_cast<double>(pairs_tried_)));
    }

    /// From now on few outcomes say less than their number. Before a goal is known that would only slow the search down.
    void doubt_few() noexcept { few_ = trust_.kappa_few; }

    /// The same for many outcomes, whatever the age of the last try.
    [[nodiscard]] double kappa() const noexcept { return kappa_; }

    /// How often an outcome is another than the counts lead to expect, in [0, 1].
    [[nodiscard]] double noise() const noexcept { return noise_; }

    /// How many (s,a) were tried.
    [[nodiscard]] std::size_t pairs_tried() const noexcept { return pairs_tried_; }
    /// How many steps were taken in.
    [[nodiscard]] std::uint64_t steps() const noexcept { return steps_; }
    /// What notices changes of the world.
    [[nodiscard]] const ChangeDetector& detector() const noexcept { return detector_; }
    /// What was counted.
    [[nodiscard]] const Counts& counts() const noexcept { return counts_; }
    /// The same, for whoever keeps labels and dirty states there: GoalDistances.
    [[nodiscard]] Counts& counts() noexcept { return counts_; }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive) {
        archive(counts_, detector_, kappa_, few_, noise_, noise_weight_, steps_);
        archive.size(pairs_tried_);
        archive.fixed(last_try_);
        archive.require(kappa_ > 0.0 && kappa_ <= 1e12, "a pseudo-count is out of range");
        for (const std::uint64_t time : last_try_) archive.require(time <= steps_, "something was tried in the future");
    }

    /// A running mean over all (s,a); what was tried less than three times says less.
    void follow_noise(double n, double likelihood) {
        const double weight = std::min(1.0, n / 3.0);
        noise_ += weight * (1.0 - likelihood - noise_) * std::max(0.002, 1.0 / (1.0 + noise_weight_));
        noise_weight_ += weight;
        kappa_ = std::max(trust_.kappa_least, trust_.kappa_noise * noise_);
    }

    Counts counts_;
    ChangeDetector detector_;
    TrustParams trust_;
    double least_count_;
    double kappa_;
    double few_ = 0.0;
    double noise_ = 0.0;
    double noise_weight_ = 0.0;
    std::size_t pairs_tried_ = 0;
    std::uint64_t steps_ = 0;
    std::vector<std::uint64_t> last_try_;  // if tau > 0
};

}  // namespace sspql
