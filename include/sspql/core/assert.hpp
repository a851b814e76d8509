// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// SSPQL_ASSERT(condition, "message"): the check of hot paths.
///
/// On in debug builds (no NDEBUG), in sanitizer builds, and wherever SSPQL_ENABLE_ASSERTIONS is defined as 1;
/// off elsewhere, where it costs nothing and the condition is not evaluated. Define SSPQL_ASSERT before the first
/// include to send failures elsewhere. Borders that a user's data crosses throw instead (errors.hpp).

#if !defined(SSPQL_ENABLE_ASSERTIONS)
#if !defined(NDEBUG) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
/// 1: failed assertions print and abort. 0: they cost nothing. Define it to choose. \ingroup core
#define SSPQL_ENABLE_ASSERTIONS 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define SSPQL_ENABLE_ASSERTIONS 1
#endif
#endif
#endif

#if !defined(SSPQL_ENABLE_ASSERTIONS)
#define SSPQL_ENABLE_ASSERTIONS 0
#endif

#if !defined(SSPQL_ASSERT)
#if SSPQL_ENABLE_ASSERTIONS
#include <cstdio>
#include <cstdlib>
namespace sspql::detail {
[[noreturn]] inline void assertion_failed(const char* condition, const char* message, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: sspql assertion failed: %s (%s)\n", file, line, message, condition);
    std::abort();
}
}  // namespace sspql::detail
/// Prints file, line, message and condition to stderr and aborts if the condition is false, where
/// SSPQL_ENABLE_ASSERTIONS; else `condition` is not evaluated. \ingroup core
#define SSPQL_ASSERT(condition, message) \
    ((condition) ? static_cast<void>(0)  \
                 : ::sspql::detail::assertion_failed(#condition, message, __FILE__, __LINE__))
#else
#define SSPQL_ASSERT(condition, message) static_cast<void>(0)
#endif
#endif
