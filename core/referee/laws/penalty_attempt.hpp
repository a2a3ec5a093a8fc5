// SPDX-License-Identifier: MIT
//
// A penalty attempt: of a shoot-out, or a penalty kick that is awarded before a half ends and
// prolongs it. Source: MiroSot law 7.2: it ends with a goal, when the keeper holds the ball, when
// the ball has been in the goal area and is out again, or after 30 s; added, with practice: when
// the ball goes back over the half line, or gets nowhere.
#pragma once

#include "core/referee/dwell.hpp"
#include "core/referee/laws/law.hpp"
#include "core/referee/occupancy.hpp"

namespace mirocup::referee {

struct PenaltyAttemptMemory {
  bool is_on = false;
  End taker = End::left;
  double for_s = 0.0;
  bool was_in_area = false;
  Dwell held;
};

// Why the attempt is over without a goal, or nothing. Does not end it.
std::optional<std::string> judge_penalty_attempt(const Pitch& pitch, const Situation& situation,
                                                 const Occupancy& occupancy, bool is_stalemate,
                                                 PenaltyAttemptMemory& memory);

}  // namespace mirocup::referee
