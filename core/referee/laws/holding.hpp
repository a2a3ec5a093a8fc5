// SPDX-License-Identifier: MIT
//
// Holding the ball. Sources: MiroSot laws 8.5 and 2.(b)4, a robot may hide at most 30 % of the
// ball.
//
// Applies when the ball is more than `hide_m` inside a robot's outline for `hide_s`. The texts name
// no restart; the call is a free ball. The keeper in its goal area and robot 0 in its penalty area
// are exempt. Square robots cannot hold a ball; a robot in a recorded trace can.
#pragma once

#include "core/referee/dwell.hpp"
#include "core/referee/laws/law.hpp"
#include "core/referee/occupancy.hpp"

#include <array>

namespace mirocup::referee {

struct HoldingMemory {
  ByEnd<std::array<Dwell, max_robots_per_team>> hides;  // how long each robot has hidden the ball
};

// True if the robot touches the ball and hides more of it than the rules allow. The law about the
// keeper's catch also uses it.
bool hides_ball(const JudgedField& pitch, const TickFacts& situation, const RobotId& robot);

std::optional<Decision> judge_holding(const JudgedField& pitch, const TickFacts& situation,
                                      const Occupancy& occupancy, HoldingMemory& memory);

}  // namespace mirocup::referee
