// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>

#include <sspql/core/assert.hpp>
#include <sspql/core/serialization.hpp>

/// \file
/// Cells: what TransitionCounts keeps about one observed (s, a, s'). A cell is trivially copyable, all zero when new,
/// and answers
///
///     using Number                the type of N(s,a,s') and N(s,a)
///     Number count() const        N(s,a,s'); 0 = never observed
///     bool terminal() const       whether the last observation ended the episode
///     bool full() const           the next observation would overflow: TransitionCounts halves the (s,a) first
///     void add(reward, terminal)  one more observation
///     void halve()                about half the count, at least 1 if it was at least 1

namespace sspql {

/// Integer counts, 4 bytes: 31 bits of N(s,a,s') and the terminal flag. When a count reaches Limit, all counts of its
/// (s,a) are halved (rounding up, so that nothing observed is forgotten): probabilities survive, nothing ever wraps.
/// Rewards are not kept.
template <std::uint32_t Limit = 0x7FFFFFFFu>
class BasicCountCell {
    static_assert(Limit >= 2 && Limit <= 0x7FFFFFFFu, "sspql: a count has 31 bits");

public:
    /// The type of counts.
    using Number = std::uint32_t;
    /// Whether rewards are kept: no.
    static constexpr bool keeps_rewards = false;
    /// The largest count.
    static constexpr Number limit = Limit;
    static constexpr const char* type_name = "count";  ///< in checkpoints

    /// N(s,a,s'), 0 to Limit.
    [[nodiscard]] Number count() const noexcept { return bits_ & 0x7FFFFFFFu; }
    /// Whether the last observation ended the episode.
    [[nodiscard]] bool terminal() const noexcept { return (bits_ >> 31) != 0; }
    /// Whether the count is at its limit.
    [[nodiscard]] bool full() const noexcept { return count() >= Limit; }

    /// One more observation; the reward is not kept. Precondition (asserted): not full.
    void add(double /*reward*/, bool terminal) noexcept {
        SSPQL_ASSERT(!full(), "halve before adding to a full cell");
        bits_ = (count() + 1u) | (terminal ? 0x80000000u : 0u);
    }

    /// Half the count, rounded up; the flag stays.
    void halve() noexcept { bits_ = (bits_ & 0x80000000u) | ((count() + 1u) / 2u); }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive) {
        archive(bits_);
        archive.require(count() <= Limit, "a count is above its limit");
    }

    std::uint32_t bits_ = 0;
};

/// The cell of most learners: integers, halved when one reaches 2^31 - 1.
using CountCell = BasicCountCell<>;

/// Fractional counts that can fade, 24 bytes: n = N(s,a,s'), the sum of the rewards seen (both scaled together, so the
/// mean reward survives fading), a fast count for detecting change, and the terminal flag.
struct FadingCell {
    /// The type of counts.
    using Number = double;
    /// Whether rewards are kept: yes, as their sum.
    static constexpr bool keeps_rewards = true;
    static constexpr const char* type_name = "fading";  ///< in checkpoints

    double n = 0.0;           ///< N(s,a,s') as far as it has not faded, >= 0
    double reward_sum = 0.0;  ///< sum of the rewards seen, faded as n is
    float fast = 0.0f;        ///< count for detecting change, kept by whoever wants it; add() leaves it alone
    bool ended = false;       ///< whether the last observation ended the episode

    /// N(s,a,s') as far as it has not faded.
    [[nodiscard]] Number count() const noexcept { return n; }
    /// Whether the last observation ended the episode.
    [[nodiscard]] bool terminal() const noexcept { return ended; }
    /// The mean of the rewards seen; 0 for none.
    [[nodiscard]] double mean_reward() const noexcept { return n > 0.0 ? reward_sum / n : 0.0; }

    /// From 2^53 on, adding one changes nothing any more.
    [[nodiscard]] bool full() const noexcept { return n >= 9007199254740992.0; }

    /// One more observation, of weight 1.
    void add(double reward, bool terminal) noexcept {
        n += 1.0;
        reward_sum += reward;
        ended = terminal;
    }

    /// Half of count and reward sum.
    void halve() noexcept { scale(0.5); }

    /// Multiplies count and reward sum; the mean reward stays.
    void scale(double factor) noexcept {
        n *= factor;
        reward_sum *= factor;
    }

    template <class Archive>
    void serialize(Archive& archive) {
        archive(n, reward_sum, fast, ended);
        archive.require(n >= 0.0 && n <= 9007199254740992.0 && fast >= 0.0f && fast <= 1e9f, "a count is out of range");
    }
};

}  // namespace sspql
