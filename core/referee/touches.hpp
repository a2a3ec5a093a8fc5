// SPDX-License-Identifier: MIT
//
// Distances between bodies, and which bodies touch.
//
// Two bodies touch in a tick if the physics reported a contact in it, or if they are within
// `touch_m` of each other at its end. So a push across a tiny gap counts as a push.
#pragma once

#include "core/referee/pitch.hpp"
#include "core/referee/situation.hpp"

namespace mirocup::referee {

// Adds to the situation the touches of all pairs of bodies that are within `touch_m` at its end.
void add_near_touches(const Pitch& pitch, Situation& situation);

// Adds the touch of two different robots, opponents or team-mates, to the sets of both.
void set_touch(Situation& situation, const RobotId& a, const RobotId& b);

// Returns the gap between two robots, m. If the gap is larger than `reach`, m, the result may be
// any number above `reach`.
double robot_gap(const Pitch& pitch, const Pose& a, const Pose& b, double reach);

// Returns the gap between the ball and a robot, m; minus the depth of the overlap if they overlap.
double ball_gap(const Pitch& pitch, const Vec2& ball, const Pose& robot);

}  // namespace mirocup::referee
