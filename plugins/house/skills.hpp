// SPDX-License-Identifier: MIT
//
// What the house teams do alike: keep the goal, kick off, go home without taking the ball along.
#pragma once

#include "mirocup/strategy.hpp"

namespace house {

// Is the ball still on the spot of a kick-off of ours? It has to go backwards first.
inline bool must_kick_off(const mirocup_observation& now) {
  return now.restart == MIROCUP_KICK_OFF && now.own_restart != 0 &&
         std::hypot(now.ball_x, now.ball_y) < 0.055;
}

// Nudges it home and aside, so slowly that it does not roll to the own goal.
inline mirocup_wheels kick_off(const mirocup_setup& setup, const mirocup_robot& robot) {
  return mirocup::strategy::drive_to(setup, robot, {-0.2, 0.1}, 0.2, 0.2);
}

// Drives to a point, and round the ball if that is in the way: a robot on its way home must not
// push it there.
inline mirocup_wheels drive_clear(const mirocup_setup& setup, const mirocup_observation& now,
                                  const mirocup_robot& robot, mirocup::strategy::Point target,
                                  double arrival = 0.0, double fastest = 1.5) {
  using namespace mirocup::strategy;
  const double berth = 0.11;
  const Point here = position(robot);
  const Point way = target - here;
  const Point to_ball = ball(now) - here;
  const Point along = unit(way);
  const double ahead = dot(to_ball, along);
  const double aside = along.x * to_ball.y - along.y * to_ball.x;
  if (ahead <= 0.0 || ahead >= length(way) || std::abs(aside) >= berth) {
    return drive_to(setup, robot, target, arrival, fastest);
  }
  // Too near to turn past it: back off first.
  if (length(to_ball) < 0.115)
    return drive_to(setup, robot, here - 0.1 * unit(to_ball), 0.0, fastest);
  const double side = aside > 0.0 ? -1.0 : 1.0;
  const Point beside = ball(now) + (side * berth * 1.2) * Point{-along.y, along.x};
  return drive_to(setup, robot, beside, 0.3, std::min(fastest, 0.9));
}

// Stays on a line before the goal where the ball will cross it, and kicks out what lies near.
inline mirocup_wheels keep_goal(const mirocup_setup& setup, const mirocup_observation& now,
                                const mirocup_robot& robot) {
  using namespace mirocup::strategy;
  const double line = -setup.half_length + 0.055;
  const Point here = position(robot);
  const Point away = ball(now) - here;

  const bool is_slow = length(ball_velocity(now)) < 0.4;
  const bool is_in_reach = now.ball_x > here.x + 0.02 && length(away) < 0.16 &&
                           now.ball_x < -setup.half_length + setup.goal_area_depth + 0.02;
  if (is_slow && is_in_reach) return drive_to(setup, robot, ball(now) + 0.2 * unit(away), 1.0);

  // Where the ball will cross the line, if it comes.
  double y = now.ball_y;
  if (now.ball_vx < -0.1) {
    const double seconds = (line - now.ball_x) / now.ball_vx;
    if (seconds > 0.0 && seconds < 1.5) y = now.ball_y + now.ball_vy * seconds;
  }
  const double reach = setup.goal_half_width - 0.02;
  const Point post{line, std::clamp(y, -reach, reach)};
  if (length(post - here) < 0.01)
    return turn_to(setup, robot, robot.heading > 0.0 ? pi / 2.0 : -pi / 2.0);
  return drive_clear(setup, now, robot, post);
}

}  // namespace house
