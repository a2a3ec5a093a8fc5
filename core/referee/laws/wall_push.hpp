// SPDX-License-Identifier: MIT
//
// Pushing the ball along an end wall. Source: practice of a simulated league that banned it because
// it wastes time. Off unless `wall_push` is set.
//
// Applies when a robot that a team-mate touches shoves the ball along the wall (a defender away
// from the goal, an attacker towards it), or when robots of both teams press on the ball at the
// wall for `wall_s`. The restart is a free ball in the quarter of the ball; for an attacker's
// offence, in the neighbouring quarter across the half line.
#pragma once

#include "core/referee/dwell.hpp"
#include "core/referee/laws/law.hpp"

namespace mirocup::referee {

struct WallPushMemory {
  ByEnd<Dwell> pressed;  // how long both teams have pressed, by the end whose wall it is
};

std::optional<Decision> judge_wall_push(const JudgedField& pitch, const TickFacts& situation,
                                        WallPushMemory& memory);

}  // namespace mirocup::referee
