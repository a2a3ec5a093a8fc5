// SPDX-License-Identifier: MIT
//
// Forks a team's process: as another user, and in tier T2 in separate namespaces.
#pragma once

#include "core/base/error.hpp"
#include "plugins/host/sandbox/isolation.hpp"

#include <functional>
#include <span>
#include <sys/types.h>

namespace mirocup::plugins {

// Forks and calls `run` in the child. `run` must not return, allocate or take locks. When `run` is
// called, the child is not root, even if the server is root. The child dies as soon as the calling
// thread dies. Returns the child's process number. Errors: Errc::unavailable.
Result<pid_t> fork_isolated(Isolation isolation, const std::function<void()>& run);

// In the child. Gives these descriptors the numbers 0, 1, 2 and so on, and closes all others.
// Returns false on failure; errno says why.
bool take_descriptors(std::span<const int> descriptors);

// In the child. Writes the step that failed, with the reason in errno, to a descriptor and ends the
// process.
[[noreturn]] void give_up(int to, const char* step);

}  // namespace mirocup::plugins
