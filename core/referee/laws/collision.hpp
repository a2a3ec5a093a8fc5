// SPDX-License-Identifier: MIT
//
// A dangerous collision. Source: MiroSot law 8.1, "potential to harm"; simulated robots do not
// break, so it is off unless the parameter is set: two robots meet faster than that and one is
// clearly the faster. It is only noted, or, where a second parameter says so, called like a push by
// the faster one.
#pragma once

#include "core/referee/laws/push.hpp"

#include <array>

namespace mirocup::referee {

struct CollisionMemory {
  ByRobot<double> muted_s{};  // after a robot was noted
  ByRobot<RobotSet> touched;  // in the last tick
};

std::optional<Decision> judge_collision(const Pitch& pitch, const Situation& situation,
                                        CollisionMemory& memory);

}  // namespace mirocup::referee
