// SPDX-License-Identifier: MIT
//
// In the team's process: the places in the team's library that a crash passed, innermost first.
#pragma once

#include <array>
#include <cstdint>

namespace mirocup::plugins {

inline constexpr std::size_t max_trace = 24;

// Addresses as the library's file counts them: 0 is where it is loaded. That of a function that
// called another one is within the call.
struct CrashTrace {
  std::uint32_t count = 0;
  std::array<std::uint64_t, max_trace> address;
};

// Fills `trace` with the calls that are active in the library which was loaded from `path`. For
// signal handlers: it allocates nothing and takes no lock. But it follows what the crash has left
// of the stack, so it may crash itself or not return; the caller must be ready for both.
void trace_calls(const char* path, CrashTrace& trace);

}  // namespace mirocup::plugins
