// SPDX-License-Identifier: MIT
//
// Does a recording tell what happened? The simulator and the referee play it again from the
// commands alone.
#pragma once

#include "core/replay/playback.hpp"

#include <optional>

namespace mirocup::replay {

// Nothing if every hash, decision and the result are reproduced.
std::optional<Divergence> verify(const Recording& recording);

}  // namespace mirocup::replay
