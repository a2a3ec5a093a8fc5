// SPDX-License-Identifier: MIT
//
// The system calls that a team's process may make (seccomp). A call that is not listed raises
// SIGSYS, whose handler ends the process: the team loses by an illegal call. Calls that honest
// libraries try and can do without return an error instead.
#pragma once

#include "plugins/host/sandbox/file_access.hpp"

#include <chrono>
#include <string>

namespace mirocup::plugins {

// Phase 1 allows enough to load a library and create a team. Phase 2, on top of it, forbids opening
// files, mapping new code and changing the sandbox. Neither can be undone. They return false on
// failure; errno says why.
bool filter_for_loading(Folders folders);
bool filter_for_playing();

// Calls that only loading needs (opening a file, asking for a file, new code) wait for a
// supervisor, the process that holds the descriptor returned here. Once it has closed the
// descriptor, these calls return ENOSYS. So loading ends when the server says so, whatever the
// library does. Returns -1 if the kernel gives no such descriptor, for example inside another
// supervisor's sandbox.
int ask_before_loading();

// In the supervisor: waits at most `patience` for a call and lets it pass.
enum class LoadingStep {
  none,  // no call has come
  more,  // a call that loads
  last,  // the call that a process makes when it has loaded: readiness is near
};
LoadingStep allow_loading_step(int supervisor, std::chrono::milliseconds patience);

// Returns the name of a system call, "kill", or "number 999" if it has none.
std::string system_call_name(int number);

}  // namespace mirocup::plugins
