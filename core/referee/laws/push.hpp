// SPDX-License-Identifier: MIT
//
// Pushing an opponent. Source: MiroSot laws 8.1 and 10: by the defending side a free kick; the
// texts name no restart for the attacking side, so that is a free ball, or a goal kick in the goal
// area. Intent is driving at an opponent that does not drive back and moving it, without playing
// the ball. The keeper in its goal area has laws of its own.
#pragma once

#include "core/referee/laws/law.hpp"
#include "core/referee/occupancy.hpp"

#include <array>

namespace mirocup::referee {

// One robot that pushes another.
struct Push {
  bool is_on = false;
  Vec2 from{0.0, 0.0};   // where the pushed one was when it began, m
  double muted_s = 0.0;  // the pair was called
};

struct PushMemory {
  // By pusher and pushed: [index_of(pusher's end)][pusher][pushed].
  ByEnd<std::array<std::array<Push, max_robots_per_team>, max_robots_per_team>> pairs{};
  ByRobot<RobotSet> on{};  // which pairs there are to look at
};

// What follows when one robot pushed another, by which side it was; `reason` says what it did.
Decision call_push(const Pitch& pitch, const Situation& situation, const RobotId& pusher,
                   const RobotId& pushed, std::string reason);

// By the defending side: a free kick, called without the advantage, which is the referee's
// business. By the attacking side: a free ball or a goal kick.
std::optional<Decision> judge_push(const Pitch& pitch, const Situation& situation,
                                   const Occupancy& occupancy, PushMemory& memory);

}  // namespace mirocup::referee
