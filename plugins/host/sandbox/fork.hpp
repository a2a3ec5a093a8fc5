// SPDX-License-Identifier: MIT
//
// The fork that a team's process starts with: as another user, and in tier T2 in namespaces of its
// own.
#pragma once

#include "core/base/error.hpp"
#include "plugins/host/sandbox/isolation.hpp"

#include <functional>
#include <sys/types.h>

namespace mirocup::plugins {

// Forks; `run` is called in the child and must not return, allocate or take locks. The child dies
// with the thread that called. Errors: Errc::unavailable.
Result<pid_t> fork_isolated(Isolation isolation, const std::function<void()>& run);

// In the child: stops being the server's user, if that is root, and dies with the parent from here
// on. False: errno says why.
bool become_inner_user();  // T2: the only user of its namespace
bool become_other_user();  // T1

}  // namespace mirocup::plugins
