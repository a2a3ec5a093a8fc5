// SPDX-License-Identifier: MIT
//
// Pushing the ball along an end wall. Source: practice of a simulated league that banned it because
// it wastes time; off unless the parameter is set. Either a robot with a team-mate behind it shoves
// the ball along the wall (a defender away from the goal, an attacker towards it), or robots of
// both teams press on it there for some time. A free ball; for an attacker's offence in the
// mirrored quarter of the other half.
#pragma once

#include "core/referee/dwell.hpp"
#include "core/referee/laws/law.hpp"

namespace mirocup::referee {

struct WallPushMemory {
  ByEnd<Dwell> pressed;  // by the end whose wall it is
};

std::optional<Decision> judge_wall_push(const Pitch& pitch, const Situation& situation,
                                        WallPushMemory& memory);

}  // namespace mirocup::referee
