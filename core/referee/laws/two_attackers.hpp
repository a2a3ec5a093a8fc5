// SPDX-License-Identifier: MIT
//
// Two attackers in the goal area. Source: MiroSot laws 8.3 and 12.2, a goal kick, at once; a goal
// that falls while they are there does not count. One too many is forgiven for a moment, two are
// not. A robot that was pushed in does not count.
#pragma once

#include "core/referee/crowd.hpp"

namespace mirocup::referee {

struct TwoAttackersMemory {
  ByEnd<Dwell> crowded;  // by the end whose goal area it is
};

// `goal_at`: the goal that the ball crosses in this tick, wherever it came from.
std::optional<Decision> judge_two_attackers(const Pitch& pitch, const Situation& situation,
                                            const Occupancy& occupancy, std::optional<End> goal_at,
                                            TwoAttackersMemory& memory);

}  // namespace mirocup::referee
