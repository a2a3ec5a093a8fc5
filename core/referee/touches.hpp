// SPDX-License-Identifier: MIT
//
// Who is how near to whom. A contact counts if the physics reported it in the tick or if the bodies
// are within the touching distance at its end, so that pushing with a hair's gap is pushing.
#pragma once

#include "core/referee/pitch.hpp"
#include "core/referee/situation.hpp"

namespace mirocup::referee {

// Adds the touches of all pairs that are within the rules' touching distance.
void add_near_touches(const Pitch& pitch, Situation& situation);

// Two opponents touched: both sets.
void set_touch(Situation& situation, const RobotId& a, const RobotId& b);

// The gap between two robots, m; exact up to `reach`, anything larger beyond.
double robot_gap(const Pitch& pitch, const Pose& a, const Pose& b, double reach);

// The gap between the ball and a robot, m; negative by the depth inside it.
double ball_gap(const Pitch& pitch, const Vec2& ball, const Pose& robot);

}  // namespace mirocup::referee
