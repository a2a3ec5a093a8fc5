// SPDX-License-Identifier: MIT
//
// Wall time, for what waits for the network.
#pragma once

#include <chrono>

namespace mirocup::dds {

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace mirocup::dds
