// SPDX-License-Identifier: MIT
//
// Does a recording tell what happened? The simulator and the referee play it again from the
// commands alone.
#pragma once

#include "core/replay/recording.hpp"

#include <optional>
#include <string>

namespace mirocup::replay {

// The first thing in which the recording and its replay differ.
struct Divergence {
  std::uint32_t tick = 0;
  std::string what;  // a sentence with both values
};

// Nothing if every hash, decision and the result are reproduced.
std::optional<Divergence> verify(const Recording& recording);

}  // namespace mirocup::replay
