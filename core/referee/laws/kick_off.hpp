// SPDX-License-Identifier: MIT
//
// The kick-off goes backwards. Source: MiroSot law 6.2: the ball is kicked towards the taker's own
// side first.
//
// The text names no sanction. A kick-off that goes forward passes to the opponents, as does a
// kick-off that is not taken within `kickoff_limit_s`. The side is judged where the ball is first
// `kickoff_move_m` from its spot.
#pragma once

#include "core/referee/laws/law.hpp"

namespace mirocup::referee {

struct KickOffMemory {
  bool is_pending = false;   // a kick-off was given and its side has not been judged yet
  bool was_touched = false;  // by any robot
  End taker = End::left;
  Vec2 spot{0.0, 0.0};
  double waited_s = 0.0;  // since play was released
};

std::optional<Decision> judge_kick_off(const JudgedField& pitch, const TickFacts& situation,
                                       KickOffMemory& memory);

}  // namespace mirocup::referee
