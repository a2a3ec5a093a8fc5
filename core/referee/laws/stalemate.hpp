// SPDX-License-Identifier: MIT
//
// Stalemate: the ball gets nowhere for 10 s. Sources: MiroSot law 13 (free ball), 12.5 (in a goal
// area: goal kick). "Nowhere" is a window of one robot side around where it was: robots that shake
// the ball do not restart it.
#pragma once

#include "core/referee/laws/law.hpp"

namespace mirocup::referee {

struct StalemateMemory {
  std::optional<Vec2> anchor;  // where the ball was when the count began
  double still_s = 0.0;
};

// Has it been still for the time of the rules?
bool is_stalemate(const Pitch& pitch, const StalemateMemory& memory, double duration);

std::optional<Decision> judge_stalemate(const Pitch& pitch, const Situation& situation,
                                        StalemateMemory& memory);

}  // namespace mirocup::referee
