// SPDX-License-Identifier: MIT
//
// The resource limits of a team's process.
#pragma once

#include "system/memory.hpp"

namespace mirocup::plugins {

inline constexpr std::size_t max_memory = system::memory_of_a_team;  // bytes of address space

// Limits the resources of this process. From now on this process cannot gain privileges, no other
// process can trace it, and it dies with its parent. Returns false on failure; errno says why.
bool limit_this_process();

}  // namespace mirocup::plugins
