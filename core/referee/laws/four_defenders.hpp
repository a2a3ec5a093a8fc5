// SPDX-License-Identifier: MIT
//
// Four defenders in their own penalty area (more than the parameter says). Source: MiroSot laws 8.9
// and 11.4, a penalty kick; the small league has no such area. Counted like two defenders in the
// goal area.
#pragma once

#include "core/referee/crowd.hpp"

namespace mirocup::referee {

struct FourDefendersMemory {
  ByEnd<Dwell> crowded;  // by the end whose penalty area it is
};

// Calls it without the advantage, which is the referee's business.
std::optional<Decision> judge_four_defenders(const Pitch& pitch, const Situation& situation,
                                             const Occupancy& occupancy,
                                             FourDefendersMemory& memory);

}  // namespace mirocup::referee
