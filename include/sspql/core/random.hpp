// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <sspql/core/assert.hpp>
#include <sspql/core/serialization.hpp>

namespace sspql {

/// Roles that draw random numbers. A stream each: all learners that share a seed meet the same world.
enum class RandomStream : std::uint64_t { environment = 1, learner = 2, noise = 3 };

/// Seeded random numbers: the engine xoshiro256** (Blackman and Vigna 2018), state filled by splitmix64, and draws of
/// our own, because the standard library's distributions differ between implementations.
///
/// The same (seed, stream) gives the same sequence on every compiler and standard library. No global state, no clock:
/// copy the object to fork a sequence, compare `state()` to compare positions. Every draw is O(1) (rejection: expected)
/// and never allocates. Not for cryptography. One object per thread.
///
/// Never take two draws in one argument list: C++ leaves their order open.
class Random {
public:
    /// The engine's 256 bits.
    using State = std::array<std::uint64_t, 4>;

    /// Starts the sequence of this seed and stream; any two numbers will do, 0 and 0 too.
    explicit Random(std::uint64_t seed, std::uint64_t stream = 0) noexcept {
        std::uint64_t x = seed;
        const std::uint64_t a = splitmix(x);
        std::uint64_t y = stream ^ 0x6A09E667F3BCC909ull;
        std::uint64_t z = a ^ splitmix(y);
        for (auto& word : state_) word = splitmix(z);
    }

    /// Starts the sequence of a role.
    Random(std::uint64_t seed, RandomStream stream) noexcept : Random(seed, static_cast<std::uint64_t>(stream)) {}

    /// Goes on where another object's `state()` was taken. All zeros is no state of the engine and is refused by
    /// assertion.
    [[nodiscard]] static Random from_state(const State& state) noexcept {
        SSPQL_ASSERT((state[0] | state[1] | state[2] | state[3]) != 0, "an all-zero state never leaves zero");
        Random random(0);
        random.state_ = state;
        return random;
    }

    /// Where the sequence is; `from_state` goes on from there.
    [[nodiscard]] const State& state() const noexcept { return state_; }

    /// 64 random bits.
    [[gnu::always_inline]] std::uint64_t bits() noexcept {
        const std::uint64_t result = rotate(state_[1] * 5, 7) * 9;
        const std::uint64_t t = state_[1] << 17;
        state_[2] ^= state_[0];
        state_[3] ^= state_[1];
        state_[1] ^= state_[2];
        state_[0] ^= state_[3];
        state_[2] ^= t;
        state_[3] = rotate(state_[3], 45);
        return result;
    }

    /// Uniform in [0, 1): a multiple of 2^-53.
    [[gnu::always_inline]] double uniform() noexcept { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

    /// Uniform in [low, high); low itself if both are equal.
    double uniform(double low, double high) noexcept {
        const double value = low + (high - low) * uniform();
        return value >= high && low < high ? low : value;  // rounding can reach high
    }

    /// True with probability p (never for p <= 0, always for p >= 1).
    bool chance(double p) noexcept { return uniform() < p; }

    /// Uniform on 0 .. n-1, without bias (Lemire 2019). Precondition: n > 0.
    [[gnu::always_inline]] std::size_t below(std::size_t n) noexcept {
        SSPQL_ASSERT(n > 0, "a draw needs at least one value");
        const auto range = static_cast<std::uint64_t>(n);
        std::uint64_t low = 0;
        std::uint64_t high = multiply(bits(), range, low);
        if (low < range) {
            const std::uint64_t threshold = (0 - range) % range;
            while (low < threshold) high = multiply(bits(), range, low);
        }
        return static_cast<std::size_t>(high);
    }

    /// Standard normal by the ratio of uniforms with Leva's bounds (ACM TOMS 18, 1992). The value is a quotient of two
    /// uniforms; the logarithm only decides about acceptance, and in 1 % of the draws, so that the sequence does not
    /// depend on the last bit of anybody's `log`.
    double normal() noexcept {
        for (;;) {
            const double u = 1.0 - uniform();  // (0, 1]: never a division by zero
            const double v = 1.7156 * (uniform() - 0.5);
            const double x = u - 0.449871;
            const double y = std::fabs(v) + 0.386595;
            const double q = x * x + y * (0.19600 * y - 0.25472 * x);
            if (q < 0.27597) return v / u;
            if (q > 0.27846) continue;
            if (v * v <= -4.0 * u * u * std::log(u)) return v / u;
        }
    }

    /// Normal with the given mean and standard deviation (>= 0).
    double normal(double mean, double deviation) noexcept { return mean + deviation * normal(); }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive) {
        archive(state_);
        archive.require((state_[0] | state_[1] | state_[2] | state_[3]) != 0, "the random generator is all zeros");
    }

    static std::uint64_t rotate(std::uint64_t x, int k) noexcept { return (x << k) | (x >> (64 - k)); }

    static std::uint64_t splitmix(std::uint64_t& x) noexcept {
        x += 0x9E3779B97F4A7C15ull;
        std::uint64_t z = x;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
        return z ^ (z >> 31);
    }

    /// The 128-bit product of a and b in two halves; by hand where the compiler has no such type.
    static std::uint64_t multiply(std::uint64_t a, std::uint64_t b, std::uint64_t& low) noexcept {
#if defined(__SIZEOF_INT128__)
        __extension__ using Product = unsigned __int128;
        const Product product = static_cast<Product>(a) * b;
        low = static_cast<std::uint64_t>(product);
        return static_cast<std::uint64_t>(product >> 64);
#else
        const std::uint64_t a0 = a & 0xFFFFFFFFu;
        const std::uint64_t a1 = a >> 32;
        const std::uint64_t b0 = b & 0xFFFFFFFFu;
        const std::uint64_t b1 = b >> 32;
        const std::uint64_t p00 = a0 * b0;
        const std::uint64_t p01 = a0 * b1;
        const std::uint64_t p10 = a1 * b0;
        const std::uint64_t middle = (p00 >> 32) + (p01 & 0xFFFFFFFFu) + (p10 & 0xFFFFFFFFu);
        low = (middle << 32) | (p00 & 0xFFFFFFFFu);
        return a1 * b1 + (p01 >> 32) + (p10 >> 32) + (middle >> 32);
#endif
    }

    State state_{};
};

}  // namespace sspql
