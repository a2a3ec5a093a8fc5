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

// Forks; `run` is called in the child and must not return, allocate or take locks. There the child
// is no longer the server's user, if that is root, and dies with the thread that called, whenever
// that dies. Errors: Errc::unavailable.
Result<pid_t> fork_isolated(Isolation isolation, const std::function<void()>& run);

}  // namespace mirocup::plugins
