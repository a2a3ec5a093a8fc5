// SPDX-License-Identifier: MIT
//
// Getting a ball free that is stuck: between two robots, at a wall, in a corner. A robot beside it
// spins, and its corner throws the ball along; a robot farther off drives at it.
//
//        wall                 wall
//     ==========           ==========
//         o                    o--->       clockwise below the ball: to the right
//       +---+                 /\           counter-clockwise: to the left
//       |   |     ->         /  \          .
//       +---+                \  /
//                             \/
//
//   is_stuck     whether the ball has been stuck for long enough
//   spin_ball    throws the ball in a direction, or nearly
//   free_ball    drives at the ball, then spins
//
// Frames and units are those of strategy.h.
#pragma once

#include "mirocup/skills/drive.hpp"

namespace mirocup::strategy {

struct StuckBall {
  double patience = 0.6;  // s, without progress, until something is done
  double slow = 0.15;     // m/s
  double reach = 0.085;   // m, from the middle of the robot: near enough to spin
  double spin = 30.0;     // rad/s
};

inline bool is_stuck(const Observation& now, const StuckBall& how = {}) {
  return now.stalemate_s > how.patience && length(ball_velocity(now)) < how.slow;
}

// Spins so that a ball beside the robot flies off in a direction, or at a right angle to its face
// on the side of that direction.
inline Wheels spin_ball(const Setup& setup, const Robot& robot, Point ball, Point direction,
                        const StuckBall& how = {}) {
  const Point to = ball - position(robot);
  const double left = to.x * direction.y - to.y * direction.x;  // > 0: counter-clockwise
  return wheels_turning_first(setup, 0.0, left > 0.0 ? how.spin : -how.spin);
}

// Returns where a stuck ball should go: out of the own half, along its walls; in the opponents' half
// before their goal.
inline Point way_out(const Setup& setup, Point ball) {
  if (ball.x > 0.3 * setup.half_length) {
    return unit(Point{setup.half_length - 0.18, 0.0} - ball);
  }
  if (ball.x < -setup.half_length + 0.06) return {0.3, ball.y < 0.0 ? -1.0 : 1.0};
  return {1.0, 0.0};
}

inline Wheels free_ball(const Setup& setup, const Observation& now, const Robot& robot,
                        const StuckBall& how = {}) {
  const Point to = ball(now) - position(robot);
  if (length(to) < how.reach) {
    return spin_ball(setup, robot, ball(now), way_out(setup, ball(now)), how);
  }
  return drive_quickly(setup, robot, ball(now), 0.6, 1.2);
}

}  // namespace mirocup::strategy
