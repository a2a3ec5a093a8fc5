// SPDX-License-Identifier: MIT
//
// Wall time, for code that waits for the network.
#pragma once

#include <chrono>

namespace mirocup::dds {

using WallClock = std::chrono::steady_clock;

inline double seconds_since(WallClock::time_point begin) {
  return std::chrono::duration<double>(WallClock::now() - begin).count();
}

}  // namespace mirocup::dds
