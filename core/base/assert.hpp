// SPDX-License-Identifier: MIT
//
// MIROCUP_ASSERT(condition): a precondition or invariant that only a programming error can break.
//
// In Debug builds a false condition prints file, line and condition to standard error and aborts.
// In Release builds (NDEBUG) the condition is compiled but never evaluated, so it costs nothing and
// must have no side effect. A failure at run time, such as a bad file or a bad command, is not
// asserted: it is an Error or a value (error.hpp).
#pragma once

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <type_traits>

namespace mirocup {

// Prints where and which assertion failed, and aborts. Called by MIROCUP_ASSERT only.
[[noreturn]] inline void assertion_failed(const char* file, int line, const char* condition) {
  std::fprintf(stderr, "%s:%d: assertion failed: %s\n", file, line, condition);
  std::abort();
}

// Make scratch NaN (whole numbers: -1) in Debug builds and with MIROCUP_SPOIL, so that no number of
// the last computation enters the next one unseen. In Release builds they cost nothing.
template <class T>
void spoil_n([[maybe_unused]] T* first, [[maybe_unused]] std::size_t count) {
  static_assert(std::is_trivially_copyable_v<T>);
#if !defined(NDEBUG) || defined(MIROCUP_SPOIL)
  std::memset(static_cast<void*>(first), 0xff, count * sizeof(T));
#endif
}
template <class... T>
void spoil(T&... scratch) {
  (spoil_n(&scratch, 1), ...);
}

}  // namespace mirocup

// A macro, because it needs the text of the condition and must vanish from Release builds.
#ifndef NDEBUG
#define MIROCUP_ASSERT(condition) \
  ((condition) ? static_cast<void>(0) : ::mirocup::assertion_failed(__FILE__, __LINE__, #condition))
#else
#define MIROCUP_ASSERT(condition) static_cast<void>(sizeof((condition) ? 1 : 0))
#endif
