// SPDX-License-Identifier: MIT
//
// The place behind the ball: the middle of a robot that touches the ball on the side away from the
// opponents' goal. From there the robot pushes the ball to the goal.
#pragma once

#include "core/base/vec2.hpp"
#include "core/simulator/model/parameters.hpp"

namespace mirocup::training {

// Returns the distance from the ball to the middle of a robot whose face touches it, m.
inline double pushing_gap(const simulator::Parameters& p) {
  return p.robot_side / 2.0 + p.ball_radius;
}

// Returns the place behind a ball, m. `goal`: the middle of the opponents' goal, in the same frame.
inline Vec2 behind_ball(const Vec2& ball, const Vec2& goal, double gap) {
  const Vec2 shot = goal - ball;
  const double length = shot.norm();
  return length > 0.0 ? Vec2(ball - gap / length * shot) : ball;
}

}  // namespace mirocup::training
