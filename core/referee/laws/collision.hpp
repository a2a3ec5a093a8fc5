// SPDX-License-Identifier: MIT
//
// Dangerous collisions. Source: MiroSot law 8.1, "potential to harm".
//
// Simulated robots do not break, so the law is off unless `collision_mps` is set. It applies when
// two opponents start to touch, approach each other at more than that speed, and one of them is
// faster than the other by more than `collision_differ_mps`. The collision is only noted or, with
// `collision_foul`, called like a push by the faster robot.
#pragma once

#include "core/referee/laws/push.hpp"

#include <array>

namespace mirocup::referee {

struct CollisionMemory {
  ByRobot<double> muted_s{};  // time for which a robot is not called again, s
  ByRobot<RobotSet> touched;  // the opponents that each robot touched in the last tick
};

// Finds at most one collision in a tick. If several robots of the left end collide, the collision
// of the robot with the lowest index counts.
std::optional<Decision> judge_collision(const JudgedField& pitch, const TickFacts& situation,
                                        CollisionMemory& memory);

}  // namespace mirocup::referee
