// SPDX-License-Identifier: MIT
//
// The system calls that a team's process may make. What is not listed raises SIGSYS, whose handler
// ends the process: the team loses by an illegal call. Calls that honest libraries try and can do
// without are answered with an error instead.
#pragma once

#include <string>

namespace mirocup::plugins {

// Phase 1: enough to load a library and create a team. Phase 2, on top of it: no opening of files,
// no new code, no change of the sandbox. Both last. False: errno says why.
bool filter_for_loading();
bool filter_for_playing();

// The name of a system call by its number: "kill"; or "number 999".
std::string system_call_name(int number);

}  // namespace mirocup::plugins
