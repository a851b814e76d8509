// SPDX-License-Identifier: MIT
#pragma once

namespace sspql::detail {

/// Asks for the memory at p to be fetched, soon to be read; nothing where the compiler cannot. p may be any address.
inline void prefetch([[maybe_unused]] const void* p) noexcept {
#if defined(__GNUC__)
    __builtin_prefetch(p);
    __asm__ volatile("");  // without it GCC drops calls of functions that do nothing but prefetch
#endif
}

}  // namespace sspql::detail
