// SPDX-License-Identifier: MIT
//
// Holding the ball. Source: MiroSot laws 8.5 and 2.(b)4: a robot hides at most 30 % of the ball.
// Measured as the depth of the ball inside the robot's outline, for some time. The texts name no
// restart: a free ball. The keeper in its goal or penalty area is exempt. Square robots can never
// do it; a filmed one can.
#pragma once

#include "core/referee/dwell.hpp"
#include "core/referee/laws/law.hpp"
#include "core/referee/occupancy.hpp"

#include <array>

namespace mirocup::referee {

struct HoldingMemory {
  ByEnd<std::array<Dwell, max_robots_per_team>> hides;
};

// How deep the ball is inside each robot's outline counts for this law and for the keeper's catch.
bool hides_ball(const Pitch& pitch, const Situation& situation, const RobotId& robot);

std::optional<Decision> judge_holding(const Pitch& pitch, const Situation& situation,
                                      const Occupancy& occupancy, HoldingMemory& memory);

}  // namespace mirocup::referee
