// SPDX-License-Identifier: MIT
//
// Shooting. A robot is a square without a kicker: the ball leaves at a right angle to the face that
// hits it, from any part of the face. So a shot is straight if the robot's heading is right at the
// touch, and hard if the robot is fast at the touch.
//
//   follow_line   drives along a line, also if the robot is beside it
//   shoot         drives along the line through the ball to a point
//   open_corner   the point in the opponents' goal to aim at
//   run_up        the pose before a shot at a resting ball
//
// Frames and units are those of strategy.h.
#pragma once

#include "mirocup/strategy.hpp"

namespace mirocup::strategy {

// How a robot comes back to a line.
struct LineFollowing {
  double aim_ahead = 0.2;  // m: the robot steers at the point of the line this far ahead
  double gain = 10.0;      // 1/s: rad/s of turn for each rad of error
  double lead_s = 0.08;    // s: a turn continues for this time after a command
};

// Drives along the line through `point` with direction `heading` (rad) at `speed` m/s, forwards or
// backwards. A robot beside the line comes back to it.
inline Wheels follow_line(const Setup& setup, const Robot& robot, Point point, double heading,
                          double speed, const LineFollowing& how = {}) {
  const Point along{math::cos(heading), math::sin(heading)};
  const Point from = position(robot) - point;
  const double aside = along.x * from.y - along.y * from.x;
  const double soon = robot.heading + how.lead_s * robot.turn;
  double error = wrapped(heading - math::atan2(aside, how.aim_ahead) - soon);
  double direction = 1.0;
  if (std::abs(error) > pi / 2.0) {
    error = wrapped(error + pi);
    direction = -1.0;
  }
  const double turn = how.gain * error;
  double forward = speed * math::max(0.1, math::cos(error));
  const double steady = 0.8 * setup.grip * 9.81;  // sliding wheels do not steer, m/s^2
  if (std::abs(forward * turn) > steady) forward = steady / std::abs(turn);
  return wheels_for(setup, direction * forward, turn);
}

// Drives through a ball so that the ball goes to `aim`. Precondition: seen from `aim`, the robot is
// behind the ball. `speed` is in m/s.
inline Wheels shoot(const Setup& setup, const Robot& robot, Point ball, Point aim,
                    double speed = 1.8) {
  const Point to = aim - ball;
  return follow_line(setup, robot, ball, math::atan2(to.y, to.x), speed);
}

// Returns the point on the opponents' goal line to aim at: near the post that the opponent nearest
// to that line leaves open. `margin`: distance of the ball inside the post, m. `y_bias` is added to
// that opponent's y, m, and decides the corner if the opponent stands in the middle.
inline Point open_corner(const Setup& setup, const Observation& now, double margin = 0.05,
                         double y_bias = 0.0) {
  double farthest = -2.0 * setup.half_length;
  double keeper_y = 0.0;
  for (int i = 0; i < now.robots; ++i) {
    if (now.opponent[i].x <= farthest) continue;
    farthest = now.opponent[i].x;
    keeper_y = now.opponent[i].y;
  }
  const double corner = setup.goal_half_width - margin;
  return {setup.half_length, keeper_y + y_bias > 0.0 ? -corner : corner};
}

// Returns the pose from which a robot shoots a ball that rests at `ball` to `aim`: on the line of
// the shot, `distance` (m) behind the ball, so that the robot is fast when it hits the ball.
inline mirocup_pose run_up(Point ball, Point aim, double distance = 0.2) {
  const Point along = unit(aim - ball);
  const Point place = ball - distance * along;
  return {place.x, place.y, math::atan2(along.y, along.x)};
}

// True while the ball of your own penalty or free kick still lies at `spot`, where it was put.
inline bool must_take_kick(const Observation& now, Point spot) {
  const bool is_kick = now.restart == MIROCUP_PENALTY_KICK || now.restart == MIROCUP_FREE_KICK;
  return is_kick && now.own_restart != 0 && length(ball(now) - spot) < 0.01;
}

}  // namespace mirocup::strategy
