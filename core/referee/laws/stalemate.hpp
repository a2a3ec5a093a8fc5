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

// The quarter of a point, as the signs of its coordinates; 0 counts as negative.
struct Quarter {
  double x = 1.0;
  double y = 1.0;
};
Quarter quarter_of(const Vec2& point);

std::optional<Decision> judge_stalemate(const Pitch& pitch, const Situation& situation,
                                        StalemateMemory& memory);

}  // namespace mirocup::referee
