// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/learn/schedule.hpp>

namespace sspql {

/// A trainer's hints (section 2.2 of Kwon, Suh and Lee 2011): "here, this action". A hint adds its strength to the
/// action's score in eq. 8 and fades with the visits of (s,a) since it was given, like w_SSP: a robot that followed it
/// a few times goes by what came of it. No memory until the first hint; then 16 bytes an (s,a). O(1).
class Hints {
public:
    /// No hints, for this many actions.
    explicit Hints(std::size_t actions) : actions_(actions) {}

    /// Whether no hint was given.
    [[nodiscard]] bool empty() const noexcept { return hints_.empty(); }

    /// Replaces the hint for (s,a), visited `visits` times so far. `states` is the number of states there are.
    void set(StateId s, ActionId a, double strength, std::uint32_t visits, std::size_t states) {
        if (hints_.size() < states * actions_) hints_.resize(states * actions_);
        hints_[index(s) * actions_ + index(a)] = {strength, visits};
    }

    /// What is left of the hint for (s,a) after `visits` visits in all; 0 without one.
    [[nodiscard]] double operator()(StateId s, ActionId a, std::uint32_t visits, const Schedule& fading) const noexcept {
        const std::size_t at = index(s) * actions_ + index(a);
        if (at >= hints_.size() || hints_[at].strength == 0.0) return 0.0;
        return hints_[at].strength * fading(visits >= hints_[at].visits ? visits - hints_[at].visits : visits);
    }

    /// Takes all hints back.
    void clear() noexcept { hints_.clear(); }

private:
    friend SerializationAccess;

    struct Hint {
        double strength = 0.0;
        std::uint32_t visits = 0;

        template <class Archive>
        void serialize(Archive& archive) {
            archive(strength, visits);
        }
    };

    template <class Archive>
    void serialize(Archive& archive) {
        archive(hints_);
        archive.require(hints_.size() % actions_ == 0, "hints are incomplete");
    }

    std::size_t actions_;
    std::vector<Hint> hints_;
};

}  // namespace sspql
