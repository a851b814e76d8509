// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
#define SSPQL_HAS_CRC_FOLDING 1
#include <wmmintrin.h>
#else
/// 1 where the compiler can multiply without carries, for checksums; else 0. \ingroup io
#define SSPQL_HAS_CRC_FOLDING 0
#endif

namespace sspql::detail {

/// The polynomial of CRC-32, coefficient of x^31 in the last bit, without x^32.
inline constexpr std::uint32_t crc_polynomial = 0xEDB88320u;

#if SSPQL_HAS_CRC_FOLDING

/// x^n modulo the polynomial, as the folding below multiplies by it: a product of two numbers of which the last bit is
/// the highest power comes out one bit too low, hence the shift.
constexpr std::uint64_t crc_power(int n) noexcept {
    std::uint32_t remainder = 0x80000000u;  // x^0
    for (; n > 0; --n) remainder = (remainder >> 1) ^ ((remainder & 1u) != 0 ? crc_polynomial : 0u);
    return std::uint64_t{remainder} << 1;
}

/// Whether this processor multiplies without carries.
inline bool can_fold_crc() noexcept {
    static const bool can = __builtin_cpu_supports("pclmul") != 0 && __builtin_cpu_supports("sse4.1") != 0;
    return can;
}

/// Replaces the first 16 n bytes of a message (n >= 8) by 16 bytes that have the same remainder, as does then the message.
/// After V. Gopal and others, Fast CRC Computation for Generic Polynomials Using PCLMULQDQ Instruction (2009): a block
/// D bits before another counts x^D times as much, so it can be added there, multiplied by x^D modulo the polynomial.
/// Halves of blocks are multiplied by a power each, and four blocks are under way at a time, as multiplying takes a while.
/// \param crc the remainder of what came before, not yet inverted. O(size), an order of magnitude faster than tables.
[[gnu::target("pclmul,sse4.1")]] inline void fold_crc(std::uint32_t crc, const unsigned char* data, std::size_t blocks,
                                                      unsigned char* sixteen) noexcept {
    const auto load = [](const unsigned char* from) { return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from)); };
    constexpr auto power = [](int n) { return static_cast<long long>(crc_power(n)); };
    constexpr long long far_low = power(512 + 32), far_high = power(512 - 32);
    constexpr long long near_low = power(128 + 32), near_high = power(128 - 32);
    const __m128i by_512 = _mm_set_epi64x(far_high, far_low);
    const __m128i by_128 = _mm_set_epi64x(near_high, near_low);
    // A macro: a lambda would not inherit the target.
#define SSPQL_FOLD(block, power, next) \
    _mm_xor_si128(_mm_xor_si128(_mm_clmulepi64_si128(block, power, 0x00), _mm_clmulepi64_si128(block, power, 0x11)), next)

    __m128i a = _mm_xor_si128(load(data), _mm_cvtsi32_si128(static_cast<int>(crc)));
    __m128i b = load(data + 16);
    __m128i c = load(data + 32);
    __m128i d = load(data + 48);
    for (data += 64, blocks -= 4; blocks >= 4; data += 64, blocks -= 4) {
        a = SSPQL_FOLD(a, by_512, load(data));
        b = SSPQL_FOLD(b, by_512, load(data + 16));
        c = SSPQL_FOLD(c, by_512, load(data + 32));
        d = SSPQL_FOLD(d, by_512, load(data + 48));
    }
    a = SSPQL_FOLD(a, by_128, b);
    a = SSPQL_FOLD(a, by_128, c);
    a = SSPQL_FOLD(a, by_128, d);
    for (; blocks > 0; data += 16, --blocks) a = SSPQL_FOLD(a, by_128, load(data));
#undef SSPQL_FOLD
    _mm_storeu_si128(reinterpret_cast<__m128i*>(sixteen), a);
}

#endif

}  // namespace sspql::detail
