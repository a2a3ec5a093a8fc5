// SPDX-License-Identifier: MIT
//
// The kick-off goes backwards. Source: MiroSot law 6.2, the ball is kicked towards the own side
// first; the text names no sanction, so the kick-off passes to the opponents, as for one that is
// not taken in time.
#pragma once

#include "core/referee/laws/law.hpp"

namespace mirocup::referee {

struct KickOffMemory {
  bool is_pending = false;  // a kick-off was given and the ball has not moved off its spot
  bool was_touched = false;
  End taker = End::left;
  Vec2 spot{0.0, 0.0};
  double waited_s = 0.0;
};

std::optional<Decision> judge_kick_off(const Pitch& pitch, const Situation& situation,
                                       KickOffMemory& memory);

}  // namespace mirocup::referee
