// SPDX-License-Identifier: MIT
//
// The system calls that a team's process may make (seccomp). A call that is not listed raises
// SIGSYS, whose handler ends the process: the team loses by an illegal call. Calls that honest
// libraries try and can do without return an error instead.
#pragma once

#include <string>

namespace mirocup::plugins {

// Phase 1 allows enough to load a library and create a team. Phase 2, on top of it, forbids opening
// files, mapping new code and changing the sandbox. Neither can be undone. They return false on
// failure; errno says why.
bool filter_for_loading();
bool filter_for_playing();

// Returns the name of a system call, "kill", or "number 999" if it has none.
std::string system_call_name(int number);

}  // namespace mirocup::plugins
