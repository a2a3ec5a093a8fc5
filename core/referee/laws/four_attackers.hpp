// SPDX-License-Identifier: MIT
//
// Four attackers in the penalty area. Source: practice of simulated leagues, a goal kick; off where
// the parameter is 0. Judged like two attackers in the goal area.
#pragma once

#include "core/referee/crowd.hpp"

namespace mirocup::referee {

struct FourAttackersMemory {
  ByEnd<Dwell> crowded;  // by the end whose penalty area it is
};

// `goal_at`: the goal that the ball crosses in this tick, wherever it came from.
std::optional<Decision> judge_four_attackers(const Pitch& pitch, const Situation& situation,
                                             const Occupancy& occupancy, std::optional<End> goal_at,
                                             FourAttackersMemory& memory);

}  // namespace mirocup::referee
