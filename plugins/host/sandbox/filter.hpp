// SPDX-License-Identifier: MIT
//
// The system calls that a team's process may make (seccomp). A call that is not listed raises
// SIGSYS, whose handler ends the process: the team loses by an illegal call. A call that honest
// libraries try, but do not need, returns an error instead.
#pragma once

#include "plugins/host/sandbox/file_access.hpp"

#include <chrono>
#include <string>

namespace mirocup::plugins {

// filter_for_loading() allows enough to load a library and create a team. After this,
// filter_for_playing() also forbids opening files, mapping new code and changing the sandbox.
// Neither can be undone. Both return false on failure; errno says why.
bool filter_for_loading(Folders folders);
bool filter_for_playing();

// From now on, calls that only loading needs (opening a file, asking about a file, new code) wait
// for a supervisor, the process that holds the returned descriptor. Once the supervisor has closed
// the descriptor, such calls return ENOSYS. So the server decides when loading ends, whatever the
// library does. Returns -1 if the kernel gives no such descriptor, for example inside another
// supervisor's sandbox.
int ask_before_loading();

// What allow_loading_step() saw.
enum class LoadingStep {
  none,  // no call has come
  more,  // a call came, and further calls of loading will come
  last,  // the last call of loading came: the process is nearly ready
};
// For the supervisor: waits at most `patience` for a system call of the process that loads, and
// lets the call pass.
LoadingStep allow_loading_step(int supervisor, std::chrono::milliseconds patience);

// Returns the name of a system call, for example "kill"; if call 999 has no name, "number 999".
std::string system_call_name(int number);

}  // namespace mirocup::plugins
