// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

/// \file
/// Replaces operator new of the whole test program to count: include it in one of its files only. What takes its zeros
/// from calloc, as counts do, is not counted and shows in bytes().

namespace sspql_test {

/// Calls of operator new so far.
inline std::atomic<std::size_t> allocations{0};

/// The most bytes that one of them asked for; set it back to 0 to begin anew.
inline std::atomic<std::size_t> largest_allocation{0};

}  // namespace sspql_test

void* operator new(std::size_t bytes) {
    ++sspql_test::allocations;
    std::size_t largest = sspql_test::largest_allocation;
    while (bytes > largest && !sspql_test::largest_allocation.compare_exchange_weak(largest, bytes)) {
    }
    if (void* memory = std::malloc(bytes == 0 ? 1 : bytes)) return memory;
    throw std::bad_alloc();
}
void* operator new[](std::size_t bytes) { return ::operator new(bytes); }
// Not inlined: g++ takes a visible free() of what new returned for a mistake.
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete[](void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
