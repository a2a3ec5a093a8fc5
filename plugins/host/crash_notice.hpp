// SPDX-License-Identifier: MIT
//
// Reports a team that crashes in the server's own process (--trusted), before the server's process
// dies. In a team's own process fault_report.hpp reports crashes.
#pragma once

#include <cstdint>

namespace mirocup::plugins {

// The call of a team that runs in this process.
struct RunningCall {
  const char* colour = "";
  const char* function = "";
  std::uint32_t tick = 0;
};

// From now on, this process prints a line about the running call before a deadly signal ends it.
// Existing handlers, such as a sanitizer's, stay. Only a program may call this function, not a
// library in another program's process.
void tell_of_crashes();

// Marks a call as running as long as the object lives.
class RunningCallMark {
 public:
  explicit RunningCallMark(const RunningCall& call);
  RunningCallMark(const RunningCallMark&) = delete;
  RunningCallMark& operator=(const RunningCallMark&) = delete;
  ~RunningCallMark();

 private:
  RunningCall call_;
};

}  // namespace mirocup::plugins
