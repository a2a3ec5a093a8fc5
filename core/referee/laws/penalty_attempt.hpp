// SPDX-License-Identifier: MIT
//
// Penalty attempts: those of a shoot-out, and a penalty kick that is given before a half ends and
// prolongs it.
//
// Source: MiroSot law 7.2: an attempt ends with a goal, when the keeper holds the ball, when the
// ball has been in the goal area and is out again, or after 30 s. Added from practice: it also ends
// when the ball goes back over the half line, or gets nowhere.
#pragma once

#include "core/referee/dwell.hpp"
#include "core/referee/laws/law.hpp"
#include "core/referee/occupancy.hpp"

namespace mirocup::referee {

struct PenaltyAttemptMemory {
  bool is_on = false;
  End taker = End::left;
  double for_s = 0.0;        // since the kick was released
  bool was_in_area = false;  // the ball has been in the goal area
  Dwell held;                // how long the keeper alone has touched the ball
};

// Returns why the attempt is over without a goal, or nothing while it continues. The caller ends
// the attempt.
std::optional<std::string> judge_penalty_attempt(const JudgedField& pitch,
                                                 const TickFacts& situation,
                                                 const Occupancy& occupancy, bool is_stalemate,
                                                 PenaltyAttemptMemory& memory);

}  // namespace mirocup::referee
