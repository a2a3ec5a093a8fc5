// SPDX-License-Identifier: MIT
//
// In the team's process: the calls in the team's library that were active at a crash, innermost
// first.
#pragma once

#include <array>
#include <cstdint>

namespace mirocup::plugins {

inline constexpr std::size_t max_trace = 24;

// Addresses are relative to the place where the library is loaded. The address of a calling
// function is inside its call instruction.
struct CrashTrace {
  std::uint32_t count = 0;
  std::array<std::uint64_t, max_trace> address;
};

// Fills `trace` with the active calls in the library that was loaded from `path`. A signal handler
// may call this function, because it allocates nothing and takes no lock. But it walks a stack that
// the crash may have damaged, so it may itself crash or never return. The caller must be ready for
// both cases.
void trace_calls(const char* path, CrashTrace& trace);

}  // namespace mirocup::plugins
