// SPDX-License-Identifier: MIT
//
// What a team's process may use of the machine.
#pragma once

#include <cstddef>

namespace mirocup::plugins {

inline constexpr std::size_t max_memory = std::size_t{1} << 30;  // bytes of addresses

// Sets the resource limits of this process; no new privileges from here on; nobody may look into
// it; it dies with its parent. False: errno says why.
bool limit_this_process();

}  // namespace mirocup::plugins
