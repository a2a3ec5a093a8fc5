// SPDX-License-Identifier: MIT
//
// Interception: the earliest point of the ball's path that a robot reaches before the ball does.
// The path has rebounds from walls (ball_path.hpp).
//
//   intercept       where and when a robot can meet the ball
//   rough_meeting   the approximate place, at a fraction of the cost
//
// Frames and units are those of strategy.h.
#pragma once

#include "mirocup/skills/ball_path.hpp"

namespace mirocup::strategy {

struct Interception {
  MovingBall ball;       // the ball when the robot meets it
  double seconds = 0.0;  // until the meeting; above `most_s` if the robot is not there in time
  bool is_reached = false;
};

// Returns where a robot that drives at a mean speed of `pace` m/s meets the ball within `most_s`
// seconds. The time for turning and starting is left out: an attacker that allowed for it would aim
// farther ahead, and run past a ball that is within reach. `path` is the path of the ball; make it
// once a tick.
inline Interception intercept(const BallPath& path, const Robot& robot, double pace = 1.2,
                              double most_s = 1.5) {
  const double step = 1.0 / 30.0;                            // s
  const auto late = [&](const MovingBall& ball, double t) {  // s by which the robot comes too late
    return length(ball.at - position(robot)) / pace - t;
  };
  MovingBall ball = path.after(0.0);
  // If the ball rolled straight to the robot, they would meet after `first` s; never earlier.
  const double first = length(ball.at - position(robot)) / (pace + length(ball.velocity));
  double t = math::min(step * std::floor(first / step), most_s);
  ball = path.after(t);
  double gap = late(ball, t);
  for (; t <= most_s; t += step) {
    if (gap <= 0.0) return {ball, t, true};
    const MovingBall next = path.after(t + step);
    const double next_gap = late(next, t + step);
    if (next_gap <= 0.0) {
      const double part = step * gap / (gap - next_gap);  // s, of this step
      return {path.after(t + part), t + part, true};
    }
    ball = next;
    gap = next_gap;
  }
  return {ball, most_s + gap, false};
}

// Like intercept() with a path, for a team that asks once a tick.
inline Interception intercept(const Setup& setup, const Observation& now, const Robot& robot,
                              double pace = 1.2, double most_s = 1.5) {
  return intercept(BallPath(setup, moving_ball(now)), robot, pace, most_s);
}

// Returns the approximate place where a robot that drives at `pace` m/s meets the ball, with at
// most one rebound from a side wall. For teams that ask hundreds of times in a tick.
inline Point rough_meeting(const Setup& setup, const Observation& now, const Robot& robot,
                           double pace = 1.2) {
  const double width = setup.half_width - setup.ball_radius;
  Point p = ball(now);
  for (int i = 0; i < 2; ++i) {
    p = ball_after(now, math::min(length(p - position(robot)) / pace, 0.8));
    if (std::abs(p.y) > width) p.y = std::copysign(2.0 * width - std::abs(p.y), p.y);
  }
  return inside(setup, p, setup.ball_radius);
}

}  // namespace mirocup::strategy
