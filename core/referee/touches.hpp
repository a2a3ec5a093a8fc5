// SPDX-License-Identifier: MIT
//
// Distances between bodies, and which bodies touch.
//
// Two bodies touch in a tick if the physics reported a contact in it, or if they are within
// `touch_m` of each other at its end. So a push across a tiny gap counts as a push.
#pragma once

#include "core/referee/judged_field.hpp"
#include "core/referee/tick_facts.hpp"

namespace mirocup::referee {

// Adds to the situation the touches of all pairs of bodies that are within `touch_m` at its end.
void add_near_touches(const JudgedField& pitch, TickFacts& situation);

// Adds the touch of two different robots, opponents or team-mates, to the sets of both.
void set_touch(TickFacts& situation, const RobotId& a, const RobotId& b);

// Returns the gap between two robots, m. If the gap is larger than `reach`, m, the result may be
// any number above `reach`.
double robot_gap(const JudgedField& pitch, const Pose& a, const Pose& b, double reach);

// Returns the gap between the ball and a robot, m; minus the depth of the overlap if they overlap.
double ball_gap(const JudgedField& pitch, const Vec2& ball, const Pose& robot);

}  // namespace mirocup::referee
